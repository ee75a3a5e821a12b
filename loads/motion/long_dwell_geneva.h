#pragma once

#include "loads/motion/mechanism.h"

namespace geneva::loads {

/// How the two sprockets of a long-dwell Geneva lie.
enum class SprocketLine {
  along_line_of_centres,  ///< the second one behind the first, seen from the wheel
  across_line_of_centres  ///< side by side: between them the pin passes the wheel on a straight
};

/// Long-dwell Geneva: the pin is carried by a chain or belt around two equal sprockets, on two
/// straight stretches and two half circles (Lecture 4); the wheel rests while the pin makes the
/// round.
///
/// The driver angle is that of a sprocket: chain length over pitch radius r, so that a round takes
/// 2 pi + 2 a/r. Along the line of centres the pin turns the wheel on the first sprocket's circle,
/// whose axis is at r/sin(pi/n) from the wheel's. Across it, it enters on one circle, passes the
/// straight stretch and leaves on the other; the straight stretch is at
/// (r + (a/2) cos(pi/n))/sin(pi/n) - r from the wheel's axis, and the acceleration jumps at its
/// ends. With a = 0 both are the external Geneva.
/// @param stations 3..24
/// @param pitch_radius r [m] of the circle of the pin's axis around a sprocket
/// @param spacing a [m] of the sprockets' axes, 0 or more
/// @throws base::InputError outside these ranges
Mechanism long_dwell_geneva(int stations, double pitch_radius, double spacing, SprocketLine line);

}  // namespace geneva::loads
