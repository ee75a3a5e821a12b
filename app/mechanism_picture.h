#pragma once

#include "app/case_file.h"
#include "app/mechanism_state.h"
#include "post/mechanism_output.h"

namespace geneva::app {

/// The mechanism over its cycle.
/// @param analysed the load of the instant that a run computes; none for the motion alone
post::MechanismDrawing mechanism_picture(const MechanismCase& given,
                                         const MechanismDynamics& dynamics,
                                         const std::optional<loads::PinLoad>& analysed);

/// Pin and wheel of a mechanism where they touch.
loads::PinContact pin_contact(const MechanismCase& given, const MechanismSizes& sizes);

}  // namespace geneva::app
