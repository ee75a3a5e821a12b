#pragma once

#include <deal.II/grid/tria.h>

namespace geneva::fem {

/// Area or volume of a cell with straight edges, > 0, by the determinants of its map at 2^dim Gauss
/// points, which is exact. From differences of its vertices, so that it holds for cells of any
/// size: dealii::TriaAccessor::measure() takes absolute coordinates, and that of a cell of 1e-6 in
/// a model of 1 may come out as 0.
template <int dim>
double cell_measure(const typename dealii::Triangulation<dim>::cell_iterator& cell);

}  // namespace geneva::fem
