#include "fem/elasticity/surface_stress.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "mesh/dense_algebra.h"

namespace geneva::fem {

namespace {

using dealii::Tensor;

template <int dim>
using Basis = std::array<Tensor<1, dim>, static_cast<std::size_t>(dim)>;

/// An orthonormal basis of which the first vector is given.
Basis<2> basis(const Tensor<1, 2>& normal) {
  return {normal, Tensor<1, 2>({-normal[1], normal[0]})};
}

Basis<3> basis(const Tensor<1, 3>& normal) {
  unsigned int smallest = 0;
  for (unsigned int i = 1; i < 3; ++i)
    if (std::abs(normal[i]) < std::abs(normal[smallest])) smallest = i;
  Tensor<1, 3> other;
  other[smallest] = 1.;
  Tensor<1, 3> first = other - (other * normal) * normal;
  first /= first.norm();
  return {normal, first, dealii::cross_product_3d(normal, first)};
}

/// Coordinates along a surface, each relative to its maximum among the neighbours, so that long
/// cells are none.
template <int dim>
Eigen::MatrixXd surface_coordinates(const Tensor<1, dim>& normal,
                                    const std::vector<SurfaceNeighbour<dim>>& neighbours) {
  const auto axes = basis(normal);
  Eigen::MatrixXd coordinates(static_cast<Eigen::Index>(neighbours.size()), dim - 1);
  for (std::size_t i = 0; i < neighbours.size(); ++i)
    for (unsigned int k = 1; k < dim; ++k)
      coordinates(static_cast<Eigen::Index>(i), k - 1) = axes[k] * neighbours[i].offset;
  for (Eigen::Index k = 0; k < dim - 1; ++k)
    coordinates.col(k) /= coordinates.col(k).cwiseAbs().maxCoeff();
  return coordinates;
}

/// Their monomials of first and second degree.
Eigen::MatrixXd monomials(const Eigen::MatrixXd& x) {
  const Eigen::Index n_axes = x.cols();
  Eigen::MatrixXd result(x.rows(), n_axes * (n_axes + 3) / 2);
  Eigen::Index column = 0;
  for (Eigen::Index i = 0; i < n_axes; ++i) result.col(column++) = x.col(i);
  for (Eigen::Index i = 0; i < n_axes; ++i)
    for (Eigen::Index j = i; j < n_axes; ++j)
      result.col(column++) = x.col(i).cwiseProduct(x.col(j));
  return result;
}

/// By how much place and displacement change along the surface's coordinates: the first dim rows,
/// and the others.
template <int dim>
std::optional<Eigen::MatrixXd> slopes(const Tensor<1, dim>& normal,
                                      const std::vector<SurfaceNeighbour<dim>>& neighbours) {
  constexpr double minimum_condition = 1e-6;
  constexpr std::size_t n_terms = dim == 2 ? 2 : 5;
  if (neighbours.size() < n_terms) return std::nullopt;
  const Eigen::MatrixXd matrix = monomials(surface_coordinates<dim>(normal, neighbours));
  Eigen::MatrixXd values(matrix.rows(), 2 * dim);
  for (std::size_t i = 0; i < neighbours.size(); ++i)
    for (unsigned int k = 0; k < dim; ++k) {
      values(static_cast<Eigen::Index>(i), k) = neighbours[i].offset[k];
      values(static_cast<Eigen::Index>(i), dim + k) = neighbours[i].displacement[k];
    }
  const auto inverse = mesh::inverse(matrix.transpose() * matrix, minimum_condition);
  if (!inverse) return std::nullopt;
  return (*inverse * (matrix.transpose() * values)).topRows(dim - 1).transpose();
}

}  // namespace

template <int dim>
std::optional<Tensor<2, dim>> surface_gradient(
    const Tensor<1, dim>& normal, const std::vector<SurfaceNeighbour<dim>>& neighbours) {
  const auto found = slopes<dim>(normal, neighbours);
  if (!found) return std::nullopt;
  const Eigen::MatrixXd along = found->topRows(dim);
  const auto metric = mesh::inverse(along.transpose() * along, 1e-9);
  if (!metric) return std::nullopt;
  const Eigen::MatrixXd gradient = found->bottomRows(dim) * *metric * along.transpose();
  Tensor<2, dim> result;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j) result[i][j] = gradient(i, j);
  return result;
}

