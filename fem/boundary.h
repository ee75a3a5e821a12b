#pragma once

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::fem {

/// A vertex of the boundary with the numbers of its displacement components.
struct BoundaryNode {
  dealii::Point<2> position;
  std::array<dealii::types::global_dof_index, 2> dofs;
  unsigned int body;  ///< index into MeshData::bodies
};

/// A boundary edge, counter-clockwise around its body: the outward normal is to the right of start
/// -> end.
struct BoundaryFace {
  std::array<unsigned int, 2> nodes;  ///< start and end: indices into Boundary::nodes
  unsigned int surface;               ///< boundary id
  int circle;                         ///< index into Boundary::circles; -1: straight
};

/// The whole boundary of all bodies, the same on every rank, in an order that does not depend on
/// the ranks.
struct Boundary {
  std::vector<BoundaryNode> nodes;
  std::vector<BoundaryFace> faces;
  std::vector<mesh::Circle> circles;  ///< in the units of the triangulation
};

/// Gathers the boundary from all ranks (it is small: the square root of the mesh).
Boundary gather_boundary(const dealii::DoFHandler<2>& dof_handler,
                         const std::vector<mesh::Circle>& circles, double length);

}  // namespace geneva::fem
