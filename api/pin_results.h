#pragma once

#include <optional>
#include <vector>

#include "fem/solution.h"
#include "model/pin_in_space.h"
#include "post/analysis/run_report.h"
#include "post/analysis/stress.h"

namespace geneva::api {

/// How the pin bends; none if its core is held.
std::optional<post::PinBending> bending_of_pin(const model::MechanismCase& mechanism,
                                               const model::MechanismState& state,
                                               const fem::Solution<3>& solution,
                                               const std::vector<post::CellStress<3>>& cells);

/// What is reported of the pin.
post::PinReport pin_report(const model::MechanismCase& mechanism,
                           const model::MechanismState& state, const fem::Solution<3>& solution,
                           const std::vector<post::CellStress<3>>& cells);

}  // namespace geneva::api
