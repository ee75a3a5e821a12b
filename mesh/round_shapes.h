#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// A point in 3-D.
using Place = std::array<double, 3>;

/// What points of a surface may be parts of. Two rings of nodes, a cylinder's or a cone's, lie on a
/// sphere, too: of these it may be none.
enum class MayBe { any_shape, no_sphere };

/// A point of a surface and its normal there, roughly and of any length and sign.
struct SurfaceNormal {
  Place at;
  Place direction;
};

/// The circle in the plane z = 0 on which all points lie to 1e-8 of its radius, if there is one;
/// the points, five at least, need not be in order.
std::optional<Circle> circle_through(const std::vector<Place>& points);

/// The sphere, cylinder or torus on which all points lie to 1e-8 of its radius, if there is one;
/// ten points at least. A cylinder's centre is the point of its axis nearest to the origin.
/// @param normals for the axis of a cylinder, which is across all of them, and of a torus, which
/// all of their lines meet
std::optional<Circle> round_surface_through(const std::vector<Place>& points,
                                            const std::vector<SurfaceNormal>& normals,
                                            MayBe may_be = MayBe::any_shape);

/// The circle in the plane z = 0 nearest to points that are nearly on one, five at least: the sum
/// of the squares of their distances from it is least.
/// @param tolerance maximum distance, as a share of the radius, >= 0
/// @return nothing if a point is farther off, or if a straight line is not ten times as far off
std::optional<Circle> circle_near(const std::vector<Place>& points, double tolerance);

/// The same in 3-D for the nearer of a cylinder and a sphere, with ten points at least.
/// @param normals see round_surface_through
std::optional<Circle> round_surface_near(const std::vector<Place>& points,
                                         const std::vector<SurfaceNormal>& normals,
                                         double tolerance, MayBe may_be = MayBe::any_shape);

/// Whether all points lie on a shape to a share of its radius.
bool all_on(const Circle& circle, const std::vector<Place>& points, double tolerance);

}  // namespace geneva::mesh
