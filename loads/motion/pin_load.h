#pragma once

#include <optional>
#include <vector>

#include "loads/motion/driven_mechanism.h"

namespace geneva::loads {

/// What a Geneva wheel drives; SI units.
struct WheelLoad {
  double load_inertia;     ///< J_L [kg m^2], >= 0
  double friction_moment;  ///< M_f [N m], >= 0, opposes the motion
};

/// Everything that loads the wheel and its pin at any instant; SI units.
struct WheelTrain {
  double wheel_inertia;         ///< J_G [kg m^2]
  WheelLoad load;               ///< load inertia, friction moment
  double external_torque = 0.;  ///< on the wheel, against its motion if positive [N m]
  double slot_friction = 0.;    ///< coefficient mu of pin and slot wall
  double pin_diameter = 0.;     ///< d [m], which slot friction needs
};

/// Which wall of the slot the pin presses on.
enum class Wall {
  none,     ///< no force
  driving,  ///< the wall ahead in the wheel's sense of rotation
  braking   ///< the wall behind, where the wheel is slowed down
};

/// State of wheel and pin at one driver angle; SI units.
struct PinLoad {
  double time;                 ///< [s]; 0 when the first pin passes the line of centres
  double driver_angle;         ///< theta [rad]
  double driver_speed;         ///< [rad/s]
  double driver_acceleration;  ///< [rad/s^2]
  double wheel_angle;          ///< of the engaged slot from the line of centres [rad]
  double wheel_speed;          ///< [rad/s]
  double wheel_acceleration;   ///< [rad/s^2]
  double pin_distance;         ///< wheel axis to pin axis, the arm of the pin force [m]
  double slip_speed;           ///< of the pin along the slot, positive outwards [m/s]
  double moment;               ///< that the pin exerts on the wheel [N m]
  double force;                ///< normal to the wall [N]; negative: on the braking wall
  Wall wall;
};

/// Pin force from the torque balance about the wheel's axis (Johnson 1956, Eq. 1 at any instant):
/// F = ((J_G + J_L) a + M_f sign(omega_w) + M_e)/(x - sign(slip) mu d/2).
///
/// Slot friction acts on the wall, d/2 beside the pin's axis, along the pin's slip: it helps the
/// force while the pin moves inwards and hinders it while it moves outwards, on either wall. The
/// wheel's friction counts as that of motion forwards where the wheel is just about to move.
/// @throws std::invalid_argument unless a pin is in its slot
PinLoad pin_load(const MotionState& state, const WheelTrain& train);

/// @throws std::invalid_argument if an inertia, the friction moment or the friction coefficient is
/// negative, or if slot friction jams the pin, with the greatest coefficient at which it does not
void check(const WheelTrain& train, const DrivenMechanism& driven);

/// A greatest value over the engagements and the time at which it occurs.
struct Peak {
  double value;
  double time;  ///< [s]
};

/// The greatest value of a quantity over the engagements; the first of several equal ones. The time
/// is that of the maximum to about 1e-10 of the engagement.
Peak greatest(const DrivenMechanism& driven,
              const std::function<double(const MotionState&)>& quantity);

/// Driver angle [rad] of the greatest force on the driving wall. With inertia alone it lies between
/// that of the greatest acceleration and the line of centres, since the arm still shrinks.
/// @throws std::invalid_argument where check() does
double peak_force_angle(const DrivenMechanism& driven, const WheelTrain& train);

/// Driver angle [rad] of the greatest acceleration of the wheel forwards (Johnson's point): before
/// the line of centres where the driver's speed is constant.
double peak_acceleration_angle(const DrivenMechanism& driven);

}  // namespace geneva::loads
