#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// A point in space.
using Place = std::array<double, 3>;

/// The circle in the plane z = 0 on which all points lie to 1e-8 of its radius, if there is one;
/// the points, five at least, need not be in order.
std::optional<Circle> circle_through(const std::vector<Place>& points);

/// The sphere or cylinder on which all points lie to 1e-8 of its radius, if there is one; ten
/// points at least. A cylinder's centre is the point of its axis nearest to the origin.
/// @param normals of the surface at points of it, roughly; for the direction of a cylinder's axis
std::optional<Circle> round_surface_through(const std::vector<Place>& points,
                                            const std::vector<Place>& normals);

}  // namespace geneva::mesh
