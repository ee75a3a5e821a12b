#pragma once

#include <string>
#include <vector>

#include "loads/wheel/outline.h"

namespace geneva::loads {

/// An outline in the planes z from bottom to top [m].
struct Extrusion {
  Outline outline;
  double bottom;
  double top;
};

/// Where a part of an assembly stands: turned about the z axis, then moved.
struct Placement {
  double angle;  ///< counter-clockwise [rad]
  Point origin;  ///< of the part's frame [m]
};

/// A part of extruded outlines that stand on each other and do not overlap, in its own frame.
struct SolidPart {
  std::string name;
  std::vector<Extrusion> extrusions;
  Placement placement;
};

/// V = sum over its extrusions of area times height [m^3].
/// @throws base::InputError where area_moments() does
double volume(const SolidPart& part);

/// The outline where the part stands in its assembly.
Outline placed(const Outline& outline, const Placement& placement);

}  // namespace geneva::loads
