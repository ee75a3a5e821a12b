#include "loads/wheel/internal_outline.h"

#include <array>

#include "loads/pi.h"
#include "loads/require.h"
#include "loads/wheel/outline_shapes.h"

namespace geneva::loads {

namespace {

/// Vertices of one pitch, from the inner rim's corner with the slot's upper wall to the end of the
/// locking arc, clockwise around the wheel's axis.
std::array<Point, 8> pitch_vertices(const InternalDimensions& dimensions, double angle) {
  const double half_width = dimensions.slot_width / 2.;
  const double bottom = slot_bottom_centre(dimensions);
  const double end = wall_end(dimensions);
  const Point inner_rim{dimensions.wheel_diameter / 2., 0.};
  const double half_pitch = pi / dimensions.stations;
  const double half_locking = locking_half_angle(dimensions);
  std::array<Point, 8> vertices{
      {{end, half_width},
       {bottom, half_width},
       {bottom + half_width, 0.},
       {bottom, -half_width},
       {end, -half_width},
       rotated(inner_rim, half_locking - half_pitch),
       rotated({dimensions.centre_distance + dimensions.locking_radius, 0.}, -half_pitch),
       rotated(inner_rim, -half_locking - half_pitch)}};
  for (Point& vertex : vertices) vertex = rotated(vertex, angle);
  return vertices;
}

/// The ring's hole, clockwise. The locking arc is more than half a turn: its centre lies outside
/// the inner rim, (r^2 + R^2)/(2 c) beyond the chord. It is divided in its middle.
Loop inner_boundary(const InternalDimensions& dimensions) {
  const double pitch = 2. * pi / dimensions.stations;
  const Point axis{0., 0.};
  Loop loop;
  for (int slot = 0; slot < dimensions.stations; ++slot) {
    const double angle = -slot * pitch;
    const auto vertices = pitch_vertices(dimensions, angle);
    // the very numbers of the next slot, so that the loop closes without a gap
    const auto next = pitch_vertices(dimensions, -((slot + 1) % dimensions.stations) * pitch);
    const Point bottom = rotated({slot_bottom_centre(dimensions), 0.}, angle);
    const Point locking = rotated({dimensions.centre_distance, 0.}, angle - pitch / 2.);
    const bool engaged = slot == 0;
    loop.push_back(line(vertices[0], vertices[1], engaged ? "driving wall" : "slots"));
    loop.push_back(arc(vertices[1], vertices[2], bottom, true, engaged ? "driving wall" : "slots"));
    loop.push_back(arc(vertices[2], vertices[3], bottom, true, engaged ? "driving wall" : "slots"));
    loop.push_back(line(vertices[3], vertices[4], engaged ? "opposite wall" : "slots"));
    loop.push_back(arc(vertices[4], vertices[5], axis, true, "inner rim"));
    loop.push_back(arc(vertices[5], vertices[6], locking, true, "locking arcs"));
    loop.push_back(arc(vertices[6], vertices[7], locking, true, "locking arcs"));
    loop.push_back(arc(vertices[7], next[0], axis, true, "inner rim"));
  }
  return loop;
}

}  // namespace

Outline internal_wheel_outline(const InternalDimensions& dimensions) {
  check(dimensions);
  return {"wheel",
          {circle({0., 0.}, dimensions.rim_radius, false, "rim"), inner_boundary(dimensions)}};
}

Outline internal_pin_outline(const InternalDimensions& dimensions, double pin_distance) {
  check(dimensions);
  return pin_beside_wall(
      dimensions, pin_distance,
      {wall_end(dimensions), "end of the wall",
       dimensions.centre_distance + dimensions.crank_radius, "farthest position"});
}

double internal_wheel_inertia(const InternalDimensions& dimensions, double density) {
  require_positive("density", density, "kg/m^3");
  return density * dimensions.thickness *
         area_moments(internal_wheel_outline(dimensions)).polar_moment;
}

}  // namespace geneva::loads
