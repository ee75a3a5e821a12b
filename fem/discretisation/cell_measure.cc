#include "fem/discretisation/cell_measure.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

namespace geneva::fem {

template <int dim>
double cell_measure(const typename dealii::Triangulation<dim>::cell_iterator& cell) {
  static const dealii::QGauss<dim> quadrature(2);
  double measure = 0.;
  for (unsigned int q = 0; q < quadrature.size(); ++q) {
    dealii::Tensor<2, dim> jacobian;
    for (const unsigned int vertex : cell->vertex_indices())
      jacobian += outer_product(
          cell->vertex(vertex) - cell->vertex(0),
          dealii::GeometryInfo<dim>::d_linear_shape_function_gradient(quadrature.point(q), vertex));
    measure += quadrature.weight(q) * determinant(jacobian);
  }
  return measure;
}

template double cell_measure<2>(const dealii::Triangulation<2>::cell_iterator&);
template double cell_measure<3>(const dealii::Triangulation<3>::cell_iterator&);

}  // namespace geneva::fem
