#pragma once

#include <string>
#include <variant>
#include <vector>

namespace geneva::loads {

/// A pin whose radius does not change.
struct Cylinder {};

/// A pin whose outline is a circular arc.
struct Crown {
  double radius;  ///< [m], > 0
};

/// Logarithmic profile after Lundberg (1939) in the form of Johns and Gohar (1981), by which an
/// elastic line contact of finite length carries its design load evenly.
struct LogarithmicProfile {
  double amplitude;   ///< A = F/(pi L E*) for the design load F [m], > 0
  double length;      ///< L over which the load is to be even [m], > 0
  double half_width;  ///< b of Hertz's contact at the design load [m], 0 < b < L
};

/// Profile by points, joined by straight lines.
struct ProfileTable {
  std::vector<double> places;  ///< z from the middle of the contact, increasing [m]
  std::vector<double> drops;   ///< by which the pin is smaller there [m]
};

using PinProfile = std::variant<Cylinder, Crown, LogarithmicProfile, ProfileTable>;

/// How the edge of a part is broken.
struct EdgeBreak {
  enum class Kind { sharp, chamfered, rounded };
  Kind kind = Kind::sharp;
  double size = 0.;  ///< leg of the 45 degree chamfer or radius [m]
};

/// What the pin's shape and position along its length add to the gap.
struct PinClearance {
  PinProfile profile;
  double tilt = 0.;       ///< [rad]; positive: the free end (z < 0) leans towards the wall
  double wall_half = 0.;  ///< half of the wheel's thickness [m]
  EdgeBreak wall_edge;    ///< of the slot, on both faces of the wheel
  double lower_end = 0.;  ///< z of the pin's ends [m]
  double upper_end = 0.;
  double pin_chamfer = 0.;  ///< leg of the 45 degree chamfer at the pin's free ends [m]; 0: none
  bool upper_is_free = false;

  /// Clearance at a place along the pin, counted from the middle of the wheel's thickness.
  ///
  /// Crown: R - sqrt(R^2 - z^2). Logarithmic: A ln(1/(1 - (1 - 0.3033 b/(L/2)) (2 z/L)^2)) (Johns
  /// and Gohar 1981), beyond z = L/2 followed along its tangent. Tilt: z tan(tilt).
  /// @param z [m]
  /// @return [m], >= 0 but for the tilt
  [[nodiscard]] double at(double z) const;
};

/// The profile that carries a load evenly.
/// @param force F [N], length L [m], contact_modulus E* [Pa], half_width b of Hertz's contact under
/// F/L [m], all positive
/// @throws base::InputError unless all are positive and finite and b < L
LogarithmicProfile logarithmic_profile(double force, double length, double contact_modulus,
                                       double half_width);

/// @throws base::InputError naming what is wrong: crown radius below the half-length that it
/// has to span, fewer than two points, places that do not increase
void check(const PinProfile& profile, double half_length);

}  // namespace geneva::loads
