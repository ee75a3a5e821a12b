#pragma once

#include <string>
#include <vector>

#include "loads/wheel/solid_part.h"
#include "model/mechanism_state.h"

namespace geneva::model {

/// The drawn parts of a mechanism, each placed in the frame of the mechanism: the wheel's axis at
/// the origin, the driver's on +x, the wheel's middle plane at z = 0.
struct MechanismParts {
  std::vector<loads::SolidPart> parts;  ///< wheel, driver, and a pin (roller, stud) for each pin
  std::vector<std::string> notices;     ///< what is drawn otherwise than the case says, or not
};

/// Wheel, driver and pins as solids of their nominal sizes.
///
/// The wheel stands with a slot on its +x at wheel angle 0. The driver is a plate of the wheel's
/// thickness at the pin's root, as wide as holds the pins, with a hole for each, and on it the
/// locking disc, see loads::locking_disc(). Profiles and chamfers of pins are not drawn.
/// @param driver_angle from midway through the first pin's engagement [rad]
/// @throws base::InputError if the whole wheel of the type is not known, or is not to be drawn
MechanismParts mechanism_parts(const MechanismCase& mechanism, double driver_angle);

}  // namespace geneva::model
