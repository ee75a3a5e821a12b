#pragma once

#include <optional>
#include <vector>

#include "api/limits.h"
#include "loads/motion/kinematics.h"
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

/// Contact pressures of a pin in 3-D by line contacts along it.
struct LinePressures {
  double analysed;             ///< at the analysed driver angle [Pa]
  loads::PlacedPeak of_cycle;  ///< greatest of the cycle, where the pin force of a wall is [Pa]
};

/// @return nothing in the plane, and where line contacts know no peak: the pressure of an even
/// load, which bending, tilt and edges exceed, says nothing of what materials stand then
std::optional<LinePressures> line_pressures(const model::MechanismCase& mechanism,
                                            const model::MechanismState& state,
                                            const loads::Characteristics& cycle);

/// The greatest pressure of the cycle that limits are for: Hertz's in the plane, that of line
/// contacts in 3-D.
/// @return nothing where line_pressures() has nothing, and where nothing presses
std::optional<PlacedValue> limited_pressure(const model::MechanismCase& mechanism,
                                            const loads::Characteristics& cycle);

}  // namespace geneva::api
