#pragma once

#include <string>
#include <vector>

#include "api/case.h"
#include "loads/motion/cycle_instants.h"
#include "model/mechanism_state.h"

namespace geneva::api {

/// Moves the first and last instants of every engagement off the rim, and leaves out what else
/// touches only that.
/// @return notes on them
std::vector<std::string> keep_off_rim(std::vector<loads::CycleInstant>& instants, const Case& given,
                                      const model::MechanismDynamics& dynamics);

}  // namespace geneva::api
