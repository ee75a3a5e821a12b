#pragma once

#include <array>

#include "fem/contact/surface.h"

namespace geneva::fem {

/// Takes one named surface out of the boundary.
Surface<3> make_surface(const Boundary<3>& boundary, unsigned int surface_id);

/// Steps from each node to the nearest marked one, from node to node of a common face; the number
/// of nodes where no way leads to one.
std::vector<unsigned int> steps_from(const Surface<3>& surface, const std::vector<bool>& marked);

/// Shape functions of the four nodes, one after the other around the face, at a place in [0, 1]^2.
std::array<double, 4> bilinear_shapes(const std::array<double, 2>& at);

/// Point of the bilinear face.
dealii::Point<3> face_point(const Surface<3>& surface, const SurfaceFace<3>& face,
                            const std::array<double, 2>& at);

/// Middle of the face.
dealii::Point<3> face_middle(const Surface<3>& surface, const SurfaceFace<3>& face);

/// From one side of a face to the opposite one, through its middle.
/// @param direction 0: in that of the edge from its first to its second node, 1: of that from its
/// second to its third
dealii::Tensor<1, 3> face_edge(const Surface<3>& surface, const SurfaceFace<3>& face,
                               std::size_t direction);

/// Outward unit normal of the flat face through the middles of the sides.
dealii::Tensor<1, 3> flat_normal(const Surface<3>& surface, const SurfaceFace<3>& face);

/// Outward unit normal at a place: the nodes' normals interpolated, which is the true normal on a
/// cylinder and on a plane.
dealii::Tensor<1, 3> face_normal(const Surface<3>& surface, const SurfaceFace<3>& face,
                                 const std::array<double, 2>& at);

/// The point of the true surface nearest to a point of the face.
dealii::Point<3> true_point(const Surface<3>& surface, const SurfaceFace<3>& face,
                            const dealii::Point<3>& on_face);

/// Second derivative of the true surface along a tangent vector of the length of interest: its
/// square across the cylinder's axis over the radius, positive where the body bulges [length].
double bulge(const Surface<3>& surface, const SurfaceFace<3>& face,
             const dealii::Tensor<1, 3>& along);

}  // namespace geneva::fem
