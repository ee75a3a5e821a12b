#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "mesh/round_shapes.h"

namespace geneva::mesher {

/// Elements of one type in an entity of Gmsh's current model.
struct ElementBlock {
  std::size_t corners;             ///< of an element, its first nodes
  std::size_t nodes_of_one;        ///< all nodes of an element
  int order;                       ///< of its shape functions
  std::vector<std::size_t> nodes;  ///< tags, element by element
};

/// @param entity -1: all of that dimension
std::vector<ElementBlock> element_blocks(int dimension, int entity = -1);

/// Whether the current mesh has triangles in the plane.
bool has_triangles();

/// Places of all nodes, by tag.
std::map<std::size_t, mesh::Place> places_of_nodes();

}  // namespace geneva::mesher
