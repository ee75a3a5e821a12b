#include "fem/cell_element.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Dense>

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

template <int dim>
CellElement<dim>::CellElement(const dealii::FiniteElement<dim>& element,
                              const Problem<dim>& problem)
    : problem_(problem),
      values_(element, dealii::QGauss<dim>(2),
              dealii::update_gradients | dealii::update_JxW_values | dealii::update_jacobians |
                  (dim == 3 ? dealii::update_default
                            : dealii::update_values | dealii::update_quadrature_points)),
      centre_(element, dealii::QMidpoint<dim>(),
              dealii::update_jacobians | dealii::update_inverse_jacobians) {
  for (const Body<dim>& body : problem.bodies) lame_.push_back(lame(body.material, problem.plane));
}

template <int dim>
dealii::FullMatrix<double> CellElement<dim>::stiffness(const Cell& cell) {
  const Stiffness whole = whole_stiffness(cell);
  Eigen::Matrix<double, n_own, n_own> condensed = whole.template topLeftCorner<n_own, n_own>();
  const auto condense = [&](const auto& mixed, const auto& modes) {
    condensed -= mixed.transpose() * modes.llt().solve(mixed);
  };
  if (is_axisymmetric())
    condense(whole.template block<most_modes, n_own>(n_own, 0).eval(),
             whole.template block<most_modes, most_modes>(n_own, n_own).eval());
  else
    condense(whole.template block<dim * dim, n_own>(n_own, 0).eval(),
             whole.template block<dim * dim, dim * dim>(n_own, n_own).eval());
  dealii::FullMatrix<double> result(n_own);
  for (unsigned int i = 0; i < result.m(); ++i)
    for (unsigned int j = 0; j < result.n(); ++j)
      result(i, j) = condensed(std::max(i, j), std::min(i, j));
  return result;
}

template <int dim>
std::vector<Strain<dim>> CellElement<dim>::mode_strains(const Cell& cell,
                                                        const dealii::Vector<double>& displacement,
                                                        const dealii::FEValues<dim>& values) {
  const Stiffness whole = whole_stiffness(cell);
  const Eigen::Map<const Eigen::Matrix<double, n_own, 1>> own(displacement.begin());
  const Eigen::MatrixXd stiffness = whole.block(n_own, n_own, n_modes(), n_modes());
  const Eigen::VectorXd load = -whole.block(n_own, 0, n_modes(), n_own) * own;
  const Eigen::VectorXd amplitudes = stiffness.llt().solve(load);
  std::vector<Strain<dim>> strains(values.n_quadrature_points);
  for (const unsigned int q : values.quadrature_point_indices()) {
    const ModeShapes shapes = mode_shapes(values, q);
    Tensor<2, dim> gradient;
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int component = 0; component < dim; ++component)
        gradient[component] +=
            amplitudes[dim * k + component] * shapes[k] * centre_.inverse_jacobian(0)[k];
    strains[q].tensor = dealii::symmetrize(gradient);
    strains[q].hoop = is_axisymmetric() ? amplitudes[n_modes() - 1] * shapes[2] : 0.;
  }
  return strains;
}

template <int dim>
bool CellElement<dim>::is_axisymmetric() const {
  return dim == 2 && problem_.plane == PlaneKind::axisymmetric;
}

template <int dim>
typename CellElement<dim>::Weights CellElement<dim>::weights() const {
  Weights result;
  for (const unsigned int q : values_.quadrature_point_indices())
    result[q] = values_.JxW(q) *
                (dim == 3 ? 1. : out_of_plane_measure(problem_, values_.quadrature_point(q)));
  return result;
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
  if (!is_axisymmetric()) return sum;
  double weights = 0.;
  for (const unsigned int q : values_.quadrature_point_indices()) {
    const double radius = values_.quadrature_point(q)[0];
    sum += radius * reference_shapes(values_.get_quadrature().point(q));
    weights += radius;
  }
  return sum / weights;
}

template <int dim>
typename CellElement<dim>::ModeShapes CellElement<dim>::mode_shapes(
    const dealii::FEValues<dim>& values, const unsigned int point) const {
  const double ratio = centre_.jacobian(0).determinant() / values.jacobian(point).determinant();
  return ratio * (reference_shapes(values.get_quadrature().point(point)) - means_);
}

