#pragma once

#include "loads/motion/mechanism.h"

namespace geneva::loads {

/// Internal Geneva: a ring wheel with slots opening inwards, turned by a driver inside it in the
/// driver's own sense (Lecture 4; dphi/dtheta = s (cos theta + s)/(1 + s^2 + 2 s cos theta), with
/// s = sin(pi/n) and theta = 0 where the pin is farthest from the wheel's axis).
///
/// The pin is in the slot for pi + 2 pi/n of the driver's turn, from sqrt(c^2 - r^2) to c + r from
/// the wheel's axis.
/// @param stations 3..24
/// @param centre_distance c [m]; the crank is c sin(pi/n)
/// @throws base::InputError outside that range, or if the distance is not positive
Mechanism internal_geneva(int stations, double centre_distance);

}  // namespace geneva::loads
