#pragma once

#include <vector>

#include "loads/motion/mechanism.h"

namespace geneva::loads {

/// Which wall of the slot the pin presses on.
enum class Wall {
  none,     ///< no force
  driving,  ///< the wall ahead in the wheel's sense of rotation
  braking   ///< the wall behind, where the wheel is slowed down
};

/// Speed [m/s] at which the surface of a pin that is fixed to its carrier slides along a wall,
/// positive outwards: u' + (d/2) psi' on the driving wall, u' - (d/2) psi' on the braking one, with
/// the speed u' of the pin's axis along the slot and the speed psi' at which its carrier turns.
///
/// The derivatives are with respect to whatever those of the jets are.
/// @param slot_position u [m], see SlotMotion
/// @param pin_turn psi [rad], see SlotMotion
/// @param pin_diameter d [m]
/// @return 0 on no wall
double surface_speed(const Jet& slot_position, const Jet& pin_turn, double pin_diameter, Wall wall);

/// Where a pin that is fixed to its carrier stops sliding one way on a wall and begins to slide the
/// other way.
struct SlipReversal {
  Wall wall;
  double driver_angle;  ///< [rad] from the middle of the engagement
};

/// All of an engagement, those of the driving wall first, in the order of their driver angles; the
/// motion of the driver does not change them.
/// @param pin_diameter d [m], 0 or more; 0: where the pin's axis turns back
std::vector<SlipReversal> slip_reversals(const Mechanism& mechanism, double pin_diameter);

}  // namespace geneva::loads
