#pragma once

namespace geneva::loads {

/// A round pin as a beam that carries its force evenly over the wheel's thickness.
struct PinBeam {
  double diameter;         ///< d [m]
  double thickness;        ///< t of the wheel: the loaded length [m]
  double root_gap;         ///< from the wheel to where the pin is held [m], >= 0
  double overhang;         ///< beyond the wheel at the free end [m], >= 0; unused if held twice
  bool held_at_both_ends;  ///< on both sides of the wheel, at the same root gap
  double youngs_modulus;   ///< E [Pa]
  double poissons_ratio;   ///< nu
  double bore = 0.;        ///< diameter of a hollow pin's bore [m], >= 0, less than d
};

/// Shear coefficient kappa of a round beam with a bore: 6 (1 + nu)(1 + m)^2/((7 + 6 nu)(1 + m)^2 +
/// (20 + 12 nu) m), m the square of the bore's share of the radius; 6 (1 + nu)/(7 + 6 nu) of a
/// solid one (Cowper 1966).
double shear_coefficient(double poissons_ratio, double bore_share = 0.);

/// Timoshenko's beam with that shear coefficient.
struct BeamBending {
  double tip_deflection;  ///< of the free end; held twice: of the middle [m]
  double slope;           ///< of the cross-sections in the middle of the wheel [rad]; held twice: 0
  double root_moment;     ///< [N m]
  double root_stress;     ///< maximum bending stress at the root, M d/(2 I) [Pa]
  double root_force;      ///< Q across the pin at its root, held twice at each one [N]
  /// Maximum shear stress there, Q S/(I b) across the middle: 4/3 (1 + s + s^2)/(1 + s^2) Q/A, s
  /// the bore's share of the diameter [Pa]
  double root_shear;
};

/// @param force F > 0 [N]
/// @throws base::InputError unless diameter, thickness, force and E are positive, gaps and bore not
/// negative, the bore less than the diameter, all finite
BeamBending beam_bending(const PinBeam& pin, double force);

}  // namespace geneva::loads
