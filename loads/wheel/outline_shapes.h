#pragma once

#include <string>

#include "loads/wheel/common_dimensions.h"
#include "loads/wheel/outline.h"

namespace geneva::loads {

/// The point turned about the origin by the angle [rad], counter-clockwise.
Point rotated(Point point, double angle);

Segment line(Point start, Point end, const std::string& surface);
Segment arc(Point start, Point end, Point centre, bool clockwise, const std::string& surface);

/// A full circle of four quarter arcs, from the vertex on top (direction +y).
Loop circle(Point centre, double radius, bool clockwise, const std::string& surface);

/// The pin: a ring of four quarter arcs from the vertex on top, with the core as its hole.
Outline pin_ring(Point centre, double diameter, double core_radius);

/// Distances [m] from the wheel's axis between which the pin is beside the straight wall, and what
/// is there.
struct PinRange {
  double least;
  const char* at_least;
  double maximum;
  const char* at_maximum;
};

/// The pin touching the driving wall at y = +slot_width/2.
/// @throws base::InputError if the pin distance [m] is not in the range
Outline pin_beside_wall(const CommonDimensions& dimensions, double pin_distance,
                        const PinRange& range);

}  // namespace geneva::loads
