#include "post/output/mechanism_output.h"

#include <nlohmann/json.hpp>

#include "base/json_values.h"

namespace geneva::post {

using base::finite;
using base::quantity;

using nlohmann::json;

namespace {

json place(const loads::Place& at) { return json::array({at.x, at.y, at.z}); }

json polyline(const loads::Polyline& line) {
  json list = json::array();
  for (const loads::Place& at : line) list.push_back(place(at));
  return list;
}

json step_section(const MechanismStep& step) {
  const loads::MotionState& motion = step.row.motion;
  json pins = json::array();
  for (const loads::Place& pin : step.pins) pins.push_back(place(pin));
  json section{{"time", motion.time},
               {"driver_angle", motion.driver_angle.value},
               {"wheel_angle", motion.wheel_angle.value},
               {"wheel_speed", finite(motion.wheel_angle.first)},
               {"wheel_acceleration", finite(motion.wheel_angle.second)},
               {"pin_force", finite(step.row.load.force)},
               {"pins", pins}};
  section["engaged_pin"] = motion.pin ? json(*motion.pin) : json();
  if (!step.linkage.empty()) section["linkage"] = polyline(step.linkage);
  return section;
}

}  // namespace

json mechanism_document(const MechanismDrawing& drawing) {
  json wheel = json::array();
  for (const loads::Polyline& loop : drawing.wheel) wheel.push_back(polyline(loop));
  json lengths = json::array();
  for (const NamedLength& length : drawing.lengths)
    lengths.push_back({{"name", length.name}, {"length", quantity(length.value, "m")}});
  json steps = json::array();
  for (const MechanismStep& step : drawing.steps) steps.push_back(step_section(step));
  json document{{"name", drawing.name},
                {"wheel", wheel},
                {"pin_path", polyline(drawing.pin_path)},
                {"pin_diameter", drawing.pin_diameter},
                {"lengths", lengths},
                {"steps", steps}};
  if (drawing.driver_axis) document["driver_axis"] = place(*drawing.driver_axis);
  if (drawing.locking_radius) document["locking_radius"] = *drawing.locking_radius;
  if (drawing.analysed) document["analysed"] = step_section(*drawing.analysed);
  return document;
}

}  // namespace geneva::post