template <int dim>
Tensor<1, dim> traction_of(const StressVector<dim>& stress, const Tensor<1, dim>& normal) {
  if constexpr (dim == 2)
    return Tensor<1, 2>({stress[0] * normal[0] + stress[3] * normal[1],
                         stress[3] * normal[0] + stress[1] * normal[1]});
  else
    return Tensor<1, 3>({stress[0] * normal[0] + stress[3] * normal[1] + stress[4] * normal[2],
                         stress[3] * normal[0] + stress[1] * normal[1] + stress[5] * normal[2],
                         stress[4] * normal[0] + stress[5] * normal[1] + stress[2] * normal[2]});
}

template <int dim>
StressVector<dim> strain_of(const Tensor<2, dim>& gradient, const double hoop) {
  StressVector<dim> strain;
  if constexpr (dim == 2)
    strain << gradient[0][0], gradient[1][1], hoop, gradient[0][1] + gradient[1][0];
  else
    strain << gradient[0][0], gradient[1][1], gradient[2][2], gradient[0][1] + gradient[1][0],
        gradient[0][2] + gradient[2][0], gradient[1][2] + gradient[2][1];
  return strain;
}

namespace {

/// The strains that the traction on a surface decides: along the normal, and the shears with it. As
/// columns; their products with a stress are the traction along the vectors of basis(normal).
template <int dim>
using OpenStrains = Eigen::Matrix<double, n_stress_components<dim>, dim>;

template <int dim>
OpenStrains<dim> open_strains(const Tensor<1, dim>& normal) {
  const auto axes = basis(normal);
  OpenStrains<dim> open;
  for (unsigned int i = 0; i < dim; ++i)
    open.col(i) = strain_of<dim>(dealii::outer_product(axes[i], normal), 0.);
  return open;
}

}  // namespace

template <int dim>
Tangent<dim> surface_tangent(const Tangent<dim>& tangent, const Tensor<1, dim>& normal) {
  const OpenStrains<dim> open = open_strains(normal);
  const Eigen::Matrix<double, n_stress_components<dim>, dim> stresses = tangent * open;
  const Eigen::Matrix<double, dim, dim> tractions = open.transpose() * stresses;
  return tangent - stresses * tractions.inverse() * stresses.transpose();
}

template <int dim>
StressVector<dim> surface_stress(const MaterialLaw<dim>& law, const Tensor<2, dim>& gradient,
                                 const double hoop, const Tensor<1, dim>& normal,
                                 const Tensor<1, dim>& traction) {
  const auto axes = basis(normal);
  const OpenStrains<dim> open = open_strains(normal);
  Eigen::Matrix<double, dim, 1> wanted;
  for (unsigned int i = 0; i < dim; ++i) wanted[i] = axes[i] * traction;
  Tensor<2, dim> along;
  for (unsigned int i = 1; i < dim; ++i)
    for (unsigned int j = 1; j < dim; ++j)
      along += (axes[i] * (gradient * axes[j])) * dealii::outer_product(axes[i], axes[j]);
  StressVector<dim> strain = strain_of<dim>(along, hoop);
  // Newton's method, which ends after one step where stresses are linear in strains.
  constexpr unsigned int maximum_steps = 20;
  MaterialResponse<dim> response = law.respond(strain, {});
  for (unsigned int step = 0; step < maximum_steps; ++step) {
    const Eigen::Matrix<double, dim, dim> slope = open.transpose() * response.tangent * open;
    strain += open * (slope.inverse() * (wanted - open.transpose() * response.stress));
    response = law.respond(strain, {});
    if ((wanted - open.transpose() * response.stress).norm() <=
        1e-12 * (response.stress.norm() + wanted.norm()))
      break;
  }
  return response.stress;
}

#define INSTANTIATE(dim)                                                                    \
  template std::optional<Tensor<2, dim>> surface_gradient(                                  \
      const Tensor<1, dim>&, const std::vector<SurfaceNeighbour<dim>>&);                    \
  template Tensor<1, dim> traction_of(const StressVector<dim>&, const Tensor<1, dim>&);     \
  template Tangent<dim> surface_tangent(const Tangent<dim>&, const Tensor<1, dim>&);        \
  template StressVector<dim> strain_of(const Tensor<2, dim>&, double);                      \
  template StressVector<dim> surface_stress(const MaterialLaw<dim>&, const Tensor<2, dim>&, \
                                            double, const Tensor<1, dim>&, const Tensor<1, dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace geneva::fem
