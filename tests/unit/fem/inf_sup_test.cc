#include <gtest/gtest.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fem/elasticity/elasticity.h"
#include "mesh/dense_algebra.h"
#include "tests/unit/fem/discretisation.h"

/// The numerical inf-sup test (D. Chapelle and K.-J. Bathe, The inf-sup test, Computers and
/// Structures 47, 1993) of the cells with their incompatible modes.
///
/// A nearly incompressible cell resists by its mean dilatation alone: its stiffness is
/// lambda b b^T. So the pressure is one value per cell, and the constant is the root of the least
/// eigenvalue of B A^-1 B^T, A being the stiffness without lambda, and the rows of B the cells' b.
/// A body that is held all round has the uniform pressure with the eigenvalue 0.
///
/// Of all such pressures the constant falls with the cells' size: the four children of a cell can
/// alternate. It is bounded for those without this alternation, which is why displacements converge
/// on meshes that are refined by halving, and pressures that are averaged, too (J. Pitkaranta and
/// R. Stenberg, Error bounds for the approximation of the Stokes problem using bilinear/constant
/// elements on irregular quadrilateral meshes, 1985).
namespace geneva::fem::test {
namespace {

using dealii::Point;
using dealii::Tensor;

/// The unit square of four cells, with its middle nodes moved.
mesh::MeshData<2> square(const bool is_distorted) {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_rectangle(mesh, "square", {0., 0.5, 1.}, {0., 0.5, 1.}, {"", "", "", ""});
  if (!is_distorted) return mesh;
  for (auto& vertex : mesh.vertices) {
    const double x = vertex[0];
    const double y = vertex[1];
    vertex[0] += 0.4 * x * (1. - x) * (0.6 - y);
    vertex[1] += 0.5 * y * (1. - y) * (x - 0.4);
  }
  return mesh;
}

/// The constants of one mesh.
struct Constants {
  double of_all;          ///< pressures but the uniform one
  double of_macro_cells;  ///< of those without alternation among the children of a cell
};

class InfSup {
 public:
  InfSup(const PlaneKind plane, const bool is_distorted, const unsigned int refinements)
      : plane_(plane), mesh_(square(is_distorted)), grid_(mesh_, refinements) {
    number_free_unknowns();
    assemble();
  }

  [[nodiscard]] Constants constants() const {
    const Eigen::MatrixXd schur = b_ * a_.llt().solve(b_.transpose());
    const Eigen::MatrixXd filter = without_alternation();
    return {second_root(schur), second_root(filter.transpose() * schur * filter)};
  }

 private:
  /// Root of the second eigenvalue: the first is that of the uniform pressure.
  static double second_root(const Eigen::MatrixXd& matrix) {
    return std::sqrt(std::abs(mesh::symmetric_eigenpairs(matrix).values(1)));
  }

  [[nodiscard]] Problem<2> problem(const double nu) const {
    Problem<2> result;
    result.plane = plane_;
    result.bodies.push_back({"square", {2., nu}, {}});
    return result;
  }

  [[nodiscard]] bool is_free(const Point<2>& x, const unsigned int component) const {
    const auto is_end = [](const double value) { return value < 1e-12 || value > 1. - 1e-12; };
    const bool is_on_axis = plane_ == PlaneKind::axisymmetric && x[0] < 1e-12;
    return !is_end(x[1]) && (!is_end(x[0]) || (is_on_axis && component == 1));
  }

  void number_free_unknowns() {
    numbers_.assign(grid_.dof_handler->n_dofs(), -1);
    for (const auto& cell : grid_.dof_handler->active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int c = 0; c < 2; ++c)
          if (int& number = numbers_[cell->vertex_dof_index(v, c)];
              number < 0 && is_free(cell->vertex(v), c))
            number = n_free_++;
  }

