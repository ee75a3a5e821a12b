#include "post/analysis/stress.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "fem/discretisation/element.h"
#include "fem/discretisation/gather.h"
#include "fem/elasticity/cell_element.h"
#include "fem/singular_places.h"
#include "mesh/dense_algebra.h"

namespace geneva::post {

using dealii::Point;

namespace {

/// The maximum of the ranks' peaks, with its place, on every rank.
template <int dim>
StressPeak<dim> maximum(const MPI_Comm communicator, const StressPeak<dim>& local) {
  StressPeak<dim> peak = local;
  for (const StressPeak<dim>& of_rank : fem::gathered_one(communicator, local))
    if (of_rank.value > peak.value) peak = of_rank;
  return peak;
}

/// A sample of the shear stress near its maximum.
using Sample = std::array<double, 3>;  ///< x, y, value

/// This rank's samples in one body, since the field of the other one is not continuous with it, and
/// beyond an axis of revolution their images.
std::vector<Sample> samples_around(const Point<2>& place, const double radius, const int body,
                                   const std::vector<CellStress<2>>& stresses,
                                   const bool has_axis) {
  std::vector<Sample> samples;
  for (const CellStress<2>& cell : stresses) {
    if (static_cast<int>(cell.body) != body) continue;
    const Point<2> image(-cell.centre[0], cell.centre[1]);
    const double shear = in_plane_shear(cell.stress);
    if (cell.centre.distance(place) < radius)
      samples.push_back({cell.centre[0], cell.centre[1], shear});
    if (has_axis && image.distance(place) < radius) samples.push_back({image[0], image[1], shear});
  }
  return samples;
}

/// Monomials x^i y^j up to a degree, and their derivatives by x and y.
struct Monomials {
  std::vector<double> value, by_x, by_y;
};

Monomials monomials(const double x, const double y, const int degree) {
  const auto power = [](const double base, const int exponent) {
    return exponent < 0 ? 0. : std::pow(base, exponent);
  };
  Monomials m;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) {
      m.value.push_back(power(x, i) * power(y, j));
      m.by_x.push_back(i * power(x, i - 1) * power(y, j));
      m.by_y.push_back(j * power(x, i) * power(y, j - 1));
    }
  return m;
}

/// Top of the polynomial fitted to the samples within a radius of the maximum one, of a degree up
/// to four as there are enough of them, or that sample itself if the polynomial has none nearby.
StressPeak<2> fitted_top(const std::vector<Sample>& samples, const StressPeak<2>& peak,
                         const double radius) {
  const int degree = samples.size() >= 30 ? 4 : samples.size() >= 20 ? 3 : 2;
  if (samples.size() < 9) return peak;
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd matrix(n, (degree + 1) * (degree + 2) / 2);
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    const Monomials m = monomials((sample[0] - peak.place[0]) / radius,
                                  (sample[1] - peak.place[1]) / radius, degree);
    matrix.row(i) = Eigen::Map<const Eigen::RowVectorXd>(m.value.data(), matrix.cols());
    values(i) = sample[2] / peak.value;
  }
  const Eigen::VectorXd c = mesh::least_squares(matrix, values);
  const auto gradient = [&](const Eigen::Vector2d& at) {
    const Monomials m = monomials(at(0), at(1), degree);
    return Eigen::Vector2d(Eigen::Map<const Eigen::RowVectorXd>(m.by_x.data(), c.size()).dot(c),
                           Eigen::Map<const Eigen::RowVectorXd>(m.by_y.data(), c.size()).dot(c));
  };
  Eigen::Vector2d top(0., 0.);
  for (int step = 0; step < 30; ++step) {
    constexpr double h = 1e-5;
    Eigen::Matrix2d hessian;
    hessian.col(0) =
        (gradient(top + Eigen::Vector2d(h, 0.)) - gradient(top - Eigen::Vector2d(h, 0.))) /
        (2. * h);
    hessian.col(1) =
        (gradient(top + Eigen::Vector2d(0., h)) - gradient(top - Eigen::Vector2d(0., h))) /
        (2. * h);
    if (hessian(0, 0) >= 0. || hessian(0, 0) * hessian(1, 1) <= hessian(0, 1) * hessian(1, 0))
      return peak;
    const Eigen::Vector2d move = mesh::least_squares(hessian, -gradient(top));
    top += move;
    if (move.norm() < 1e-12) break;
  }
  if (!(top.norm() < 1.)) return peak;
  const Monomials m = monomials(top(0), top(1), degree);
  const double value = Eigen::Map<const Eigen::RowVectorXd>(m.value.data(), c.size()).dot(c);
  return {value * peak.value, {peak.place[0] + radius * top(0), peak.place[1] + radius * top(1)}};
}

}  // namespace

