#include "drawn_wheels.h"

#include <algorithm>
#include <utility>

#include "loads/wheel/internal_outline.h"
#include "mesher/outline_mesher.h"
#include "test_mesher.h"

namespace geneva::mesh::test {

namespace {

DrawnWheel drawn(const loads::CommonDimensions& dimensions, const double pin_distance,
                 const std::map<std::string, double>& wheel_radius,
                 std::vector<loads::Outline> outlines, const MeshSizing& sizing) {
  DrawnWheel result{dimensions, pin_distance, 0., wheel_radius, std::move(outlines), {}};
  result.radius["locking arcs"] = dimensions.locking_radius;
  result.radius["pin"] = dimensions.pin_diameter / 2.;
  result.radius["pin core"] = dimensions.pin_core_radius;
  for (const auto& [surface, radius] : result.radius) result.size = std::max(result.size, radius);
  // In this process: there are hundreds, and a mesher of its own for each would take a minute.
  result.mesh = mesher::mesh_outlines(result.outlines, sizing);
  check(result.mesh);
  return result;
}

}  // namespace

DrawnWheel meshed(const loads::GenevaDimensionsInput& input, const double way) {
  const loads::GenevaDimensions d = loads::complete_dimensions(input);
  const double nearest = d.centre_distance - d.crank_radius;
  const double distance = nearest + way * (loads::wall_end(d) - nearest);
  return drawn(d, distance, {{"rim", d.wheel_diameter / 2.}, {"bore", d.bore_radius}},
               {loads::wheel_outline(d), loads::pin_outline(d, distance)},
               default_sizing(d, distance));
}

DrawnWheel meshed(const loads::InternalDimensionsInput& input, const double way) {
  const loads::InternalDimensions d = loads::complete_internal_dimensions(input);
  const double nearest = loads::wall_end(d);
  const double distance = nearest + way * (d.centre_distance + d.crank_radius - nearest);
  return drawn(d, distance, {{"inner rim", d.wheel_diameter / 2.}, {"rim", d.rim_radius}},
               {loads::internal_wheel_outline(d), loads::internal_pin_outline(d, distance)},
               default_sizing(d, distance));
}

DrawnWheel meshed(const WheelType type, const int stations, const double diameter,
                  const double way) {
  return type == WheelType::external
             ? meshed(wheel_of<loads::GenevaDimensionsInput>(stations, diameter), way)
             : meshed(wheel_of<loads::InternalDimensionsInput>(stations, diameter), way);
}

const DrawnWheel& usual(const WheelType type, const int stations) {
  static std::map<std::pair<WheelType, int>, DrawnWheel> made;
  const auto found = made.find({type, stations});
  if (found != made.end()) return found->second;
  return made.emplace(std::pair{type, stations}, meshed(type, stations)).first->second;
}

}  // namespace geneva::mesh::test
