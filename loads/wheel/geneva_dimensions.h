#pragma once

#include "loads/wheel/common_dimensions.h"

namespace geneva::loads {

/// Dimensions of an external Geneva wheel, whose slots open outwards on the rim of diameter D.
struct GenevaDimensions : CommonDimensions {
  double bore_radius;  ///< of the hole at the wheel's axis [m]
};

/// Radius of the centre of the slots' semicircular bottom: D/2 - slot_depth + slot_width/2 [m].
double slot_bottom_centre(const GenevaDimensions& dimensions);

/// Checks that the proportions make one connected wheel with room for the pin.
///
/// Refused: stations outside 3..24; lengths not positive and finite; crank radius or centre
/// distance that do not belong to the wheel diameter; pin wider than the slot; core not inside the
/// pin; slot that does not reach the pin's nearest position; slot into bore, slots into each other,
/// locking arc into slot, locking arc into bore, locking arc that misses the rim.
/// @throws base::InputError with the numbers that clash and what to change
void check(const GenevaDimensions& dimensions);

}  // namespace geneva::loads
