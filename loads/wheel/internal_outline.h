#pragma once

#include "loads/wheel/internal_dimensions.h"
#include "loads/wheel/outline.h"

namespace geneva::loads {

/// The internal wheel in its own frame: axis at the origin, the engaged slot's centre line on +x.
///
/// Surfaces: "driving wall" (the wall at y = +slot_width/2 of the engaged slot, which the pin
/// pushes towards +y while the wheel accelerates, and the slot's whole round bottom, which
/// continues it), "opposite wall" (y = -slot_width/2 of that slot), "slots" (the other slots),
/// "locking arcs", "inner rim" (what is left of the cylinder of diameter D), "rim" (the outer one).
/// @throws base::InputError where check() does
Outline internal_wheel_outline(const InternalDimensions& dimensions);

/// The pin with its axis at pin_distance [m] along the engaged slot from the wheel's axis, touching
/// the driving wall, as pin_outline() draws it. Surfaces: "pin", "pin core".
/// @throws base::InputError where check() does, or if the pin is not beside the straight wall:
/// between its end at sqrt((D/2)^2 - (slot_width/2)^2) and c + r
Outline internal_pin_outline(const InternalDimensions& dimensions, double pin_distance);

/// J = density * thickness * polar moment of area [kg m^2] of the drawn wheel about its axis.
/// @throws base::InputError where check() does, or unless the density is positive and finite
double internal_wheel_inertia(const InternalDimensions& dimensions, double density);

}  // namespace geneva::loads