  void assemble() {
    constexpr double nu = 0.5 - 1e-9;
    const auto soft = all_systems(*grid_.dof_handler, problem(0.), mesh_.surfaces);
    const auto stiff = all_systems(*grid_.dof_handler, problem(nu), mesh_.surfaces);
    const double lambda = lame({2., nu}, plane_).lambda;
    a_ = Eigen::MatrixXd::Zero(n_free_, n_free_);
    b_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(stiff.size()), n_free_);
    Eigen::Index row = 0;
    for (const auto& cell : grid_.dof_handler->active_cell_iterators()) {
      const CellSystem& system = soft[static_cast<std::size_t>(row)];
      const Eigen::VectorXd dilatation =
          mean_dilatation(cell, stiff[static_cast<std::size_t>(row)], lambda);
      for (unsigned int i = 0; i < 8; ++i) {
        const int number = numbers_[system.dofs[i]];
        if (number < 0) continue;
        b_(row, number) += dilatation(i);
        for (unsigned int j = 0; j < 8; ++j)
          if (const int other = numbers_[system.dofs[j]]; other >= 0)
            a_(number, other) += system.stiffness(i, j);
      }
      ++row;
    }
  }

  /// b, and with the displacement x, whose dilatation is 2 or 3, the root of the cell's volume.
  template <typename Cell>
  Eigen::VectorXd mean_dilatation(const Cell& cell, const CellSystem& system, const double lambda) {
    Eigen::MatrixXd stiffness(8, 8);
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int j = 0; j < 8; ++j) stiffness(i, j) = system.stiffness(i, j) / lambda;
    const auto pairs = mesh::symmetric_eigenpairs(stiffness);
    Eigen::VectorXd b = std::sqrt(pairs.values(7)) * pairs.vectors.col(7);
    const dealii::Vector<double> position =
        values_on(cell, Field<2>([](const Point<2>& x) { return Tensor<1, 2>(x); }));
    double product = 0.;
    for (unsigned int i = 0; i < 8; ++i) product += b(i) * position[i];
    if (product < 0.) b = -b;
    roots_.push_back(std::abs(product) / (plane_ == PlaneKind::axisymmetric ? 3. : 2.));
    return b;
  }

  /// An orthonormal basis of the pressures, times the roots of the volumes, that do not alternate.
  [[nodiscard]] Eigen::MatrixXd without_alternation() const {
    const std::array<std::array<double, 4>, 3> shapes{
        {{1., 1., 1., 1.}, {1., -1., 1., -1.}, {1., 1., -1., -1.}}};
    const Eigen::Index n_cells = b_.rows();
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(n_cells, n_cells * 3 / 4);
    std::vector<dealii::DoFHandler<2>::cell_iterator> parents;
    Eigen::Index row = 0;
    for (const auto& cell : grid_.dof_handler->active_cell_iterators()) {
      const auto parent = cell->parent();
      const auto place = std::find(parents.begin(), parents.end(), parent) - parents.begin();
      if (static_cast<std::size_t>(place) == parents.size()) parents.push_back(parent);
      for (unsigned int child = 0; child < 4; ++child)
        if (parent->child(child) == cell)
          for (std::size_t shape = 0; shape < 3; ++shape)
            basis(row, 3 * place + static_cast<Eigen::Index>(shape)) =
                shapes[shape][child] * roots_[static_cast<std::size_t>(row)];
      ++row;
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> factors(basis);
    return factors.householderQ() * Eigen::MatrixXd::Identity(n_cells, basis.cols());
  }

  PlaneKind plane_;
  mesh::MeshData<2> mesh_;
  Discretisation<2> grid_;
  std::vector<int> numbers_;
  int n_free_ = 0;
  Eigen::MatrixXd a_;
  Eigen::MatrixXd b_;
  std::vector<double> roots_;
};

TEST(InfSup, ConstantOfMacroCellsIsBounded) {
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    GTEST_SKIP() << "dense matrices of the whole mesh";
  for (const PlaneKind plane : {PlaneKind::plane_strain, PlaneKind::axisymmetric})
    for (const bool is_distorted : {false, true}) {
      for (const unsigned int refinements : {1U, 2U, 3U}) {
        const Constants constants = InfSup(plane, is_distorted, refinements).constants();
        EXPECT_NEAR(constants.of_macro_cells, 0.42, 0.02) << refinements << is_distorted;
        EXPECT_LT(constants.of_all, constants.of_macro_cells) << "alternating pressures";
      }
    }
}

}  // namespace
}  // namespace geneva::fem::test
