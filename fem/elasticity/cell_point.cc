#include "fem/elasticity/cell_point.h"

#include <deal.II/base/geometry_info.h>

#include <Eigen/LU>

namespace geneva::fem {

template <int dim>
std::vector<ReferencePoint<dim>> reference_points(const dealii::Quadrature<dim>& quadrature) {
  using Reference = dealii::GeometryInfo<dim>;
  std::vector<ReferencePoint<dim>> points(quadrature.size());
  for (unsigned int q = 0; q < quadrature.size(); ++q) {
    ReferencePoint<dim>& point = points[q];
    point.xi = quadrature.point(q);
    point.weight = quadrature.weight(q);
    for (unsigned int vertex = 0; vertex < Reference::vertices_per_cell; ++vertex) {
      point.shapes[vertex] = Reference::d_linear_shape_function(point.xi, vertex);
      const auto slope = Reference::d_linear_shape_function_gradient(point.xi, vertex);
      for (unsigned int k = 0; k < dim; ++k) point.slopes(k, vertex) = slope[k];
    }
  }
  return points;
}

template <int dim>
CellPoint<dim>::CellPoint(const CellVertices<dim>& vertices, const ReferencePoint<dim>& reference)
    : xi(reference.xi), shapes(reference.shapes) {
  const Eigen::Matrix<double, dim, 1> x = vertices * shapes;
  for (unsigned int i = 0; i < dim; ++i) place[i] = x[i];
  const Eigen::Matrix<double, dim, dim> by_xi = vertices * reference.slopes.transpose();
  jacobian = by_xi.determinant();
  measure = jacobian * reference.weight;
  inverse = by_xi.inverse();
  gradients = inverse.transpose() * reference.slopes;
}

template std::vector<ReferencePoint<2>> reference_points(const dealii::Quadrature<2>&);
template std::vector<ReferencePoint<3>> reference_points(const dealii::Quadrature<3>&);
template struct CellPoint<2>;
template struct CellPoint<3>;

}  // namespace geneva::fem
