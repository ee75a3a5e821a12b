#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <utility>
#include <vector>

namespace geneva::fem {

/// Vertices (by their index) and the places where refinement has put them.
template <int dim>
using VertexPlaces = std::vector<std::pair<unsigned int, dealii::Point<dim>>>;

/// Moves every hanging vertex to the middle of the edge or face that it hangs on.
///
/// On and near curved surfaces refinement puts it beside: the cells on both sides would then leave
/// gaps or overlap, and the forces that the finer side hands on would not balance in moment. In the
/// plane inner edges are straight and nothing moves.
/// @return where the vertices were, for put_back()
template <int dim>
VertexPlaces<dim> close_gaps(dealii::Triangulation<dim>& triangulation);

/// Undoes close_gaps(), which must be done before the mesh is refined further.
template <int dim>
void put_back(dealii::Triangulation<dim>& triangulation, const VertexPlaces<dim>& places);

}  // namespace geneva::fem
