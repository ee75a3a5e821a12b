#pragma once

#include <vector>

namespace geneva::loads {

/// A cylindrical length of a shaft.
struct ShaftSegment {
  double diameter;  ///< d = 2 b [m], > 0 (Johnson's b is the radius)
  double length;    ///< l [m], > 0
};

/// The shaft between the wheel and its load: segments of one material, one behind the other.
struct Shaft {
  std::vector<ShaftSegment> segments;  ///< at least one; their order plays no part
  double shear_modulus;                ///< G [Pa], > 0 (Johnson's E_s)
  double density;                      ///< [kg/m^3], > 0
};

/// Length [m] of a shaft of one diameter that twists as much: d^4 sum l_i/d_i^4 (Johnson 1956, the
/// sum in Eq. 13).
/// @param diameter of that shaft [m], > 0
/// @throws base::InputError without segments, or unless all lengths are positive and finite
double equivalent_length(const Shaft& shaft, double diameter);

/// Johnson 1956, Eq. 15: c = T/theta = (pi G/32)/(sum l_i/d_i^4) [N m/rad].
/// @throws base::InputError where equivalent_length() does, or unless the shear modulus is
/// positive and finite
double torsional_stiffness(const Shaft& shaft);

/// The shaft's own inertia about its axis, sum rho pi d_i^4 l_i/32 [kg m^2].
///
/// Johnson's step 2 adds all of it to the load's where it is appreciable: in Eq. 1, 8 and 9 the
/// shaft turns with the wheel as one rigid body. His Eq. 10 to 16 leave it out.
/// @throws base::InputError without segments, or unless all lengths and the density are
/// positive and finite
double shaft_inertia(const Shaft& shaft);

/// Free torsional vibration of the load on its shaft while the wheel is locked.
struct TorsionalVibration {
  double torque;     ///< T = J_L a_v [N m], when the pin leaves the slot (Eq. 10)
  double stiffness;  ///< c [N m/rad] (Eq. 15)
  double twist;      ///< theta = T/c = J_L a_v/G sum 32 l_i/(pi d_i^4) [rad] (Eq. 11 to 13)
  double frequency;  ///< f_n = sqrt(c/J_L)/(2 pi) [Hz] (Eq. 14)
  double energy;     ///< W = c theta^2/2 [J] (Eq. 16)

  /// Way of a point of the load at a radius [m] from one end to the other, 2 R theta [m].
  [[nodiscard]] double double_amplitude(double radius) const { return 2. * radius * twist; }
};

/// Johnson 1956, Eq. 10 to 16. The twist at exit is the amplitude as if the load then started from
/// rest; friction and the shaft's own inertia are left out, as by Johnson.
/// @param load_inertia J_L [kg m^2], > 0
/// @param exit_acceleration a_v [rad/s^2], >= 0: how fast the wheel slows down where the pin leaves
/// the slot, tan(pi/n) omega^2
/// @throws base::InputError outside these ranges, or where torsional_stiffness() does
TorsionalVibration torsional_vibration(const Shaft& shaft, double load_inertia,
                                       double exit_acceleration);

}  // namespace geneva::loads
