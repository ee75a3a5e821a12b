#include "fem/discretisation/cell_parts.h"

#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/discretisation/cell_measure.h"

namespace geneva::fem {

template <int dim>
CellParts<dim> parts_of(const typename dealii::Triangulation<dim>::cell_iterator& cell) {
  constexpr double most = 8.;
  std::vector<dealii::Tensor<1, dim>> spans(dim);
  for (unsigned int axis = 0; axis < dim; ++axis)
    spans[axis] = cell->face(2 * axis + 1)->center() - cell->face(2 * axis)->center();
  const double shortest =
      std::min_element(spans.begin(), spans.end(), [](const auto& one, const auto& other) {
        return one.norm() < other.norm();
      })->norm();
  CellParts<dim> parts{{cell->center()}, cell_measure<dim>(cell)};
  for (const dealii::Tensor<1, dim>& span : spans) {
    const double n = std::min(std::round(span.norm() / shortest), most);
    std::vector<dealii::Point<dim>> centres;
    for (const dealii::Point<dim>& centre : parts.centres)
      for (double part = 0.5; part < n; ++part) centres.push_back(centre + (part / n - 0.5) * span);
    parts.centres = std::move(centres);
    parts.measure /= n;
  }
  return parts;
}

template CellParts<2> parts_of<2>(const dealii::Triangulation<2>::cell_iterator&);
template CellParts<3> parts_of<3>(const dealii::Triangulation<3>::cell_iterator&);

}  // namespace geneva::fem
