#include "loads/wheel/outline_shapes.h"

#include <array>
#include <cmath>

#include "loads/wheel/refuse.h"

namespace geneva::loads {

Point rotated(Point point, double angle) {
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  return {cosine * point.x - sine * point.y, sine * point.x + cosine * point.y};
}

Segment line(Point start, Point end, const std::string& surface) {
  return {start, end, false, {0., 0.}, false, surface};
}

Segment arc(Point start, Point end, Point centre, bool clockwise, const std::string& surface) {
  return {start, end, true, centre, clockwise, surface};
}

Loop circle(Point centre, double radius, bool clockwise, const std::string& surface) {
  const double side = clockwise ? radius : -radius;
  const std::array<Point, 4> vertices{{{centre.x, centre.y + radius},
                                       {centre.x + side, centre.y},
                                       {centre.x, centre.y - radius},
                                       {centre.x - side, centre.y}}};
  Loop loop;
  for (std::size_t i = 0; i < 4; ++i)
    loop.push_back(arc(vertices[i], vertices[(i + 1) % 4], centre, clockwise, surface));
  return loop;
}

Outline pin_ring(Point centre, double diameter, double core_radius) {
  return {
      "pin",
      {circle(centre, diameter / 2., false, "pin"), circle(centre, core_radius, true, "pin core")}};
}

Outline pin_beside_wall(const CommonDimensions& dimensions, double pin_distance,
                        const PinRange& range) {
  const double rounding = dimension_rounding * dimensions.wheel_diameter;
  if (!(pin_distance >= range.least - rounding && pin_distance <= range.maximum + rounding))
    refuse(
        "pin distance is {:.6g} mm: the pin touches the driving wall from {:.6g} mm ({}) to "
        "{:.6g} mm ({}); choose a driver angle nearer to the middle of the engagement",
        mm(pin_distance), mm(range.least), range.at_least, mm(range.maximum), range.at_maximum);
  return pin_ring({pin_distance, (dimensions.slot_width - dimensions.pin_diameter) / 2.},
                  dimensions.pin_diameter, dimensions.pin_core_radius);
}

}  // namespace geneva::loads
