#pragma once

#include "loads/wheel/common_dimensions.h"

namespace geneva::loads {

/// Dimensions of an internal Geneva wheel: a ring whose slots open inwards on the inner rim of
/// diameter D.
struct InternalDimensions : CommonDimensions {
  double rim_radius;  ///< of the outer rim, where the wheel is held [m]
};

/// Radius of the centre of the slots' semicircular bottom: D/2 + slot_depth - slot_width/2 [m].
double slot_bottom_centre(const InternalDimensions& dimensions);

/// Checks that the proportions make one connected ring with room for the pin.
///
/// Refused: what check_common() refuses; slot that does not reach the pin's farthest position c + r
/// from the wheel's axis; slots into each other, slot through the rim, locking arc that misses the
/// inner rim, locking arc into slot.
/// @throws base::InputError with the numbers that clash and what to change
void check(const InternalDimensions& dimensions);

}  // namespace geneva::loads
