#include "fem/elasticity/cell_element.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstddef>

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

namespace {

/// Component of a strain that the derivative j of a displacement along i belongs to; -1: none.
template <int dim>
constexpr std::array<std::array<int, 3>, 3> component_of =
    dim == 2 ? std::array<std::array<int, 3>, 3>{{{0, 3, 2}, {3, 1, -1}, {-1, -1, -1}}}
             : std::array<std::array<int, 3>, 3>{{{0, 3, 4}, {3, 1, 5}, {4, 5, 2}}};

/// C_ij,kl of the derivatives j of displacements along i and l of those along k, by (i, k), (j, l).
template <int dim>
Eigen::Matrix<double, dim * dim, 9> by_derivatives(const Tangent<dim>& tangent) {
  Eigen::Matrix<double, dim * dim, 9> result;
  for (int i = 0; i < dim; ++i)
    for (int k = 0; k < dim; ++k)
      for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l) {
          const int row =
              component_of<dim>[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
          const int column =
              component_of<dim>[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)];
          result(i + dim * k, j + 3 * l) = row < 0 || column < 0 ? 0. : tangent(row, column);
        }
  return result;
}

/// What is left of a stiffness, of which the lower triangle is given and kept, when the force of
/// its last displacement is none: K_ij - K_ni K_nj/K_nn for i, j < n.
template <class Matrix>
void eliminate(const int last, Matrix& stiffness) {
  for (int j = 0; j < last; ++j) {
    const double share = stiffness(last, j) / stiffness(last, last);
    for (int i = j; i < last; ++i) stiffness(i, j) -= share * stiffness(last, i);
  }
}

}  // namespace

template <int dim>
CellElement<dim>::CellElement(const dealii::FiniteElement<dim>& element,
                              const Problem<dim>& problem)
    : problem_(problem),
      laws_(material_laws(problem)),
      values_(element, dealii::QGauss<dim>(2),
              dealii::update_gradients | dealii::update_JxW_values | dealii::update_jacobians |
                  (dim == 3 ? dealii::update_default
                            : dealii::update_values | dealii::update_quadrature_points)),
      centre_(element, dealii::QMidpoint<dim>(),
              dealii::update_jacobians | dealii::update_inverse_jacobians) {}

template <int dim>
dealii::FullMatrix<double> CellElement<dim>::stiffness(const Cell& cell) {
  Stiffness condensed = whole_stiffness(cell);
  for (int mode = n_own + n_modes() - 1; mode >= n_own; --mode) eliminate(mode, condensed);
  dealii::FullMatrix<double> result(n_own);
  for (int i = 0; i < n_own; ++i)
    for (int j = 0; j < n_own; ++j)
      result(static_cast<unsigned int>(i), static_cast<unsigned int>(j)) =
          condensed(std::max(i, j), std::min(i, j));
  return result;
}

template <int dim>
std::vector<StressVector<dim>> CellElement<dim>::strains(const Cell& cell,
                                                         const dealii::Vector<double>& displacement,
                                                         const dealii::FEValues<dim>& values) {
  const Stiffness whole = whole_stiffness(cell);
  Eigen::Matrix<double, dim, n_functions> amplitudes =
      Eigen::Matrix<double, dim, n_functions>::Zero();
  Eigen::Map<Eigen::Matrix<double, n_all, 1>> all(amplitudes.data());
  all.template head<n_own>() =
      Eigen::Map<const Eigen::Matrix<double, n_own, 1>>(displacement.begin());
  constexpr int most_modes = n_all - n_own;
  using Modes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_modes, most_modes>;
  const Modes modes = whole.block(n_own, n_own, n_modes(), n_modes());
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_modes, 1> load =
      -whole.block(n_own, 0, n_modes(), n_own) * all.template head<n_own>();
  all.segment(n_own, n_modes()) = modes.llt().solve(load);
  std::vector<StressVector<dim>> result(values.n_quadrature_points, StressVector<dim>::Zero());
  for (const unsigned int q : values.quadrature_point_indices()) {
    const Eigen::Matrix<double, dim, 3> gradient = amplitudes * derivatives(values, q).transpose();
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < 3; ++j)
        if (const int component =
                component_of<dim>[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            component >= 0)
          result[q][component] += gradient(i, j);
  }
  return result;
}

template <int dim>
dealii::UpdateFlags CellElement<dim>::update_flags() {
  return dealii::update_values | dealii::update_gradients | dealii::update_jacobians |
         dealii::update_quadrature_points;
}

template <int dim>
bool CellElement<dim>::is_axisymmetric() const {
  return dim == 2 && problem_.plane == PlaneKind::axisymmetric;
}

template <int dim>
typename CellElement<dim>::ModeShapes CellElement<dim>::reference_shapes(const Point<dim>& xi) {
  ModeShapes shapes;
  for (unsigned int k = 0; k < dim; ++k) shapes[k] = 1. - 2. * xi[k];
  if (dim == 2) shapes[2] = shapes[0] * shapes[1];
  return shapes;
}

