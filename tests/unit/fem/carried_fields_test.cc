#include "fem/elasticity/material_history.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "fem/discretisation/refined_mesh.h"
#include "tests/support/structured_mesh.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;
using geneva::test::add_rectangle;
using geneva::test::equal_steps;

/// Remembers the largest strain along x that it has seen.
class WithMemory : public MaterialLaw<2> {
 public:
  [[nodiscard]] MaterialResponse<2> respond(const StressVector<2>& strain,
                                            const MaterialHistory& before) const override {
    return {strain, Tangent<2>::Identity(), {std::max(strain[0], before.empty() ? 0. : before[0])}};
  }
  [[nodiscard]] bool remembers() const override { return true; }
};

/// Two bodies, of which only the left one remembers.
class TwoBodies : public ::testing::Test {
 protected:
  TwoBodies() {
    laws.push_back(std::make_unique<WithMemory>());
    laws.push_back(std::make_unique<LinearElastic<2>>(Material{1., 0.3}, PlaneKind::plane_strain));
    problem.bodies.push_back({"left", {1., 0.3}, {}});
    problem.bodies.push_back({"right", {1., 0.3}, {}});
  }

  static mesh::MeshData<2> coarse() {
    mesh::MeshData<2> mesh = geneva::test::empty_mesh();
    add_rectangle(mesh, "left", equal_steps(0., 1., 6), equal_steps(0., 1., 6), {"", "", "", ""});
    add_rectangle(mesh, "right", equal_steps(2., 3., 6), equal_steps(0., 1., 6), {"", "", "", ""});
    return mesh;
  }

  /// u_x = factor x^2/2, whose strain along x is factor x in the middle of each cell.
  [[nodiscard]] Vector stretched(const double factor) const {
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(*mesh.dof_handler, relevant);
    Vector result(mesh.dof_handler->locally_owned_dofs(), relevant, MPI_COMM_WORLD);
    for (const auto& cell : mesh.dof_handler->active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int vertex : cell->vertex_indices())
          result(cell->vertex_dof_index(vertex, 0)) =
              factor * cell->vertex(vertex)[0] * cell->vertex(vertex)[0] / 2.;
    result.compress(dealii::VectorOperation::insert);
    result.update_ghost_values();
    return result;
  }

  [[nodiscard]] PointValues after(const double factor, const PointValues& before) const {
    return remembered(*mesh.dof_handler, problem, laws, stretched(factor), before);
  }

  /// Calls check(cell, values) for this rank's cells of the body that remembers.
  template <typename Check>
  void visit(const PointValues& values, const Check& check) const {
    for (const auto& cell : mesh.dof_handler->active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      const auto& of_cell = values.at(cell->active_cell_index());
      if (cell->material_id() == 0)
        check(cell, of_cell);
      else
        EXPECT_TRUE(of_cell.empty());
    }
  }

  RefinedMesh<2> mesh{MPI_COMM_WORLD, coarse(), 1.};
  Problem<2> problem;
  MaterialLaws<2> laws;
};

TEST_F(TwoBodies, RememberTheInstantsBeforeAtEachPoint) {
  const PointValues first = after(1., {});
  const PointValues second = after(0.5, first);
  const PointValues third = after(2., second);
  visit(first, [](const auto& cell, const auto& values) {
    ASSERT_EQ(values.size(), 4U);
    for (const auto& value : values) EXPECT_NEAR(value.at(0), cell->center()[0], 1e-12);
  });
  EXPECT_EQ(second, first);
  visit(third, [](const auto& cell, const auto& values) {
    for (const auto& value : values) EXPECT_NEAR(value.at(0), 2. * cell->center()[0], 1e-12);
  });
}

TEST_F(TwoBodies, RememberNothingWithoutALawThatDoes) {
  EXPECT_TRUE(
      remembered(*mesh.dof_handler, problem, material_laws(problem), stretched(1.), {}).empty());
}

