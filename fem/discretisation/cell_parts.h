#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace geneva::fem {

/// Equal parts of a cell that are about as long as wide.
template <int dim>
struct CellParts {
  std::vector<dealii::Point<dim>> centres;  ///< at least one
  double measure;                           ///< of one: area or volume, > 0
};

/// Cuts a cell along the axes along which it is longer than along its shortest one, up to eight
/// times each. Of a distorted cell parts are equal in measure and place as those of the
/// parallelepiped that its faces' middles span.
template <int dim>
CellParts<dim> parts_of(const typename dealii::Triangulation<dim>::cell_iterator& cell);

}  // namespace geneva::fem
