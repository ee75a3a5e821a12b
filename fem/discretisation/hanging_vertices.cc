#include "fem/discretisation/hanging_vertices.h"

#include <map>

namespace geneva::fem {

namespace {

using dealii::Point;

/// Moves one vertex, unless it has been moved already.
template <int dim>
void move(Point<dim>& vertex, const unsigned int index, const Point<dim>& place,
          std::map<unsigned int, Point<dim>>& moved) {
  if (!moved.emplace(index, vertex).second) return;
  vertex = place;
}

}  // namespace

template <int dim>
VertexPlaces<dim> close_gaps(dealii::Triangulation<dim>& triangulation) {
  std::map<unsigned int, Point<dim>> moved;
  if constexpr (dim == 3) {
    // by ascending level: a vertex may hang on an edge that ends in a hanging vertex
    for (unsigned int level = 0; level < triangulation.n_levels(); ++level) {
      for (const auto& cell : triangulation.active_cell_iterators_on_level(level)) {
        if (cell->is_artificial()) continue;
        for (const unsigned int i : cell->line_indices()) {
          const auto line = cell->line(i);
          if (!line->has_children()) continue;
          move(line->child(0)->vertex(1), line->child(0)->vertex_index(1),
               Point<dim>((line->vertex(0) + line->vertex(1)) / 2.), moved);
        }
        for (const auto& face : cell->face_iterators()) {
          if (!face->has_children()) continue;
          move(face->child(0)->vertex(3), face->child(0)->vertex_index(3),
               Point<dim>((face->vertex(0) + face->vertex(1) + face->vertex(2) + face->vertex(3)) /
                          4.),
               moved);
        }
      }
    }
  }
  return {moved.begin(), moved.end()};
}

template <int dim>
void put_back(dealii::Triangulation<dim>& triangulation, const VertexPlaces<dim>& places) {
  // deal.II hands out its vertices through the cells only
  const std::map<unsigned int, Point<dim>> place_of(places.begin(), places.end());
  if (place_of.empty()) return;
  for (const auto& cell : triangulation.active_cell_iterators())
    for (const unsigned int i : cell->vertex_indices()) {
      const auto place = place_of.find(cell->vertex_index(i));
      if (place != place_of.end()) cell->vertex(i) = place->second;
    }
}

template VertexPlaces<2> close_gaps(dealii::Triangulation<2>&);
template VertexPlaces<3> close_gaps(dealii::Triangulation<3>&);
template void put_back(dealii::Triangulation<2>&, const VertexPlaces<2>&);
template void put_back(dealii::Triangulation<3>&, const VertexPlaces<3>&);

}  // namespace geneva::fem