/// The Gauss point of the coarse cells, six in a unit of length, that is nearest to the middle of a
/// child.
double nearest_of_coarse_cell(const double middle) {
  const double size = 1. / 6.;
  const double centre = (std::floor(middle / size) + 0.5) * size;
  return centre + (middle > centre ? 0.5 : -0.5) * size / std::sqrt(3.);
}

/// What is remembered is the place of each point. Only the lower cells are refined, so that cells
/// move between the ranks.
TEST_F(TwoBodies, CarryWhatTheyRememberToFinerMeshes) {
  dealii::FEValues<2> points(*mesh.element, dealii::QGauss<2>(2), dealii::update_quadrature_points);
  PointValues places(mesh.triangulation->n_active_cells());
  for (const auto& cell : mesh.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->material_id() != 0) continue;
    points.reinit(cell);
    for (const Point<2>& point : points.get_quadrature_points())
      places[cell->active_cell_index()].push_back({point[0], point[1]});
    if (cell->center()[1] < 0.5) cell->set_refine_flag();
  }
  const PointValues carried = mesh.refine({stretched(1.), places}).history;
  unsigned int n_finer = 0;
  visit(carried, [&](const auto& cell, const auto& values) {
    ASSERT_EQ(values.size(), 4U);
    points.reinit(cell);
    const bool is_finer = cell->level() > 0;
    if (is_finer) ++n_finer;
    for (const unsigned int q : points.quadrature_point_indices())
      for (unsigned int axis = 0; axis < 2; ++axis)
        EXPECT_NEAR(values[q].at(axis),
                    is_finer ? nearest_of_coarse_cell(cell->center()[axis])
                             : points.quadrature_point(q)[axis],
                    1e-12);
  });
  EXPECT_EQ(dealii::Utilities::MPI::sum(n_finer, MPI_COMM_WORLD), 4U * 18U);
}

/// Repeatedly, so that cells move between the ranks; linear functions on cells are linear on their
/// children.
TEST(RefinedMesh, CarriesALinearDisplacement) {
  mesh::MeshData<2> square = geneva::test::empty_mesh();
  add_rectangle(square, "square", equal_steps(0., 1., 6), equal_steps(0., 1., 6), {"", "", "", ""});
  RefinedMesh<2> mesh(MPI_COMM_WORLD, square, 1.);
  const auto linear = [](const Point<2>& x) { return 2. * x[0] - x[1]; };
  Vector displacement(mesh.dof_handler->locally_owned_dofs(), MPI_COMM_WORLD);
  const auto visit_own = [&](const auto& task) {
    for (const auto& cell : mesh.dof_handler->active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int i : cell->vertex_indices())
          if (const auto dof = cell->vertex_dof_index(i, 0);
              mesh.dof_handler->locally_owned_dofs().is_element(dof))
            task(cell->vertex(i), displacement(dof));
  };
  visit_own([&](const Point<2>& x, double& value) { value = linear(x); });
  for (int pass = 0; pass < 4; ++pass) {
    for (const auto& cell : mesh.dof_handler->active_cell_iterators())
      if (cell->is_locally_owned() && cell->center().norm() < 0.5) cell->set_refine_flag();
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(*mesh.dof_handler, relevant);
    replace(displacement, mesh.refine({with_ghosts(displacement, relevant), {}}).displacement);
    visit_own([&](const Point<2>& x, const double value) { EXPECT_NEAR(value, linear(x), 1e-14); });
  }
}

TEST(Vectors, AreReplacedWithTheirGhosts) {
  const auto n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const auto rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  dealii::IndexSet own(n_ranks);
  own.add_index(rank);
  Vector values(own, MPI_COMM_WORLD);
  values(rank) = 1. + rank;
  Vector replaced = with_ghosts(values, own);
  replace(replaced, with_ghosts(values, dealii::complete_index_set(n_ranks)));
  for (unsigned int i = 0; i < n_ranks; ++i) EXPECT_EQ(replaced(i), 1. + i);
}

}  // namespace
}  // namespace geneva::fem::test
