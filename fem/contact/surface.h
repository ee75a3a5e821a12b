#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "fem/discretisation/boundary.h"

namespace geneva::fem {

/// In the plane faces can touch only if their outward normals are opposed by more than this cosine.
constexpr double opposed = -0.1;

/// z component of the vector product of two vectors in the plane.
inline double cross(const dealii::Tensor<1, 2>& a, const dealii::Tensor<1, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// A node of a contact surface.
template <int dim>
struct SurfaceNode {
  dealii::Point<dim> position;
  dealii::Tensor<1, dim> normal;  ///< outward unit normal: the circle's where the surface is one
  std::array<dealii::types::global_dof_index, static_cast<std::size_t>(dim)> dofs;
  double arc_length;  ///< in the plane, along the true surface, counter-clockwise around the body
};

/// A face of a contact surface: in the plane an edge, counter-clockwise around the body; in 3-D a
/// quadrilateral, its nodes counter-clockwise as seen from outside.
template <int dim>
struct SurfaceFace {
  std::array<unsigned int, 1U << (dim - 1)> nodes;
  int circle;  ///< index into Surface::circles; -1: straight
};

/// One side of a contact pair, the same on every rank; in the plane its nodes and edges are in the
/// order of the arc length.
template <int dim>
struct Surface {
  std::vector<SurfaceNode<dim>> nodes;
  std::vector<SurfaceFace<dim>> faces;
  std::vector<mesh::Circle> circles;  ///< in 3-D cylinders, spheres and tori
  bool closed = false;                ///< in the plane: the last node is joined to the first
  double length = 0.;  ///< total arc length; in 3-D the diagonal of the box around it
};

/// Where arc lengths are counted from, for both surfaces of every pair, on every mesh; not used in
/// 3-D.
template <int dim>
struct SurfaceOrigins {
  std::vector<dealii::Point<dim>> source;
  std::vector<dealii::Point<dim>> target;
};

/// See mesh::radial().
template <int dim>
dealii::Tensor<1, dim> radial(const mesh::Circle& circle, const dealii::Point<dim>& point);

/// Takes one named surface out of the boundary.
/// @param origin point whose nearest end (open surface) or node (closed surface) has arc length 0
Surface<2> make_surface(const Boundary<2>& boundary, unsigned int surface_id,
                        const dealii::Point<2>& origin);

/// Which nodes are ends of the surface, or corners: where the normals of the two edges that meet
/// there differ by more than a thousandth.
std::vector<bool> corners(const Surface<2>& surface);

/// Outward unit normal of the true surface of a face at a node of it.
dealii::Tensor<1, 2> true_normal(const Surface<2>& surface, const SurfaceFace<2>& face,
                                 const dealii::Point<2>& node);
dealii::Tensor<1, 3> true_normal(const Surface<3>& surface, const SurfaceFace<3>& face,
                                 const dealii::Point<3>& node);

/// Whether a face leaves a node without a corner: its normal there is the node's own, which is the
/// mean of its faces', to half of a thousandth.
template <int dim>
bool leaves_smoothly(const Surface<dim>& surface, const SurfaceFace<dim>& face,
                     const unsigned int node) {
  constexpr double same_direction = 1e-3;  // of two faces
  const SurfaceNode<dim>& there = surface.nodes[node];
  return 2. * (true_normal(surface, face, there.position) - there.normal).norm() <= same_direction;
}

/// Point of the chord at xi in [0, 1].
dealii::Point<2> chord_point(const Surface<2>& surface, const SurfaceFace<2>& face, double xi);

/// The point of the true surface nearest to a point of the chord.
dealii::Point<2> true_point(const Surface<2>& surface, const SurfaceFace<2>& face,
                            const dealii::Point<2>& on_chord);

/// 1/R of the true surface: positive where the body bulges, 0 where it is straight.
double curvature(const Surface<2>& surface, const SurfaceFace<2>& face);

/// Middle of the chord.
dealii::Point<2> face_middle(const Surface<2>& surface, const SurfaceFace<2>& face);

/// Outward unit normal of the chord.
dealii::Tensor<1, 2> flat_normal(const Surface<2>& surface, const SurfaceFace<2>& face);

}  // namespace geneva::fem
