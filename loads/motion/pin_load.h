#pragma once

#include <optional>
#include <vector>

#include "loads/motion/driven_mechanism.h"
#include "loads/motion/slip.h"
#include "loads/needle_bearing.h"

namespace geneva::loads {

/// What a Geneva wheel drives; SI units.
struct WheelLoad {
  double load_inertia;     ///< J_L [kg m^2], >= 0
  double friction_moment;  ///< M_f [N m], >= 0, opposes the motion
};

/// Where a roller turns on its stud.
struct RollerBore {
  double diameter;  ///< d_b [m], > 0, less than the pin's
  double friction;  ///< coefficient mu_b of roller and stud, >= 0
  std::optional<NeedleBearing> needles = std::nullopt;  ///< none: a plain bore or bush

  /// Diameter of the stud of a bore without clearance [m].
  [[nodiscard]] double stud() const {
    return needles ? stud_diameter(*needles, diameter) : diameter;
  }
};

/// Everything that loads the wheel and its pin at any instant; SI units.
struct WheelTrain {
  double wheel_inertia;         ///< J_G [kg m^2]
  WheelLoad load;               ///< load inertia, friction moment
  double external_torque = 0.;  ///< on the wheel, against its motion if positive [N m]
  double slot_friction = 0.;    ///< coefficient mu of slot wall and a pin fixed to its carrier
  double pin_diameter = 0.;     ///< d [m], which friction and slip need
  std::optional<RollerBore> roller = std::nullopt;  ///< none: the pin is fixed to its carrier
};

/// Force along the wall over the force across it: mu of a fixed pin, mu_b d_b/d of a roller.
///
/// A roller that rolls is turned on its stud against the moment mu_b F d_b/2 of its bore, by a
/// force along the wall at the arm d/2.
double friction_along_wall(const WheelTrain& train);

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
  double travel_speed;         ///< u' of the pin's axis along the slot, positive outwards [m/s]
  double pin_turn_speed;  ///< psi' of the pin's carrier seen from the wheel, see SlotMotion [rad/s]
  double slip_driving;    ///< of the pin's surface on the driving wall, positive outwards [m/s]
  double slip_braking;    ///< of the pin's surface on the braking wall, positive outwards [m/s]
  double slip_speed;      ///< on the wall that carries; 0 where none does [m/s]
  double bore_speed;      ///< at which a roller slides on its stud, >= 0; 0 of a fixed pin [m/s]
  double moment;          ///< that the pin exerts on the wheel [N m]
  double force;           ///< normal to the wall [N]; negative: on the braking wall
  Wall wall;
};

/// Pin force from the torque balance about the wheel's axis (Johnson 1956, Eq. 1 at any instant):
/// F = ((J_G + J_L) a + M_f sign(omega_w) + M_e)/(x - sign(v_s) mu d/2).
///
/// Friction acts on the wall, d/2 beside the pin's axis, along the slip v_s of a fixed pin's
/// surface on the wall that carries: it helps the force while the surface moves inwards and hinders
/// it while it moves outwards, on either wall. The moment, not the friction, decides which wall
/// carries, as long as the pin does not jam. A roller's bore friction acts the same way, with
/// friction_along_wall(), though the roller itself does not slide on the wall. The wheel's friction
/// counts as that of motion forwards where the wheel is just about to move.
/// @throws base::InputError unless a pin is in its slot
PinLoad pin_load(const MotionState& state, const WheelTrain& train);

/// @throws base::InputError unless the bore is greater than nothing and smaller than the
/// roller, and its coefficient of friction is not negative
void check(const RollerBore& bore, double pin_diameter);

/// @throws base::InputError if an inertia, the friction moment or the friction coefficient is
/// negative, where the check of a roller's bore does, or if friction jams the pin on either wall,
/// with the maximum coefficient at which it does not
void check(const WheelTrain& train, const DrivenMechanism& driven);

/// A maximum value over the engagements and the time at which it occurs.
struct Peak {
  double value;
  double time;  ///< [s]
};

/// The maximum value of a quantity over the engagements; the first of several equal ones. The time
/// is that of the maximum to about 1e-10 of the engagement; where the quantity jumps, it is on the
/// side of the greater value.
/// @param breaks driver angles [rad] from the middle of an engagement at which the quantity may
/// jump or have a kink, besides the mechanism's joints
Peak maximum(const DrivenMechanism& driven,
             const std::function<double(const MotionState&)>& quantity,
             const std::vector<double>& breaks = {});

/// Driver angles [rad] from the middle of an engagement at which slip changes its sign on a wall,
/// and with it friction.
std::vector<double> slip_breaks(const DrivenMechanism& driven, const WheelTrain& train);

/// Driver angle [rad] of the maximum force on the driving wall. With inertia alone it lies between
/// that of the maximum acceleration and the line of centres, since the arm still shrinks.
/// @throws base::InputError where check() does
double peak_force_angle(const DrivenMechanism& driven, const WheelTrain& train);

/// The maximum acceleration of the wheel forwards (Johnson's point) [rad/s^2]: before the line of
/// centres where the driver's speed is constant. Its time is where the jerk is 0, to roundings.
Peak peak_acceleration(const DrivenMechanism& driven);

/// Driver angle [rad] of it.
double peak_acceleration_angle(const DrivenMechanism& driven);

}  // namespace geneva::loads
