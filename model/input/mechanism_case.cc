#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "model/input/case_models.h"
#include "model/input/case_path.h"
#include "model/input/motion_table.h"
#include "model/mechanism_motion.h"
#include "model/mechanism_state.h"

namespace geneva::model {

namespace {

/// Refuses parameters that belong to other types.
void refuse_given(const CaseSection& section, const std::vector<const char*>& parameters,
                  const std::string& only_with) {
  for (const char* name : parameters)
    if (section.is_given(name))
      section.refuse(name, fmt::format("this has an effect with {} only", only_with));
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The sizes that any type wants.
std::vector<std::string> sizes_of_all_kinds() {
  std::vector<std::string> sizes;
  for (const MechanismKind& kind : mechanism_kinds())
    for (const std::string& name : kind.sizes)
      if (!has(sizes, name)) sizes.push_back(name);
  return sizes;
}

void check_sizes(const CaseSection& section, const MechanismKind& kind) {
  std::vector<std::string> given;
  for (const std::string& name : sizes_of_all_kinds()) {
    if (!section.is_given(name) || has(kind.more_sizes, name)) continue;
    if (!has(kind.sizes, name))
      section.refuse(
          name, fmt::format("this has no effect with Type = {}: its size is given by {}", kind.name,
                            kind.sizes.empty() ? "the subsection '" + kind.section.back() + "'"
                                               : listed(kind.sizes)));
    given.push_back(name);
  }
  if (given.size() == 1 || kind.sizes.empty()) return;
  if (kind.sizes.size() == 1)
    section.refuse_missing(kind.sizes.front(), fmt::format("'Type' = '{}' needs it", kind.name));
  section.refuse(fmt::format("exactly one of {} is wanted; given: {}", listed(kind.sizes),
                             given.empty() ? "none" : listed(given)));
}

/// Refuses lengths of a drawing that is not made.
void check_drawn_lengths(const CaseSection& section, const MechanismKind& kind) {
  for (const std::string& name : kind.unused)
    if (section.optional_value(name))
      section.refuse(name, fmt::format("this has no effect with Type = {}: no such length is drawn",
                                       kind.name));
}

/// Refuses what belongs to other types, and what this one lacks.
void check_own_parameters(const CaseValues& values, const MechanismKind& of_case) {
  for (const MechanismKind& kind : mechanism_kinds()) {
    const CaseSection section(values, kind.section);
    if (kind.name == of_case.name) {
      for (const std::string& name : kind.needed)
        if (!section.is_given(name))
          section.refuse_missing(name, fmt::format("'Type' = '{}' needs it", kind.name));
      continue;
    }
    for (const Parameter& parameter : kind.parameters)
      if (section.is_changed(parameter.name))
        section.refuse(parameter.name,
                       fmt::format("this has an effect with Type = {} only", kind.name));
  }
}

loads::GenevaDimensionsInput read_dimensions(const CaseSection& section,
                                             const MechanismKind& kind) {
  check_sizes(section, kind);
  check_drawn_lengths(section, kind);
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
  return input;
}

/// Runs a check of the loads room and names in what it refuses the parameter that is to blame, or
/// the subsection if none is given.
template <typename Check>
void checked(const CaseSection& section, const char* parameter, const Check& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    if (parameter != nullptr) section.refuse(parameter, error.what());
    section.refuse(error.what());
  }
}

/// Step by step, so that a refusal names the parameter.
void check_motion(const CaseValues& values, const MechanismKind& kind, const MechanismCase& given) {
  const CaseSection section(values, {names::mechanism});
  checked({values, kind.section}, kind.responsible ? kind.responsible->c_str() : nullptr,
          [&] { mechanism_of(given); });
  checked(section, nullptr, [&] { check_drawing(given); });
  checked(section, given.pin_angles.empty() ? "Pins" : "Pin angles",
          [&] { engagements_of(given, mechanism_of(given)); });
  const char* motion = given.motion.kind == DriverMotion::Kind::constant ? "Driver acceleration"
                       : given.motion.kind == DriverMotion::Kind::table  ? "Motion table"
                                                                         : "Driver motion";
  checked(section, motion, [&] { driven_mechanism(given); });
}

/// Width of the drawn wheel's slot; none where a block stands for the wheel.
std::optional<double> slot_width(const MechanismCase& given, const MechanismDynamics& dynamics) {
  if (given.is_local || !dynamics.wheel) return std::nullopt;
  return std::visit([](const auto& wheel) { return wheel.slot_width; }, *dynamics.wheel);
}

void check_dynamics(const CaseValues& values, const MechanismCase& given) {
  const CaseSection section(values, {names::mechanism});
  const MechanismDynamics dynamics = mechanism_dynamics(given);
  if (given.roller)
    checked(section, "Roller bore diameter",
            [&] { loads::check(*given.roller, dynamics.sizes.pin_diameter); });
  if (given.roller && given.roller->needles)
    checked(section, "Needles",
            [&] { loads::check(*given.roller->needles, given.roller->diameter); });
  checked(section, given.roller ? "Roller bore friction" : "Slot friction",
          [&] { loads::check(dynamics.train, dynamics.driven); });
  if (given.space) check_pin(values, given, dynamics.sizes, slot_width(given, dynamics));
}

std::vector<double> read_pin_angles(const CaseSection& section) {
  std::vector<double> angles;
  if (!section.is_given("Pin angles")) return angles;
  if (section.value("Pins") != 1.)
    section.refuse("Pins", "'Pin angles' places the pins already: give one of the two");
  for (const std::string& part : split_list(section.text("Pin angles"))) {
    try {
      angles.push_back(base::parse_quantity(part, base::Dimension::angle));
    } catch (const std::invalid_argument& error) {
      section.refuse("Pin angles", error.what());
    }
  }
  if (std::abs(angles.front()) > 1e-12)
    section.refuse("Pin angles",
                   "the first is 0 deg: the driver angle is counted from the first pin");
  return angles;
}

DriverMotion read_motion(const CaseSection& section, const MechanismType& type,
                         const std::filesystem::path& directory) {
  using Motion = DriverMotion::Kind;
  const std::string word = section.text("Driver motion");
  DriverMotion motion{};
  const bool on_cross = word == names::cycloidal_cross || word == names::harmonic_cross;
  motion.kind = word == names::constant ? Motion::constant
                : word == names::table  ? Motion::table
                : on_cross              ? Motion::law_on_cross
                                        : Motion::law_on_carrier;
  motion.law = word == names::cycloidal_carrier || word == names::cycloidal_cross
                   ? loads::MotionLaw::cycloidal
                   : loads::MotionLaw::harmonic;
  if (on_cross && !type.plane())
    section.refuse("Driver motion",
                   "a law on the cross is for Type = external or internal; for others it can be "
                   "set on the carrier, or given as a table");
  const std::string needed = fmt::format("'Driver motion' = '{}' needs it", word);
  const bool is_constant = motion.kind == Motion::constant;
  const bool is_table = motion.kind == Motion::table;
  if (!is_constant) refuse_given(section, {"Driver speed"}, "Driver motion = constant");
  if (is_constant || is_table) refuse_given(section, {"Motion time"}, "a law of motion");
  if (!is_table) refuse_given(section, {"Motion table"}, "Driver motion = table");
  motion.acceleration = section.value("Driver acceleration");
  if (!is_constant && motion.acceleration != 0.)
    section.refuse("Driver acceleration", "this has an effect with Driver motion = constant only");
  if (is_constant) {
    if (!section.is_given("Driver speed")) section.refuse_missing("Driver speed", needed);
    motion.speed = section.value("Driver speed");
  } else if (is_table) {
    if (!section.is_given("Motion table")) section.refuse_missing("Motion table", needed);
    MotionTable table = read_motion_table(file_in_directory(section, "Motion table", directory));
    motion.times = std::move(table.times);
    motion.angles = std::move(table.angles);
  } else {
    if (!section.is_given("Motion time")) section.refuse_missing("Motion time", needed);
    motion.motion_time = section.value("Motion time");
  }
  return motion;
}

void read_angle(const CaseSection& section, const loads::DrivenMechanism& driven,
                MechanismCase& result) {
  using AngleKind = MechanismCase::AngleKind;
  result.driver_angle = 0.;
  const auto angle = section.optional_value("Driver angle");
  if (!angle) {
    result.angle_kind = section.text("Driver angle") == names::at_maximum_force
                            ? AngleKind::at_maximum_pin_force
                            : AngleKind::at_maximum_wheel_acceleration;
    return;
  }
  try {
    static_cast<void>(driven.at_engaged_angle(*angle));
  } catch (const std::invalid_argument& error) {
    section.refuse("Driver angle", error.what());
  }
  result.angle_kind = AngleKind::given;
  result.driver_angle = *angle;
}

void read_contact_model(const CaseSection& section, MechanismCase& result) {
  result.is_local = section.text("Contact model") == names::local;
  result.block_width = section.optional_value("Block width");
  result.block_depth = section.optional_value("Block depth");
  for (const char* name : {"Block width", "Block depth"})
    if (!result.is_local && section.optional_value(name))
      section.refuse(name, "this has an effect with Contact model = local only");
  if (!result.is_local && !result.type->is_drawn())
    section.refuse("Contact model",
                   fmt::format("the whole wheel is drawn with Type = external or internal only; "
                               "Type = {} needs 'Contact model = {}'",
                               section.text("Type"), names::local));
}

void read_wheel_inertia(const CaseSection& section, MechanismCase& result) {
  using InertiaKind = MechanismCase::InertiaKind;
  const auto inertia = section.optional_value("Wheel inertia");
  const bool is_johnson = section.text("Wheel inertia") == names::johnson;
  result.inertia_kind = inertia      ? InertiaKind::given
                        : is_johnson ? InertiaKind::johnson
                                     : InertiaKind::from_geometry;
  result.wheel_inertia = inertia.value_or(0.);
  const int stations = result.dimensions.stations;
  if (is_johnson && (!result.type->is_johnsons() || !loads::johnson_row(stations).k5))
    section.refuse(
        "Wheel inertia",
        fmt::format("Johnson gives the inertia of external wheels with 3 to 10 stations, this one "
                    "is {} and has {}; {} is wanted",
                    section.text("Type"), stations,
                    result.type->is_drawn() ? fmt::format("'{}' or a value", names::from_geometry)
                                            : "a value"));
  if (!inertia && !result.type->is_drawn())
    section.refuse("Wheel inertia",
                   fmt::format("Type = {} has no drawn wheel: a value is wanted, for example {}",
                               section.text("Type"), base::example_of(base::Dimension::inertia)));
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

/// Their length is the wheel's thickness where none is given.
std::optional<loads::NeedleBearing> read_needles(const CaseSection& section) {
  const auto count = section.optional_value("Needles");
  const auto diameter = section.optional_value("Needle diameter");
  const auto length = section.optional_value("Needle length");
  if (!count && !diameter && !length) return std::nullopt;
  if (!count) section.refuse_missing("Needles", "the bearing of the roller needs it");
  if (!diameter) section.refuse_missing("Needle diameter", "'Needles' needs it");
  if (section.is_changed("Roller bore clearance"))
    section.refuse("Roller bore clearance", "there are needles between roller and stud");
  return loads::NeedleBearing{static_cast<int>(*count), *diameter, length.value_or(0.)};
}

/// @throws base::InputError if a bore leaves nothing of the pin
void check_bore(const CaseValues& values, const MechanismCase& given) {
  const auto bore = given.pin_holding.bore_diameter;
  const double pin = sizes_of(given).pin_diameter;
  if (!bore || *bore < pin) return;
  CaseSection(values, {names::mechanism, names::pin})
      .refuse("Bore diameter",
              fmt::format("nothing is left of the pin, whose diameter is {:.6g} mm", 1e3 * pin));
}

/// A roller has friction in its bore, a fixed pin on the wall.
std::optional<loads::RollerBore> read_roller(const CaseSection& section) {
  if (section.text("Pin type") != names::roller) {
    for (const char* name :
         {"Roller bore diameter", "Roller bore friction", "Roller bore clearance", "Needles",
          "Needle diameter", "Needle length"})
      if (section.is_changed(name))
        section.refuse(name, "this has an effect with Pin type = roller only");
    return std::nullopt;
  }
  if (section.is_changed("Slot friction"))
    section.refuse("Slot friction",
                   "this has an effect with Pin type = fixed only: a roller does not slide on the "
                   "wall but in its bore; give 'Roller bore friction'");
  if (!section.is_given("Roller bore diameter"))
    section.refuse_missing("Roller bore diameter", "'Pin type' = 'roller' needs it");
  return loads::RollerBore{section.value("Roller bore diameter"),
                           section.value("Roller bore friction"), read_needles(section)};
}

/// Only a roller has a stud of its own.
void check_no_stud(const CaseValues& values) {
  const CaseSection section(values, {names::mechanism, names::stud_material});
  for (const char* const name :
       {names::material, "Young's modulus", "Poisson's ratio", "Density", "Yield strength",
        "Fatigue strength", "Hardness", "Hardened depth", "Contact pressure"})
    if (section.is_changed(name))
      section.refuse(name, "this has an effect with Pin type = roller only");
}

CaseMaterial read_material(const CaseSection& section) {
  return {section.value("Young's modulus"), section.value("Poisson's ratio"),
          section.value("Density")};
}

}  // namespace

MechanismCase read_mechanism(const CaseValues& values, const std::filesystem::path& directory) {
  const CaseSection section(values, {names::mechanism});
  MechanismCase result{};
  const MechanismKind& kind = mechanism_kind(section.text("Type"));
  result.dimensions = read_dimensions(section, kind);
  check_own_parameters(values, kind);
  result.type = kind.read(values, result.dimensions);
  result.pins = static_cast<int>(section.value("Pins"));
  result.pin_angles = read_pin_angles(section);
  result.motion = read_motion(section, *result.type, directory);
  result.load = {read_load_inertia(section), section.value("Friction moment")};
  result.external_torque = section.value("External torque");
  result.slot_friction = section.value("Slot friction");
  if (const auto instants = section.optional_value("Instants"))
    result.instants = static_cast<int>(*instants);
  result.roller = read_roller(section);
  if (result.roller) result.bore_clearance = section.optional_value("Roller bore clearance");
  if (!result.roller) check_no_stud(values);
  if (result.roller && result.roller->needles && result.roller->needles->length == 0.)
    result.roller->needles->length = sizes_of(result).thickness;
  read_contact_model(section, result);
  check_motion(values, kind, result);
  read_angle(section, driven_mechanism(result), result);
  read_wheel_inertia(section, result);
  result.pin = read_material({values, {names::mechanism, names::pin_material}});
  result.stud = read_material({values, {names::mechanism, names::stud_material}});
  result.wheel = read_material({values, {names::mechanism, names::wheel_material}});
  result.pin_holding = read_pin_holding(values);
  check_bore(values, result);
  if (CaseSection(values, {}).text("Dimension") == "3") {
    result.space = read_pin(values, result.pin_holding.hold, directory);
    if (const auto bore = result.pin_holding.bore_diameter)
      result.dimensions.pin_core_radius = *bore / 2.;
  }
  if (result.space && result.bore_clearance)
    section.refuse("Roller bore clearance",
                   "the contact in a roller's bore is known in the plane; leave it away, or give "
                   "'Dimension' = 2");
  if (!result.space) check_no_pin(values);
  result.design = read_design(values);
  check_dynamics(values, result);
  return result;
}

}  // namespace geneva::model
