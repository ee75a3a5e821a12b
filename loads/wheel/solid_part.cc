#include "loads/wheel/solid_part.h"

#include "loads/wheel/outline_shapes.h"

namespace geneva::loads {

double volume(const SolidPart& part) {
  double sum = 0.;
  for (const auto& [outline, bottom, top] : part.extrusions)
    sum += area_moments(outline).area * (top - bottom);
  return sum;
}

Outline placed(const Outline& outline, const Placement& placement) {
  const auto moved = [&](const Point& point) {
    const Point turned = rotated(point, placement.angle);
    return Point{turned.x + placement.origin.x, turned.y + placement.origin.y};
  };
  Outline result = outline;
  for (Loop& loop : result.loops)
    for (Segment& segment : loop) {
      segment.start = moved(segment.start);
      segment.end = moved(segment.end);
      if (segment.is_arc) segment.centre = moved(segment.centre);
    }
  return result;
}

}  // namespace geneva::loads
