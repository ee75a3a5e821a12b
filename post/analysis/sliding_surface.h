#pragma once

#include <optional>
#include <vector>

#include "fem/solution.h"

namespace geneva::post {

/// Stresses along the two surfaces of a plane contact at one of its nodes, tension positive [Pa].
struct SurfaceStress {
  double source;
  double target;
};

/// From the strain e along the surface and the pressure p: E/(1 - nu^2) e - nu/(1 - nu) p in plane
/// strain, E e - nu p in plane stress.
/// @return by node; empty of an axisymmetric model
std::vector<SurfaceStress> surface_stresses(const fem::Solution<2>& solution,
                                            const fem::ContactResult<2>& contact);

/// What friction makes of the stress along the surfaces in contact.
struct SurfaceExtremes {
  double tension;      ///< greatest, at the end of the contact from which friction pulls [Pa], >= 0
  double compression;  ///< greatest [Pa], >= 0
  double shear;        ///< greatest in the plane [Pa]: hypot((s + p)/2, q)
  fem::Components<2> shear_place;  ///< [m]
};

/// Of the contact with the peak pressure. The stress s along a surface has a cusp where the contact
/// ends: there it is s + p, which is smooth where the surface slides, of the parabola through the
/// half of the sliding nodes that is nearest to the end, without the last two.
/// @return nothing without friction, of an axisymmetric model, or with fewer than twelve nodes in
/// contact
std::optional<SurfaceExtremes> surface_extremes(const fem::Solution<2>& solution,
                                                const fem::ContactResult<2>& contact);

}  // namespace geneva::post
