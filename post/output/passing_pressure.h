#pragma once

#include <vector>

#include "post/output/cycle_fields.h"
#include "post/output/cycle_output.h"
#include "post/output/envelope.h"

namespace geneva::post {

/// The contact that passes each node of an instant's mesh, of a mechanism in the plane.
struct PassingContact {
  PressureEnvelope greatest;     ///< peak pressures; 0 where none passes
  std::vector<double> depth;     ///< of the node below wall or round pin [m], >= 0
  std::vector<bool> is_surface;  ///< whether the node is on the wall or round the pin
};

/// A node of the wheel has the contact of the moment when the pin stands beside it, a node of the
/// pin that when it faces the wall that carries.
/// @param own instant whose nodes they are
/// @param turning bodies that move with the pin, by index
/// @param curve of the cycle, in the order of the motion
/// @param reach greatest depth of a node [m], >= 0: nodes of the two bodies that touch
PassingContact passing_contact(const CycleFields& own, const std::vector<bool>& turning,
                               const std::vector<CycleCurvePoint>& curve, double reach);

/// The pressure at the nodes of walls and pin alone.
PressureEnvelope surface_pressure(PassingContact passing);

}  // namespace geneva::post
