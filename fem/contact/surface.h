#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

#include "fem/boundary.h"

namespace geneva::fem {

/// A node of a contact surface.
struct SurfaceNode {
  dealii::Point<2> position;
  dealii::Tensor<1, 2> normal;  ///< outward unit normal: the circle's where the surface is one
  std::array<dealii::types::global_dof_index, 2> dofs;
  double arc_length;  ///< along the true surface, counter-clockwise around the body
};

/// An edge of a contact surface, from nodes[0] to nodes[1] counter-clockwise around the body.
struct SurfaceFace {
  std::array<unsigned int, 2> nodes;
  int circle;  ///< index into Surface::circles; -1: straight
};

/// One side of a contact pair: nodes and edges in the order of the arc length, the same on every
/// rank.
struct Surface {
  std::vector<SurfaceNode> nodes;
  std::vector<SurfaceFace> faces;
  std::vector<mesh::Circle> circles;
  bool closed = false;  ///< the last node is joined to the first
  double length = 0.;   ///< total arc length
};

/// Takes one named surface out of the boundary.
/// @param origin point whose nearest end (open surface) or node (closed surface) has arc length 0
Surface make_surface(const Boundary<2>& boundary, unsigned int surface_id,
                     const dealii::Point<2>& origin);

/// Point of the chord at xi in [0, 1].
dealii::Point<2> chord_point(const Surface& surface, const SurfaceFace& face, double xi);

/// The point of the true surface nearest to a point of the chord.
dealii::Point<2> true_point(const Surface& surface, const SurfaceFace& face,
                            const dealii::Point<2>& on_chord);

/// 1/R of the true surface: positive where the body bulges, 0 where it is straight.
double curvature(const Surface& surface, const SurfaceFace& face);

/// Outward unit normal of the chord.
dealii::Tensor<1, 2> chord_normal(const Surface& surface, const SurfaceFace& face);

}  // namespace geneva::fem
