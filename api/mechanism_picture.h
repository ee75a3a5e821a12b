#pragma once

#include <string>

#include "model/input/case_file.h"
#include "model/mechanism_state.h"
#include "post/output/mechanism_output.h"

namespace geneva::api {

/// The mechanism over its cycle.
/// @param analysed the load of the instant that a run computes; none for the motion alone
post::MechanismDrawing mechanism_picture(const model::MechanismCase& given,
                                         const model::MechanismDynamics& dynamics,
                                         const std::optional<loads::PinLoad>& analysed);

/// mechanism.json of a case whose contact is not solved, with the instant that a run of it computes
/// where there is one.
std::string mechanism_text(const model::MechanismCase& given);

/// Pin and wheel of a mechanism where they touch.
loads::PinContact pin_contact(const model::MechanismCase& given,
                              const model::MechanismSizes& sizes);

}  // namespace geneva::api
