#pragma once

#include <vector>

#include "post/output/cycle_fields.h"

namespace geneva::post {

/// The greatest contact pressure that passes each node of an instant's mesh, of a mechanism in the
/// plane: a node of a wall has the pressure of the moment when the pin stands
/// beside it, a node of the pin that when it faces the wall that carries.
/// @return 0 away from walls and pin, and where nothing passes
/// @param own instant whose nodes they are
/// @param turning bodies that move with the pin, by index
/// @param curve of the cycle, in the order of the motion
PressureEnvelope passing_pressure(const CycleFields& own, const std::vector<bool>& turning,
                                  const std::vector<CycleCurvePoint>& curve);

}  // namespace geneva::post
