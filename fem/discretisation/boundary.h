#pragma once

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::fem {

using dealii::types::global_dof_index;

/// A vertex of the boundary with the numbers of its displacement components.
template <int dim>
struct BoundaryNode {
  dealii::Point<dim> position;
  std::array<dealii::types::global_dof_index, static_cast<std::size_t>(dim)> dofs;
  unsigned int body;  ///< index into MeshData::bodies
};

/// A boundary edge, counter-clockwise around its body: the outward normal is to the right of start
/// -> end. In 3-D a quadrilateral, its vertices counter-clockwise as seen from outside.
template <int dim>
struct BoundaryFace {
  std::array<unsigned int, 1U << (dim - 1)> nodes;  ///< indices into Boundary::nodes
  unsigned int surface;                             ///< boundary id
  int circle;                                       ///< index into Boundary::circles; -1: straight
};

/// The whole boundary of all bodies, the same on every rank, in an order that does not depend on
/// the ranks.
template <int dim>
struct Boundary {
  std::vector<BoundaryNode<dim>> nodes;
  std::vector<BoundaryFace<dim>> faces;
  std::vector<mesh::Circle> circles;  ///< in the units of the triangulation
};

/// Gathers the boundary from all ranks (it is small: a power (dim - 1)/dim of the mesh).
template <int dim>
Boundary<dim> gather_boundary(const dealii::DoFHandler<dim>& dof_handler,
                              const std::vector<mesh::Circle>& circles, double length);

}  // namespace geneva::fem