template <int dim>
std::vector<CellStress<dim>> cell_stresses(const fem::Solution<dim>& solution) {
  fem::CellStresses<dim> evaluate(solution.problem, dealii::QMidpoint<dim>());
  const double length = solution.scales.length;
  std::vector<CellStress<dim>> stresses;
  for (const auto& cell : solution.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const fem::PointStress<dim> middle = evaluate(cell, solution.displacement).front();
    stresses.push_back({Point<dim>(length * middle.place), std::pow(length, dim) * middle.measure,
                        length * cell->extent_in_direction(dim - 1), cell->material_id(),
                        middle.stress});
  }
  return stresses;
}

template <int dim>
NodalStress<dim> nodal_stress(const fem::Solution<dim>& solution) {
  return fem::recovered_stress(*solution.dof_handler, solution.displacement, solution.problem,
                               fem::boundary_tractions(solution));
}

template <int dim>
StressPeak<dim> peak_von_mises(const fem::Solution<dim>& solution, const NodalStress<dim>& stress,
                               const unsigned int body) {
  StressPeak<dim> peak;
  for (const auto& cell : stress.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->material_id() != body) continue;
    for (const unsigned int vertex : cell->vertex_indices()) {
      const auto at_node = assembled_stress<dim>([&](const unsigned int component) {
        return stress.values(cell->vertex_dof_index(vertex, component));
      });
      const double equivalent = von_mises(principal_stresses(at_node));
      if (equivalent <= peak.value) continue;
      peak.value = equivalent;
      for (unsigned int i = 0; i < dim; ++i)
        peak.place[i] = cell->vertex(vertex)[i] * solution.scales.length;
    }
  }
  return maximum(solution.dof_handler->get_communicator(), peak);
}

StressPeak<2> peak_shear(const fem::Solution<2>& solution,
                         const std::vector<CellStress<2>>& stresses, const Point<2>& around,
                         const double distance, const double radius) {
  const MPI_Comm communicator = solution.dof_handler->get_communicator();
  StressPeak<2> local;
  int body = 0;
  for (const CellStress<2>& cell : stresses) {
    const double shear = in_plane_shear(cell.stress);
    if (cell.centre.distance(around) >= distance || shear <= local.value ||
        fem::is_beside(solution.singular, cell.centre))
      continue;
    local = {shear, {cell.centre[0], cell.centre[1]}};
    body = static_cast<int>(cell.body);
  }
  const StressPeak<2> peak = maximum(communicator, local);
  const bool is_here = local.value == peak.value && local.place == peak.place;
  body = dealii::Utilities::MPI::max(is_here ? body : -1, communicator);
  const auto samples =
      samples_around(Point<2>(peak.place[0], peak.place[1]), radius, body, stresses,
                     solution.problem.plane == fem::PlaneKind::axisymmetric);
  return fitted_top(fem::gathered(communicator, samples), peak, radius);
}

template std::vector<CellStress<2>> cell_stresses(const fem::Solution<2>&);
template std::vector<CellStress<3>> cell_stresses(const fem::Solution<3>&);
template NodalStress<2> nodal_stress(const fem::Solution<2>&);
template NodalStress<3> nodal_stress(const fem::Solution<3>&);
template StressPeak<2> peak_von_mises(const fem::Solution<2>&, const NodalStress<2>&, unsigned int);
template StressPeak<3> peak_von_mises(const fem::Solution<3>&, const NodalStress<3>&, unsigned int);

}  // namespace geneva::post
