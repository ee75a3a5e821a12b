#pragma once

#include "loads/external_geneva.h"
#include "loads/johnson.h"

namespace geneva::loads {

/// Drive of the mechanism at the instant looked at.
struct DriverMotion {
  double speed;         ///< omega > 0 [rad/s]
  double acceleration;  ///< d omega/dt [rad/s^2]
};

/// State of wheel and pin at one driver angle; SI units.
struct PinLoad {
  double driver_angle;        ///< theta from the line of centres [rad]
  double wheel_angle;         ///< phi [rad]
  double wheel_speed;         ///< [rad/s]
  double wheel_acceleration;  ///< [rad/s^2]
  double pin_distance;        ///< wheel axis to pin axis, the arm of the pin force [m]
  double force;               ///< on the driving wall [N]; negative: the opposite wall carries
};

/// Pin force at any driver angle from the torque balance about the wheel's axis (Johnson 1956, Eq.
/// 1 at any instant).
/// @throws std::invalid_argument if |driver_angle| exceeds the engagement angle (named with its
/// value in degrees), if the driver's speed or the centre distance is not positive, or where
/// pin_force() does
PinLoad pin_load(const ExternalGeneva& geneva, double centre_distance, const DriverMotion& motion,
                 double wheel_inertia, const WheelLoad& load, double driver_angle);

/// Driver angle [rad] of the greatest pin force over the engagement (it comes after that of the
/// greatest acceleration, since the arm still shrinks); found to 1e-10 rad. The driver's speed and
/// acceleration are taken as the same all along; without driver acceleration and with M_f = 0 the
/// angle is negative, before the line of centres.
/// @throws std::invalid_argument unless wheel_inertia is positive, or where pin_load() does
double peak_force_angle(const ExternalGeneva& geneva, double centre_distance,
                        const DriverMotion& motion, double wheel_inertia, const WheelLoad& load);

}  // namespace geneva::loads
