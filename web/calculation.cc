#include "web/calculation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "base/errors.h"
#include "loads/design/design.h"
#include "loads/drawing/mechanism_drawing.h"
#include "loads/motion/external_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/motion/kinematics.h"
#include "loads/motion/spherical_geneva.h"
#include "loads/require.h"
#include "loads/wheel/internal_outline.h"
#include "loads/wheel/outline.h"

namespace geneva::web {

using nlohmann::json;

namespace {

using DrawnWheel = std::variant<loads::GenevaDimensions, loads::InternalDimensions>;

constexpr int steps_of_cycle = 360;
constexpr int steps_of_path = 240;

int whole_number(const json& value, const char* quantity) {
  const auto number = value.get<double>();
  constexpr double greatest = 1e6;
  if (std::abs(number) < greatest && number == std::floor(number)) return static_cast<int>(number);
  throw base::InputError(fmt::format("{} is {:.6g}: a whole number is wanted", quantity, number));
}

Kind kind_named(const std::string& name) {
  if (name == "external") return Kind::external;
  if (name == "internal") return Kind::internal;
  if (name == "spherical") return Kind::spherical;
  if (name == "long dwell") return Kind::long_dwell;
  throw base::InputError(fmt::format(
      "type is '{}': one of external, internal, spherical, long dwell is wanted", name));
}

std::optional<double> optional_number(const json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

loads::Elastic elastic(const json& material) {
  return {material.at("youngs_modulus").get<double>(), material.at("poissons_ratio").get<double>()};
}

loads::Mechanism mechanism_of(const Inputs& inputs) {
  switch (inputs.kind) {
    case Kind::internal:
      return loads::internal_geneva(inputs.stations, inputs.size);
    case Kind::spherical:
      return loads::spherical_geneva(inputs.stations, inputs.shaft_angle, inputs.size);
    case Kind::long_dwell:
      return loads::long_dwell_geneva(inputs.stations, inputs.size, inputs.sprocket_spacing,
                                      inputs.sprockets);
    case Kind::external:
      break;
  }
  return loads::external_geneva(inputs.stations, inputs.size);
}

loads::GenevaDimensionsInput dimensions_of(const Inputs& inputs) {
  loads::GenevaDimensionsInput dimensions{};
  dimensions.stations = inputs.stations;
  dimensions.centre_distance = inputs.size;
  dimensions.pin_diameter = inputs.pin_diameter;
  dimensions.thickness = inputs.thickness;
  dimensions.slot_clearance = inputs.slot_clearance;
  return dimensions;
}

/// None of the mechanisms whose wheel is not drawn.
std::optional<DrawnWheel> drawn_wheel(const Inputs& inputs) {
  if (inputs.kind == Kind::external) return loads::complete_dimensions(dimensions_of(inputs));
  if (inputs.kind == Kind::internal)
    return loads::complete_internal_dimensions({dimensions_of(inputs), std::nullopt});
  return std::nullopt;
}

const loads::CommonDimensions& common(const DrawnWheel& wheel) {
  return std::visit([](const auto& one) -> const loads::CommonDimensions& { return one; }, wheel);
}

double inertia_of(const Inputs& inputs, const std::optional<DrawnWheel>& wheel) {
  if (inputs.wheel_inertia || !wheel) {
    const double inertia = inputs.wheel_inertia.value_or(0.);
    loads::require_positive("wheel inertia", inertia, "kg m^2");
    return inertia;
  }
  if (const auto* external = std::get_if<loads::GenevaDimensions>(&*wheel))
    return loads::wheel_inertia(*external, inputs.wheel_density);
  return loads::internal_wheel_inertia(std::get<loads::InternalDimensions>(*wheel),
                                       inputs.wheel_density);
}

/// A mechanism that moves, with all that loads it.
struct Loaded {
  loads::DrivenMechanism driven;
  std::vector<double> pin_angles;  ///< [rad], see loads::engagements()
  loads::MechanismSizes sizes;
  std::optional<DrawnWheel> wheel;
  loads::WheelTrain train;
  loads::PinContact contact;
};

Loaded loaded(const Inputs& inputs) {
  const loads::Mechanism mechanism = mechanism_of(inputs);
  if (inputs.pin_diameter) loads::require_positive_length("pin diameter", *inputs.pin_diameter);
  if (inputs.thickness) loads::require_positive_length("wheel thickness", *inputs.thickness);
  const std::optional<DrawnWheel> wheel = drawn_wheel(inputs);
  const std::vector<double> pins = loads::equally_spaced_pins(mechanism, inputs.pins);
  const std::vector<loads::Engagement> engagements = loads::engagements(mechanism, pins);
  const loads::MechanismSizes sizes =
      loads::mechanism_sizes(mechanism, inputs.pin_diameter, inputs.thickness);
  loads::WheelTrain train{inertia_of(inputs, wheel), inputs.load};
  train.slot_friction = inputs.slot_friction;
  train.pin_diameter = sizes.pin_diameter;
  return {{mechanism, engagements,
           loads::constant_acceleration(mechanism, engagements, inputs.driver_speed, 0.)},
          pins,
          sizes,
          wheel,
          train,
          {loads::contact_modulus(inputs.pin, inputs.wheel), sizes.thickness, sizes.pin_diameter}};
}

/// What is 0 all the way has no place.
void add_peak(json& section, const std::string& name, const loads::PlacedPeak& peak) {
  section[name] = peak.value;
  section[name + "_angle"] = peak.value > 0. ? json(peak.driver_angle) : json();
}

json kinematics_section(const Loaded& mechanism, const loads::Characteristics& values) {
  json section{{"entry_acceleration_ratio", values.entry_acceleration_ratio},
               {"jerk_ratio_at_centre", values.jerk_ratio_at_centre},
               {"engagement_angle", values.engagement_angle},
               {"motion_time", values.motion_time},
               {"dwell_time", values.dwell_times},
               {"motion_fraction", values.motion_fraction},
               {"time_ratio", values.time_ratio},
               {"entry_tangency", values.entry_tangency},
               {"exit_tangency", values.exit_tangency}};
  add_peak(section, "peak_speed_ratio", values.speed_ratio);
  add_peak(section, "peak_acceleration_ratio", values.acceleration_ratio);
  section["peak_acceleration_angle"] = values.acceleration_ratio.driver_angle;
  section["peak_jerk_ratio"] = values.jerk_ratio.value;
  section["peak_jerk_angle"] = values.jerk_ratio.driver_angle;
  add_peak(section, "peak_force", values.force);
  add_peak(section, "peak_braking_force", values.braking_force);
  add_peak(section, "peak_hertz_pressure", values.pressure);
  add_peak(section, "peak_pressure_times_slip", values.pressure_times_slip);
  add_peak(section, "peak_slip_speed", values.slip_speed);
  section["unbounded"] = json::array();
  for (const loads::Unbounded& place : mechanism.driven.unbounded())
    section["unbounded"].push_back({{"quantity", place.quantity},
                                    {"driver_angle", place.driver_angle},
                                    {"cause", place.cause}});
  return section;
}

/// Where the pressure is greatest over the cycle, on either wall; null without any force.
json hertz_section(const Loaded& mechanism, const loads::Characteristics& values) {
  const loads::PlacedPeak& peak =
      values.braking_force.value > values.force.value ? values.braking_force : values.force;
  if (!(peak.value > 0.)) return {};
  const loads::HertzLine hertz =
      loads::hertz_line(peak.value / mechanism.contact.thickness,
                        mechanism.contact.pin_diameter / 2., mechanism.contact.contact_modulus);
  return {{"force", peak.value},
          {"driver_angle", peak.driver_angle},
          {"peak_pressure", hertz.peak_pressure},
          {"half_width", hertz.half_width},
          {"max_shear", hertz.max_shear},
          {"max_shear_depth", hertz.max_shear_depth}};
}

json wheel_section(const loads::DesignedWheel& wheel) {
  return {{"diameter", wheel.diameter},
          {"pin_diameter", wheel.pin_diameter},
          {"thickness", wheel.thickness},
          {"locking_radius", wheel.locking_radius},
          {"inertia", wheel.inertia},
          {"force", wheel.force},
          {"peak_pressure", wheel.peak_pressure}};
}

/// The given wheel as Johnson sees it: at its maximum acceleration, without friction of the pin.
loads::DesignedWheel own_wheel(const Inputs& inputs, const Loaded& mechanism) {
  loads::WheelTrain train = mechanism.train;
  train.slot_friction = 0.;
  const loads::PinLoad load = loads::pin_load(
      mechanism.driven.at_engaged_angle(loads::peak_acceleration_angle(mechanism.driven)), train);
  const loads::CommonDimensions& wheel = common(*mechanism.wheel);
  return {wheel.wheel_diameter,
          wheel.pin_diameter,
          wheel.thickness,
          wheel.locking_radius,
          train.wheel_inertia,
          load.force,
          loads::johnson_stress(load.force, wheel.thickness, wheel.pin_diameter, inputs.pin,
                                inputs.wheel)};
}

json curve_section(const loads::DesignInput& design, const double best) {
  constexpr double first = 0.3;
  constexpr double last = 3.;
  constexpr int steps = 100;
  const auto pressure = [](const std::optional<loads::DesignedWheel>& wheel) {
    return wheel ? json(wheel->peak_pressure) : json();
  };
  json curve = json::array();
  for (const loads::DesignPoint& point :
       loads::design_curve(design, first * best, last * best, steps))
    curve.push_back({point.diameter, pressure(point.johnson), pressure(point.drawn)});
  return curve;
}

/// Johnson's wheel of the least contact stress; why there is none, where there is none.
json design_section(const Inputs& inputs, const Loaded& mechanism) try {
  if (inputs.kind != Kind::external || inputs.pins != 1)
    throw base::InputError(
        "Johnson's equations are those of an external Geneva with one pin at constant driver "
        "speed");
  const loads::DesignInput design{dimensions_of(inputs), loads::GivenLengths::scale, inputs.load,
                                  inputs.driver_speed,   inputs.wheel_density,       inputs.pin,
                                  inputs.wheel};
  const auto johnson = loads::johnson_optimum(design);
  const loads::DrawnOptimum drawn = loads::drawn_optimum(design);
  json section{{"own", wheel_section(own_wheel(inputs, mechanism))},
               {"drawn", wheel_section(drawn.wheel)},
               {"inertia_ratio", drawn.inertia_ratio},
               {"curve", curve_section(design, johnson.value_or(drawn.wheel).diameter)}};
  section["johnson"] = johnson ? wheel_section(*johnson) : json();
  return section;
} catch (const base::InputError& error) {
  return {{"refused", error.what()}};
}

json place(const loads::Place& at) { return {at.x, at.y, at.z}; }

json polyline(const loads::Polyline& line) {
  json list = json::array();
  for (const loads::Place& at : line) list.push_back(place(at));
  return list;
}

json wheel_lines(const Loaded& mechanism) {
  std::vector<loads::Polyline> lines;
  if (!mechanism.wheel)
    lines = {loads::schematic_wheel(mechanism.driven.mechanism(), mechanism.sizes.pin_diameter)};
  else if (const auto* external = std::get_if<loads::GenevaDimensions>(&*mechanism.wheel))
    lines = loads::polylines(loads::wheel_outline(*external));
  else
    lines = loads::polylines(
        loads::internal_wheel_outline(std::get<loads::InternalDimensions>(*mechanism.wheel)));
  json list = json::array();
  for (const loads::Polyline& line : lines) list.push_back(polyline(line));
  return list;
}

json step_section(const Loaded& mechanism, const loads::KinematicsRow& row) {
  const loads::MotionState& motion = row.motion;
  json pins = json::array();
  for (const double angle : mechanism.pin_angles)
    pins.push_back(place(
        loads::pin_place(mechanism.driven.mechanism().motion(motion.driver_angle.value - angle))));
  return {{"time", motion.time},
          {"driver_angle", motion.driver_angle.value},
          {"wheel_angle", motion.wheel_angle.value},
          {"wheel_speed", motion.wheel_angle.first},
          {"wheel_acceleration", motion.wheel_angle.second},
          {"wheel_jerk", motion.wheel_angle.third},
          {"pin_force", row.load.force},
          {"hertz_pressure", row.pressure},
          {"slip_speed", row.load.slip_speed},
          {"travel_speed", row.load.travel_speed},
          {"engaged_pin", motion.pin ? json(*motion.pin) : json()},
          {"pins", pins}};
}

json lengths_section(const Loaded& mechanism) {
  const loads::MechanismSizes& sizes = mechanism.sizes;
  json section{{"wheel_diameter", sizes.wheel_diameter},
               {"pin_diameter", sizes.pin_diameter},
               {"wheel_thickness", sizes.thickness}};
  if (!mechanism.wheel) return section;
  const loads::CommonDimensions& wheel = common(*mechanism.wheel);
  section["centre_distance"] = wheel.centre_distance;
  section["crank_radius"] = wheel.crank_radius;
  section["slot_width"] = wheel.slot_width;
  section["slot_depth"] = wheel.slot_depth;
  section["locking_radius"] = wheel.locking_radius;
  return section;
}

/// Where the driver's axis is; null if it has no single one.
json driver_axis(const Inputs& inputs) {
  if (inputs.kind == Kind::long_dwell) return {};
  if (inputs.kind == Kind::spherical)
    return {inputs.size * std::sin(inputs.shaft_angle), 0.,
            inputs.size * std::cos(inputs.shaft_angle)};
  return {inputs.size, 0., 0.};
}

json drawing_section(const Inputs& inputs, const Loaded& mechanism) {
  json section{{"wheel", wheel_lines(mechanism)},
               {"pin_path", polyline(loads::pin_path(mechanism.driven.mechanism(), steps_of_path))},
               {"pin_diameter", mechanism.sizes.pin_diameter},
               {"steps", json::array()}};
  for (const loads::KinematicsRow& row :
       loads::kinematics_rows(mechanism.driven, mechanism.train, mechanism.contact, steps_of_cycle))
    section["steps"].push_back(step_section(mechanism, row));
  if (const json axis = driver_axis(inputs); !axis.is_null()) section["driver_axis"] = axis;
  if (inputs.kind == Kind::external)
    section["locking_radius"] = common(*mechanism.wheel).locking_radius;
  return section;
}

}  // namespace

Inputs read_inputs(const json& document) {
  Inputs inputs{};
  inputs.kind = kind_named(document.at("kind").get<std::string>());
  inputs.stations = whole_number(document.at("stations"), "number of stations");
  inputs.size = document.at("size").get<double>();
  inputs.shaft_angle = document.at("shaft_angle").get<double>();
  inputs.sprocket_spacing = document.at("sprocket_spacing").get<double>();
  inputs.sprockets = document.at("sprocket_line") == "across line of centres"
                         ? loads::SprocketLine::across_line_of_centres
                         : loads::SprocketLine::along_line_of_centres;
  inputs.pins = whole_number(document.at("pins"), "number of pins");
  inputs.driver_speed = document.at("driver_speed").get<double>();
  inputs.pin_diameter = optional_number(document.at("pin_diameter"));
  inputs.thickness = optional_number(document.at("thickness"));
  inputs.slot_clearance = optional_number(document.at("slot_clearance"));
  inputs.wheel_inertia = optional_number(document.at("wheel_inertia"));
  inputs.load = {document.at("load_inertia").get<double>(),
                 document.at("friction_moment").get<double>()};
  inputs.slot_friction = document.at("slot_friction").get<double>();
  inputs.pin = elastic(document.at("pin"));
  inputs.wheel = elastic(document.at("wheel"));
  inputs.wheel_density = document.at("wheel").at("density").get<double>();
  return inputs;
}

json calculated(const Inputs& inputs) {
  const Loaded mechanism = loaded(inputs);
  const loads::Characteristics values =
      loads::characteristics(mechanism.driven, mechanism.train, mechanism.contact);
  return {{"mechanism", mechanism.driven.mechanism().name},
          {"reference_speed", mechanism.driven.drive().reference_speed},
          {"wheel_inertia", mechanism.train.wheel_inertia},
          {"contact_modulus", mechanism.contact.contact_modulus},
          {"lengths", lengths_section(mechanism)},
          {"kinematics", kinematics_section(mechanism, values)},
          {"hertz", hertz_section(mechanism, values)},
          {"design", design_section(inputs, mechanism)},
          {"drawing", drawing_section(inputs, mechanism)}};
}

}  // namespace geneva::web
