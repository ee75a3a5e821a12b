#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>

#include <Eigen/Core>
#include <vector>

namespace geneva::fem {

/// A point of the reference cell, with the vertices' shape functions there.
template <int dim>
struct ReferencePoint {
  static constexpr int n_vertices = 1 << dim;

  dealii::Point<dim> xi;
  double weight;  ///< of its quadrature
  Eigen::Matrix<double, n_vertices, 1> shapes;
  Eigen::Matrix<double, dim, n_vertices> slopes;  ///< by xi
};

template <int dim>
std::vector<ReferencePoint<dim>> reference_points(const dealii::Quadrature<dim>& quadrature);

/// The vertices of a cell, as columns.
template <int dim>
using CellVertices = Eigen::Matrix<double, dim, 1 << dim>;

/// @param cell of a triangulation or one of its unknowns
template <int dim, typename Cell>
CellVertices<dim> vertices_of(const Cell& cell) {
  CellVertices<dim> vertices;
  for (const unsigned int vertex : cell->vertex_indices())
    for (unsigned int i = 0; i < dim; ++i) vertices(i, vertex) = cell->vertex(vertex)[i];
  return vertices;
}

/// A point of a cell with straight edges.
template <int dim>
struct CellPoint {
  static constexpr int n_vertices = 1 << dim;

  CellPoint(const CellVertices<dim>& vertices, const ReferencePoint<dim>& reference);

  dealii::Point<dim> xi;
  dealii::Point<dim> place;
  double jacobian;                          ///< determinant of d x/d xi
  double measure;                           ///< that times the weight
  Eigen::Matrix<double, dim, dim> inverse;  ///< d xi/d x
  Eigen::Matrix<double, n_vertices, 1> shapes;
  Eigen::Matrix<double, dim, n_vertices> gradients;  ///< of the shape functions
};

}  // namespace geneva::fem
