#include "loads/wheel/least_wall.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "loads/pi.h"

namespace geneva::loads {

namespace {

LeastWall least_of(const std::initializer_list<LeastWall> walls) {
  return std::min(walls,
                  [](const LeastWall& a, const LeastWall& b) { return a.thickness < b.thickness; });
}

}  // namespace

LeastWall least_wall(const GenevaDimensions& dimensions) {
  check(dimensions);
  const double half_pitch = pi / dimensions.stations;
  const double arc_end = half_pitch - locking_half_angle(dimensions);
  return least_of(
      {{dimensions.wheel_diameter / 2. * std::sin(arc_end) - dimensions.slot_width / 2.,
        "slot and locking arc, at the rim"},
       {2. * slot_bottom_centre(dimensions) * std::sin(half_pitch) - dimensions.slot_width,
        "neighbouring slots"},
       {dimensions.wheel_diameter / 2. - dimensions.slot_depth - dimensions.bore_radius,
        "slot and bore"},
       {dimensions.centre_distance - dimensions.locking_radius - dimensions.bore_radius,
        "locking arc and bore"}});
}

LeastWall least_wall(const InternalDimensions& dimensions) {
  check(dimensions);
  return least_of(
      {{dimensions.crank_radius - dimensions.slot_width / 2. - dimensions.locking_radius,
        "slot and locking arc"},
       {dimensions.rim_radius - dimensions.wheel_diameter / 2. - dimensions.slot_depth,
        "slot and rim"},
       {dimensions.rim_radius - dimensions.centre_distance - dimensions.locking_radius,
        "locking arc and rim"}});
}

}  // namespace geneva::loads