template <int dim>
typename CellElement<dim>::template Gradients<CellElement<dim>::n_functions>
CellElement<dim>::gradients() const {
  Gradients<n_functions> result;
  for (const unsigned int q : values_.quadrature_point_indices()) {
    for (unsigned int node = 0; node < n_nodes; ++node) {
      const Tensor<1, dim> gradient = values_.shape_grad(dim * node, q);
      for (unsigned int axis = 0; axis < dim; ++axis) result(dim * node + axis, q) = gradient[axis];
    }
    const ModeShapes shapes = mode_shapes(values_, q);
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int axis = 0; axis < dim; ++axis)
        result(dim * (n_nodes + k) + axis, q) = shapes[k] * centre_.inverse_jacobian(0)[k][axis];
  }
  return result;
}

/// Where G is the integral of grad a grad b^T, the stiffness of displacements by the functions a
/// and b in each direction is lambda G + mu (G^T + tr G).
template <int dim>
typename CellElement<dim>::Stiffness CellElement<dim>::whole_stiffness(const Cell& cell) {
  using Block = Eigen::Matrix<double, dim, dim>;
  constexpr int n = dim * n_functions;
  values_.reinit(cell);
  centre_.reinit(cell);
  means_ = means();
  const Lame& constants = lame_[cell->material_id()];
  const Gradients<n_functions> gradients = this->gradients();
  const Weights weights = this->weights();
  const Eigen::Matrix<double, n, n> products =
      gradients * (weights.asDiagonal() * gradients.transpose());
  Stiffness result;
  if (n_all > n) result.setZero();
  auto own = result.template topLeftCorner<n, n>();
  own = constants.lambda_plane * products;
  for (int a = 0; a < n_functions; ++a)
    for (int b = 0; b < n_functions; ++b) {
      const Block block = products.template block<dim, dim>(dim * a, dim * b);
      own.template block<dim, dim>(dim * a, dim * b) +=
          constants.mu * (block.transpose() + block.trace() * Block::Identity());
    }
  if (is_axisymmetric()) add_hoop_stiffness(constants, gradients, weights, result);
  return result;
}

/// What the hoop strains u_r/r and that of the last mode add; the modes of the displacement have
/// none.
template <int dim>
void CellElement<dim>::add_hoop_stiffness(const Lame& constants,
                                          const Gradients<n_functions>& gradients,
                                          const Weights& weights, Stiffness& stiffness) const {
  using Strains = Eigen::Matrix<double, n_all, n_points>;
  Strains hoop = Strains::Zero();
  Strains dilatation = Strains::Zero();
  dilatation.template topRows<dim * n_functions>() = gradients;
  for (const unsigned int q : values_.quadrature_point_indices()) {
    for (unsigned int node = 0; node < n_nodes; ++node)
      hoop(dim * node, q) = values_.shape_value(dim * node, q) / values_.quadrature_point(q)[0];
    hoop(n_all - 1, q) = mode_shapes(values_, q)[2];
  }
  const Stiffness mixed = dilatation * (weights.asDiagonal() * hoop.transpose());
  stiffness += constants.lambda_plane * (mixed + mixed.transpose()) +
               (constants.lambda_plane + 2. * constants.mu) *
                   (hoop * (weights.asDiagonal() * hoop.transpose()));
}

template <int dim>
CellStrains<dim>::CellStrains(const dealii::FiniteElement<dim>& element,
                              const Problem<dim>& problem, const dealii::Quadrature<dim>& points)
    : element_(element, problem),
      is_axisymmetric_(dim == 2 && problem.plane == PlaneKind::axisymmetric),
      values_(element, points,
              dealii::update_values | dealii::update_gradients | dealii::update_jacobians |
                  dealii::update_quadrature_points | dealii::update_JxW_values),
      cell_displacement_(CellElement<dim>::n_own) {}

/// On the axis, where u_r/r has no value of its own, it equals the radial strain.
template <int dim>
std::vector<Strain<dim>> CellStrains<dim>::strains(const typename CellElement<dim>::Cell& cell) {
  values_.reinit(cell);
  auto result = element_.mode_strains(cell, cell_displacement_, values_);
  for (const unsigned int q : values_.quadrature_point_indices()) {
    Tensor<2, dim> gradient;
    double radial = 0.;
    for (const unsigned int i : values_.dof_indices()) {
      const unsigned int component = values_.get_fe().system_to_component_index(i).first;
      gradient[component] += cell_displacement_[i] * values_.shape_grad(i, q);
      if (component == 0) radial += cell_displacement_[i] * values_.shape_value(i, q);
    }
    result[q].tensor += dealii::symmetrize(gradient);
    if (!is_axisymmetric_) continue;
    const double radius = values_.quadrature_point(q)[0];
    if (radius > 1e-12)
      result[q].hoop += radial / radius;
    else
      result[q].hoop = result[q].tensor[0][0];
  }
  return result;
}

template class CellElement<2>;
template class CellElement<3>;
template class CellStrains<2>;
template class CellStrains<3>;

}  // namespace geneva::fem
