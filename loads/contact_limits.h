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

/// A hard layer at the surface of a softer core.
struct HardenedLayer {
  double depth;           ///< [m]
  double yield_strength;  ///< of the layer [Pa]
};

/// The layer's yield strength [Pa] by its hardness H: H/3 (D. Tabor, The Hardness of Metals, 1951),
/// which holds for metals that harden little, as hardened steel.
/// @param hardness Vickers or Brinell number [kgf/mm^2]
double yield_strength_by_hardness(double hardness);

/// Of a line contact in plane strain. Shakedown, by Melan's theorem (K. L. Johnson 1985, 9.1): k
/// over the greatest shear xz below the surface, 4 k without friction; at the surface, which
/// decides with mu > 0.32, the residual stresses along x and y that make the greatest von Mises
/// stress of a pass least (that by Tresca, k/mu, is up to 8 % above it).
/// @param poissons_ratio of the body, -1 < nu < 0.5
/// @param friction coefficient mu of gross sliding, 0 <= mu <= 1
/// @throws base::InputError outside of these ranges
ContactLimits line_contact_limits(double poissons_ratio, double friction);

/// Peak pressures [Pa] of a line contact up to which neither layer nor core yields, and up to which
/// both shake down: those of the layer's strength, and of the core's with the greatest stresses at
/// and below the layer's depth, while half-width and pressure grow together.
/// @param core yield strength [Pa]
/// @param half_width_per_pressure b/p0 [m/Pa]
/// @throws base::InputError as line_contact_limits()
ContactLimits layered_line_limits(double poissons_ratio, double friction,
                                  const HardenedLayer& layer, double core,
                                  double half_width_per_pressure);

/// The same of a circular contact without friction. The core's shakedown is by the greatest
/// principal shear on the axis, which is above the shear that decides: on the safe side; it is at
/// least that of a body with the lesser strength throughout.
ContactLimits layered_point_limits(double poissons_ratio, const HardenedLayer& layer, double core,
                                   double radius_per_pressure);

/// Stresses on the axis of an elliptical contact over its peak pressure: along the long axis, along
/// the short one, along the depth (K. L. Johnson 1985, Eq. 3.70).
struct PrincipalStress {
  double along;
  double across;
  double deep;
};

/// @param axis_ratio b/a of the ellipse, > 0, < 1
/// @param depth z/b, >= 0
PrincipalStress axial_stress(double axis_ratio, double depth, double poissons_ratio);

/// Of an elliptical contact without friction: first yield on its axis; shakedown of a line, 4 k,
/// which is on the safe side (a circle has 4.68 k).
/// @param axis_ratio b/a, > 0, <= 1
/// @throws base::InputError outside of this range
ContactLimits ellipse_contact_limits(double axis_ratio, double poissons_ratio);

/// Of a circular contact without friction. Shakedown: 4.68 k (A. R. S. Ponter, A. D. Hearle and
/// K. L. Johnson 1985).
/// @throws base::InputError unless -1 < nu < 0.5
ContactLimits point_contact_limits(double poissons_ratio);

}  // namespace geneva::loads
