#pragma once

#include <vector>

#include "model/input/case_file.h"
#include "post/output/kinematics_output.h"

namespace geneva::api {

/// A roller beside a pin of the same diameter that is fixed to its carrier and slides on the wall
/// with the coefficient of friction that the roller has in its bore; nothing for a fixed pin, or
/// where that would jam.
/// @param roller of the mechanism as it is
std::vector<post::PinChoiceRow> roller_choice(const model::MechanismCase& mechanism,
                                              const loads::Characteristics& roller);

}  // namespace geneva::api
