#pragma once

#include <optional>
#include <vector>

#include "mesh/round_shapes.h"

namespace geneva::mesh {

/// The torus on which all points lie to 1e-8 of their extent, by the squares of their distances
/// (Gauss and Newton's method).
///
/// The lines of a surface of revolution's normals meet its axis: with n at p and the axis a through
/// c, n.(c x a) + (p x n).a = 0, linear in a and c x a (H. Pottmann and T. Randrup 1998,
/// "Rotational and helical surface approximation for reverse engineering"). Across the axis the
/// points lie on a circle, the tube's.
/// @param points seven at least
/// @param normals six at least
/// @return nothing if there is none, or if the points are at fewer than three different angles
/// around its axis or than five around its tube, where another shape would do as well
std::optional<Circle> torus_through(const std::vector<Place>& points,
                                    const std::vector<SurfaceNormal>& normals);

}  // namespace geneva::mesh
