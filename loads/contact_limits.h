#pragma once

#include "loads/hertz.h"

namespace geneva::loads {

/// Stress of the body z >= 0 under a line contact that slides, in plane strain: McEwen's and that
/// of the traction mu p towards +x (J. O. Smith and C. K. Liu 1953; K. L. Johnson, Contact
/// Mechanics, 1985, Eq. 7.5 to 7.8).
/// @param friction coefficient mu >= 0
/// @param x along the contact, z >= 0 into the body [m]
ContactStress sliding_stress(const HertzLine& contact, double friction, double x, double z);

/// Maximum in-plane shear of sliding_stress() [Pa] and its depth [m]; as mu grows it moves from
/// below the contact to its surface, where the shear is mu p0.
/// @param friction coefficient mu >= 0
DeepStress maximum_sliding_shear(const HertzLine& contact, double friction);

/// Peak pressures of a contact up to which a material that yields at the von Mises stress Y stands
/// it, over Y.
struct ContactLimits {
  double first_yield;  ///< at no point beyond Y
  double shakedown;    ///< elastic again after residual stresses have built up, under any number of
                       ///< passes, without hardening
};

/// Of a line contact in plane strain. Shakedown: k over the greatest shear xz below the surface
/// (Melan's theorem; K. L. Johnson 1985, 9.1), 4 k without friction, at most k/mu, where the
/// surface decides (Tresca).
/// @param poissons_ratio of the body, -1 < nu < 0.5
/// @param friction coefficient mu of gross sliding, 0 <= mu <= 1
/// @throws base::InputError outside of these ranges
ContactLimits line_contact_limits(double poissons_ratio, double friction);

/// Of a circular contact without friction. Shakedown: 4.68 k (A. R. S. Ponter, A. D. Hearle and
/// K. L. Johnson 1985).
/// @throws base::InputError unless -1 < nu < 0.5
ContactLimits point_contact_limits(double poissons_ratio);

}  // namespace geneva::loads
