#pragma once

#include "loads/motion/mechanism.h"

namespace geneva::loads {

/// Spherical Geneva: the axes of driver and wheel meet at the centre of a sphere on which the pin
/// moves, at any shaft angle S (Lecture 4 shows 90 deg).
///
/// With p the angle between the driver's axis and the pin, sin p = sin S sin(pi/n), and
/// tan phi = sin p sin theta/(cos p sin S - sin p cos S cos theta); the pin is in the slot while
/// cos theta > tan p/tan S. S -> 0 is the external, S -> 180 deg the internal Geneva.
/// @param stations 3..24
/// @param shaft_angle S [rad] between 0 and pi
/// @param radius of the sphere [m]
/// @throws base::InputError outside these ranges
Mechanism spherical_geneva(int stations, double shaft_angle, double radius);

}  // namespace geneva::loads
