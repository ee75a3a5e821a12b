#pragma once

#include <optional>

#include "loads/hertz.h"
#include "loads/motion/mechanism.h"
#include "loads/motion/pin_load.h"
#include "loads/wheel/geneva_dimensions.h"
#include "loads/wheel/internal_dimensions.h"

namespace geneva::loads {

/// A row of Johnson's Table 1 (Ray C. Johnson, 1956).
struct JohnsonRow {
  int stations;
  double peak_acceleration_angle;  ///< beta [rad], computed (Eq. 5.34)
  double peak_acceleration_ratio;  ///< a_max/omega^2, computed (Eq. 5.32)
  double exit_acceleration_ratio;  ///< a_v/omega^2 = tan(pi/n), computed
  double k;                        ///< arm of the pin force at beta / D, computed
  double k2;                       ///< pin diameter / D
  double k3;                       ///< wheel thickness / D
  double k4;                       ///< locking radius / D
  std::optional<double> k5;        ///< J_G g/(w D^5); Johnson gives it for n = 3..10 only
  bool from_table;  ///< false: n > 10, k2..k4 are those of n = 10 scaled with sin(pi/n)
};

/// @param stations n, 3..24
/// @throws base::InputError outside that range
JohnsonRow johnson_row(int stations);

/// Lengths of a mechanism that follow from each other, whatever its type.
struct MechanismSizes {
  double wheel_diameter;  ///< D [m]: twice the pin's distance from the wheel's axis at entry
  double pin_diameter;    ///< [m]
  double thickness;       ///< of the wheel [m]
};

/// Pin diameter k2 D and thickness k3 D where they are not given; Johnson gives k2 and k3 for
/// external wheels.
/// @param pin_diameter, thickness [m]
MechanismSizes mechanism_sizes(const Mechanism& mechanism,
                               const std::optional<double>& pin_diameter,
                               const std::optional<double>& thickness);

/// k5 of a row. @throws base::InputError if it has none, beyond 10 stations
double johnson_k5(const JohnsonRow& row);

/// Eq. 1: F = ((J_G + J_L) a + M_f)/arm [N]; negative where the opposite wall would carry.
/// @throws base::InputError if an inertia or the friction is negative or the arm not positive
double pin_force(double wheel_inertia, const WheelLoad& load, double wheel_acceleration,
                 double arm);

/// Eq. 6: J_G = k5 rho D^5 [kg m^2] (w/g is the mass density rho [kg/m^3]).
/// @throws base::InputError unless all are positive and finite
double johnson_wheel_inertia(double k5, double density, double wheel_diameter);

/// Eq. 2 and 3 with the exact factor sqrt(2/pi): s = sqrt(2/pi) sqrt(E*) sqrt(F/(t d)) [Pa].
/// @throws base::InputError unless force and lengths are positive and finite
double johnson_stress(double force, double thickness, double pin_diameter, const Elastic& pin,
                      const Elastic& wheel);

/// Eq. 8: s(D) [Pa] of a wheel with the proportions of a row that has k5.
/// @throws base::InputError if the row has none, or where the functions above do
double johnson_stress_of_diameter(double wheel_diameter, const JohnsonRow& row,
                                  const WheelLoad& load, double peak_acceleration, double density,
                                  const Elastic& pin, const Elastic& wheel);

/// Eq. 9: J_G = 1.5 (J_L + M_f/a) [kg m^2], the wheel inertia of the minimum contact stress.
/// @throws base::InputError unless the peak acceleration is positive and finite
double optimum_wheel_inertia(const WheelLoad& load, double peak_acceleration);

/// Eq. 9 with Eq. 6: the diameter D [m] of the optimum wheel.
double optimum_wheel_diameter(const WheelLoad& load, double peak_acceleration, double k5,
                              double density);

/// Inertia of a solid cylinder about its axis: rho pi D^4 L/32 [kg m^2].
/// @throws base::InputError unless all are positive and finite
double solid_cylinder_inertia(double diameter, double length, double density);

/// What a designer may give of either kind of wheel; missing ones take their default.
struct CommonDimensionsInput {
  int stations;
  std::optional<double> wheel_diameter;   ///< [m]; exactly one of this and the next two
  std::optional<double> crank_radius;     ///< [m]
  std::optional<double> centre_distance;  ///< [m]
  std::optional<double> pin_diameter;     ///< [m]; default k2 D
  std::optional<double> thickness;        ///< [m]; default k3 D
  std::optional<double> slot_clearance;   ///< [m]; default 0
  std::optional<double> slot_width;       ///< [m]; default pin diameter + clearance
  std::optional<double> slot_depth;       ///< [m]; default: the bottom's centre at the pin's turn
  std::optional<double> locking_radius;   ///< [m]; default k4 D
  std::optional<double> pin_core_radius;  ///< [m]; default pin diameter/4
};

/// An external wheel; the default slot depth is D/2 - (c - r) + slot_width/2.
struct GenevaDimensionsInput : CommonDimensionsInput {
  std::optional<double> bore_radius;  ///< [m]; default min(0.1 D, half the slots' lowest radius)
};

/// An internal wheel; the default slot depth is c + r - D/2 + slot_width/2.
struct InternalDimensionsInput : CommonDimensionsInput {
  std::optional<double> rim_radius;  ///< [m]; default D/2 + slot_depth + 0.15 D
};

/// Fills in the defaults and checks the result.
/// @throws base::InputError if not exactly one size is given, both slot width and clearance
/// are given, or check() refuses the wheel
GenevaDimensions complete_dimensions(const GenevaDimensionsInput& input);

/// The same for an internal wheel: Johnson's proportions, which he gives for external ones.
/// @throws base::InputError as complete_dimensions()
InternalDimensions complete_internal_dimensions(const InternalDimensionsInput& input);

}  // namespace geneva::loads