template <int dim>
typename CellElement<dim>::ModeShapes CellElement<dim>::means() const {
  ModeShapes sum = ModeShapes::Zero();
  if (dim == 2 && !is_axisymmetric()) return sum;
  double weights = 0.;
  for (const unsigned int q : values_.quadrature_point_indices()) {
    const double weight = dim == 3 ? values_.JxW(q) : values_.quadrature_point(q)[0];
    sum += weight * reference_shapes(values_.get_quadrature().point(q));
    weights += weight;
  }
  return sum / weights;
}

template <int dim>
typename CellElement<dim>::ModeShapes CellElement<dim>::mode_shapes(
    const dealii::FEValues<dim>& values, const unsigned int point) const {
  const double ratio =
      dim == 3 ? 1. : centre_.jacobian(0).determinant() / values.jacobian(point).determinant();
  return ratio * (reference_shapes(values.get_quadrature().point(point)) - means_);
}

template <int dim>
typename CellElement<dim>::Derivatives CellElement<dim>::derivatives(
    const dealii::FEValues<dim>& values, const unsigned int point) const {
  Derivatives result = Derivatives::Zero();
  for (unsigned int node = 0; node < n_nodes; ++node) {
    const Tensor<1, dim> gradient = values.shape_grad(dim * node, point);
    for (unsigned int axis = 0; axis < dim; ++axis) result(axis, node) = gradient[axis];
  }
  const ModeShapes shapes = mode_shapes(values, point);
  for (unsigned int k = 0; k < dim; ++k)
    for (unsigned int axis = 0; axis < dim; ++axis)
      result(axis, n_nodes + k) = shapes[k] * centre_.inverse_jacobian(0)[k][axis];
  if (is_axisymmetric()) add_hoop_strains(values, point, result);
  return result;
}

/// u_r/r, and the last mode; the modes of the displacement have none. On the axis, where u_r/r has
/// no value of its own, it equals the radial strain.
template <int dim>
void CellElement<dim>::add_hoop_strains(const dealii::FEValues<dim>& values,
                                        const unsigned int point, Derivatives& derivatives) const {
  constexpr int hoop = 2;
  const double radius = values.quadrature_point(point)[0];
  if (radius < 1e-12) {
    derivatives.row(hoop) = derivatives.row(0);
    return;
  }
  for (unsigned int node = 0; node < n_nodes; ++node)
    derivatives(hoop, node) = values.shape_value(dim * node, point) / radius;
  derivatives(hoop, n_functions - 1) = mode_shapes(values, point)[hoop];
}

/// With the tangent C, the same at all points, and the integrals G of derivative j of the function
/// a times derivative l of b, displacements by a along i and by b along k have the stiffness
/// C_ij,kl G_jl.
template <int dim>
typename CellElement<dim>::Stiffness CellElement<dim>::whole_stiffness(const Cell& cell) {
  using AtPoints = Eigen::Matrix<double, 3 * n_functions, n_points>;
  values_.reinit(cell);
  centre_.reinit(cell);
  means_ = means();
  AtPoints derivatives;
  Eigen::Matrix<double, n_points, 1> weights;
  for (const unsigned int q : values_.quadrature_point_indices()) {
    const Derivatives here = this->derivatives(values_, q);
    derivatives.col(q) = Eigen::Map<const Eigen::Matrix<double, 3 * n_functions, 1>>(here.data());
    weights[q] = values_.JxW(q) *
                 (dim == 3 ? 1. : out_of_plane_measure(problem_, values_.quadrature_point(q)));
  }
  const Eigen::Matrix<double, 3 * n_functions, 3 * n_functions> products =
      derivatives * (weights.asDiagonal() * derivatives.transpose());
  const auto tangent = by_derivatives<dim>(
      laws_[cell->material_id()]->respond(StressVector<dim>::Zero(), {}).tangent);
  Stiffness result;
  for (int a = 0; a < n_functions; ++a)
    for (int b = 0; b <= a; ++b) {
      const Eigen::Matrix3d product = products.template block<3, 3>(3 * a, 3 * b);
      const Eigen::Matrix<double, dim * dim, 1> block =
          tangent.lazyProduct(Eigen::Map<const Eigen::Matrix<double, 9, 1>>(product.data()));
      result.template block<dim, dim>(dim * a, dim * b) =
          Eigen::Map<const Eigen::Matrix<double, dim, dim>>(block.data());
    }
  return result;
}

template <int dim>
CellStresses<dim>::CellStresses(const dealii::FiniteElement<dim>& element,
                                const Problem<dim>& problem, const dealii::Quadrature<dim>& points)
    : element_(element, problem),
      laws_(material_laws(problem)),
      values_(element, points, CellElement<dim>::update_flags() | dealii::update_JxW_values),
      cell_displacement_(CellElement<dim>::n_own) {}

template <int dim>
std::vector<Stress<dim>> CellStresses<dim>::stresses(const typename CellElement<dim>::Cell& cell) {
  values_.reinit(cell);
  std::vector<Stress<dim>> result;
  for (const StressVector<dim>& strain : element_.strains(cell, cell_displacement_, values_)) {
    const StressVector<dim> stress = laws_[cell->material_id()]->respond(strain, {}).stress;
    result.push_back(
        assembled_stress<dim>([&](const unsigned int component) { return stress[component]; }));
  }
  return result;
}

template class CellElement<2>;
template class CellElement<3>;
template class CellStresses<2>;
template class CellStresses<3>;

}  // namespace geneva::fem
