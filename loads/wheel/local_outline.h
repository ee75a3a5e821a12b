#pragma once

#include <vector>

#include "loads/wheel/outline.h"

namespace geneva::loads {

/// A pin on a block cut out of a slot's wall; lengths in metres.
struct LocalDimensions {
  double pin_diameter;     ///< d
  double pin_core_radius;  ///< of the pin's core, where it is held
  double width;            ///< of the block along the wall, not less than d
  double depth;            ///< of the block into the wall, not less than d/2
};

/// Refused: lengths not positive and finite; core not inside the pin; block narrower than the pin
/// or shallower than half of it.
/// @throws base::InputError with the numbers that clash and what to change
void check(const LocalDimensions& dimensions);

/// Block and pin that touch at the origin, material of the block at 0 <= y <= depth.
///
/// Body "wheel" is the block: surfaces "driving wall" (y = 0, |x| <= width/2), "back" (y = depth),
/// "sides" (x = -width/2 and +width/2). Body "pin" has its centre at (0, -d/2) and its first vertex
/// at the origin: surfaces "pin", "pin core".
/// @throws base::InputError where check() does
std::vector<Outline> local_outlines(const LocalDimensions& dimensions);

}  // namespace geneva::loads
