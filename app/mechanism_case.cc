#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "app/case_models.h"
#include "loads/external_geneva.h"
#include "loads/pi.h"

namespace geneva::app {

namespace {

void require_one_size(const CaseSection& section) {
  const std::array<const char*, 3> sizes{"Wheel diameter", "Crank radius", "Centre distance"};
  std::vector<std::string> given;
  for (const char* name : sizes)
    if (section.is_given(name)) given.emplace_back(name);
  if (given.size() == 1) return;
  section.refuse(fmt::format("exactly one of {} is wanted; given: {}",
                             listed({sizes.begin(), sizes.end()}),
                             given.empty() ? "none" : listed(given)));
}

loads::GenevaDimensionsInput read_dimensions(const CaseSection& section) {
  require_one_size(section);
  loads::GenevaDimensionsInput input{};
  input.stations = static_cast<int>(section.value("Stations"));
  input.wheel_diameter = section.optional_value("Wheel diameter");
  input.crank_radius = section.optional_value("Crank radius");
  input.centre_distance = section.optional_value("Centre distance");
  input.pin_diameter = section.optional_value("Pin diameter");
  input.thickness = section.optional_value("Wheel thickness");
  input.slot_clearance = section.optional_value("Slot clearance");
  input.slot_width = section.optional_value("Slot width");
  input.slot_depth = section.optional_value("Slot depth");
  input.locking_radius = section.optional_value("Locking radius");
  input.bore_radius = section.optional_value("Bore radius");
  input.pin_core_radius = section.optional_value("Pin core radius");
  try {
    loads::complete_dimensions(input);
  } catch (const std::invalid_argument& error) {
    section.refuse(error.what());
  }
  return input;
}

void read_angle(const CaseSection& section, MechanismCase& result) {
  using Kind = MechanismCase::AngleKind;
  result.driver_angle = 0.;
  const auto angle = section.optional_value("Driver angle");
  if (!angle) {
    result.angle_kind = section.text("Driver angle") == names::at_maximum_force
                            ? Kind::at_maximum_pin_force
                            : Kind::at_maximum_wheel_acceleration;
    return;
  }
  const loads::ExternalGeneva geneva(result.dimensions.stations);
  const double limit = geneva.engagement_angle();
  // a few roundings, so that the very end of the engagement can be given
  if (std::abs(*angle) > limit + 1e-12)
    section.refuse("Driver angle",
                   fmt::format("with {0} stations the pin is in the slot from -{1:.6g} deg to "
                               "{1:.6g} deg only",
                               geneva.stations(), limit * 180. / loads::pi));
  result.angle_kind = Kind::given;
  result.driver_angle = *angle;
}

void read_wheel_inertia(const CaseSection& section, MechanismCase& result) {
  using Kind = MechanismCase::InertiaKind;
  const auto inertia = section.optional_value("Wheel inertia");
  const bool is_johnson = section.text("Wheel inertia") == names::johnson;
  result.inertia_kind = inertia ? Kind::given : is_johnson ? Kind::johnson : Kind::from_geometry;
  result.wheel_inertia = inertia.value_or(0.);
  const int stations = result.dimensions.stations;
  if (is_johnson && !loads::johnson_row(stations).k5)
    section.refuse(
        "Wheel inertia",
        fmt::format("Johnson gives the inertia of wheels with 3 to 10 stations, this one "
                    "has {}; '{}' or a value is wanted",
                    stations, names::from_geometry));
}

double read_load_inertia(const CaseSection& section) {
  const std::array<const char*, 3> cylinder{"Load diameter", "Load length", "Load density"};
  const auto inertia = section.optional_value("Load inertia");
  for (const char* name : cylinder) {
    if (inertia && section.is_given(name))
      section.refuse(name, fmt::format("this has no effect unless 'Load inertia' = '{}'",
                                       names::solid_cylinder));
    if (!inertia && !section.is_given(name))
      section.refuse_missing(name,
                             fmt::format("'Load inertia' = '{}' needs it", names::solid_cylinder));
  }
  if (inertia) return *inertia;
  return loads::solid_cylinder_inertia(section.value("Load diameter"), section.value("Load length"),
                                       section.value("Load density"));
}

CaseMaterial read_material(const CaseSection& section) {
  return {section.value("Young's modulus"), section.value("Poisson's ratio"),
          section.value("Density")};
}

}  // namespace

MechanismCase read_mechanism(const CaseValues& values) {
  const CaseSection section(values, {names::mechanism});
  MechanismCase result{};
  result.dimensions = read_dimensions(section);
  result.motion = {section.value("Driver speed"), section.value("Driver acceleration")};
  result.load = {read_load_inertia(section), section.value("Friction moment")};
  read_angle(section, result);
  read_wheel_inertia(section, result);
  result.pin = read_material({values, {names::mechanism, names::pin_material}});
  result.wheel = read_material({values, {names::mechanism, names::wheel_material}});
  return result;
}

}  // namespace geneva::app
