#pragma once

#include <optional>
#include <vector>

#include "loads/pin/pin_line.h"
#include "model/mechanism_state.h"
#include "post/output/estimate_output.h"

namespace geneva::api {

/// Pin force and contact pressure over the engagements, at about 60 driver angles: Hertz's of an
/// even load, and in 3-D that of line contacts along the pin where they know a peak, with the
/// wheel's twist of the analysed angle.
/// @param pin none where line contacts know no answer
std::vector<post::EngagementPoint> engagement(const model::MechanismCase& mechanism,
                                              const model::MechanismState& state,
                                              const std::optional<loads::PinLine>& pin);

}  // namespace geneva::api
