#pragma once

#include "loads/hertz.h"

namespace geneva::loads {

/// Maximum shear below a line contact of a cylinder that is held at a rigid core, in plane strain.
///
/// In a half-plane it is 0.300 p0 at 0.786 b; the cylinder's size adds a share of the order b/R,
/// which depends on core and Poisson's ratio alone: 2.06 b/R with a core of R/2 and nu = 0.3.
/// Hertz's pressure on the surface is taken apart into waves p_n cos(n theta), each of which makes
/// Michell's stresses in the ring between surface and core (J. R. Barber, Elasticity, 3rd ed.,
/// chapters 8 and 9); see doc/theory.md, 2.1.
/// @param contact with b < R/4
/// @param radius R > 0 [m]
/// @param core_radius > 0 and < 0.95 R [m]
/// @param poissons_ratio of the cylinder, -1 < nu < 0.5
/// @throws base::InputError if a length or the ratio is outside its range
DeepStress maximum_shear_in_held_cylinder(const HertzLine& contact, double radius,
                                          double core_radius, double poissons_ratio);

}  // namespace geneva::loads
