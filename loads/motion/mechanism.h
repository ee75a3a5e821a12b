#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "loads/motion/jet.h"

namespace geneva::loads {

/// Wheel and pin while the pin is in its slot, as functions of one variable.
struct SlotMotion {
  Jet wheel_angle;    ///< phi [rad]: 0 midway through the engagement, growing
  Jet pin_distance;   ///< x [m] from the wheel's axis to the pin's: the arm of the pin force
  Jet slot_position;  ///< of the pin's axis along its slot [m], counted outwards
  Jet pin_turn;       ///< psi [rad] of the pin's carrier seen from the wheel, against the wheel's
                      ///< own sense of rotation; on a sphere about the pin's axis
  double friction_lever;  ///< arm of a force along the slot, per distance beside the pin's axis: 1
                          ///< in the plane, the cosine of the angle to the wheel's axis on a sphere
};

/// A mechanism whose pin turns a slotted wheel by one pitch 2 pi/n in each engagement: all that
/// loads and meshes need to know of it.
///
/// The driver angle is 0 midway through the engagement of the first pin; motion() gives that pin's
/// motion and holds from entry to exit. Beyond, the wheel rests and only pin_distance has a
/// meaning.
struct Mechanism {
  std::string name;            ///< as in "external Geneva with 6 stations"
  int stations;                ///< n
  double period;               ///< driver angle [rad] after which everything repeats: 2 pi, or more
  double entry;                ///< driver angle [rad] at which the pin enters its slot, < 0
  double exit;                 ///< driver angle [rad] at which it leaves it, > 0
  std::vector<double> joints;  ///< driver angles between entry and exit where acceleration jumps
  std::function<SlotMotion(double driver_angle)> motion;
};

/// Half the angle between slots, pi/n [rad].
double half_pitch(const Mechanism& mechanism);

/// Motion of a slot that always points at the pin, from the pin's place (x, y) [m] in a plane whose
/// origin is the wheel's axis.
/// @param x positive midway through the engagement
/// @param carrier_turn angle [rad] of what the pin is fixed to, against the wheel's sense of
/// rotation
SlotMotion slot_motion(const Jet& x, const Jet& y, const Jet& carrier_turn);

/// One pin's stay in a slot.
struct Engagement {
  double begin;     ///< driver angle [rad]
  double middle;    ///< driver angle [rad] at which this pin's own motion is at 0
  double end;       ///< driver angle [rad]
  std::size_t pin;  ///< index in the list of pins
};

/// The engagements of one period in the order of their driver angle, the first pin's around 0 among
/// them.
/// @param pin_angles driver angles [rad] at which the pins are midway through their engagements;
/// the first is 0
/// @throws base::InputError if two pins would be engaged together, with the minimum angle
/// between them and the maximum number of equally spaced pins; or if an angle is not finite
std::vector<Engagement> engagements(const Mechanism& mechanism,
                                    const std::vector<double>& pin_angles);

/// Driver angle [rad] at which a period is cut open: in the middle of the dwell before the first of
/// the engagements.
double cycle_begin(const Mechanism& mechanism, const std::vector<Engagement>& engagements);

/// Angles of equally spaced pins: 0, period/count, ...
/// @throws base::InputError unless count is 1 or more
std::vector<double> equally_spaced_pins(const Mechanism& mechanism, int count);

/// Maximum number of equally spaced pins of which no two are engaged together; 2 n/(n - 2) rounded
/// down for an external Geneva.
int most_pins(const Mechanism& mechanism);

/// Angle [rad, 0..pi/2] between the path of the pin and the slot at a driver angle: 0 where the pin
/// enters or leaves without a jump of the wheel's speed.
double tangency_defect(const Mechanism& mechanism, double driver_angle);

}  // namespace geneva::loads
