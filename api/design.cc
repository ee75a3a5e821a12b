#include "api/design.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/mechanism_picture.h"
#include "api/output_directory.h"
#include "api/version.h"
#include "base/errors.h"
#include "model/case_header.h"
#include "model/naming.h"

namespace geneva {

namespace fs = std::filesystem;

model::MechanismCase designed_mechanism(const Case& given) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no wheel to design", "geneva design", "mechanism");
  model::MechanismCase mechanism = *given.mechanism;
  if (!mechanism.type->is_johnsons() ||
      mechanism.motion.kind != model::DriverMotion::Kind::constant ||
      mechanism.motion.acceleration != 0. || mechanism.pins != 1 || mechanism.pin_angles.size() > 1)
    throw base::InputError(
        "'geneva design' follows Johnson's equations, which are those of an external Geneva with "
        "one pin at constant driver speed; 'geneva kinematics' knows the others");
  mechanism.angle_kind = model::MechanismCase::AngleKind::at_maximum_wheel_acceleration;
  mechanism.external_torque = 0.;
  mechanism.slot_friction = 0.;
  if (mechanism.design.adds_shaft_inertia)
    mechanism.load.load_inertia += loads::shaft_inertia(*mechanism.design.shaft);
  return mechanism;
}

namespace {

/// The stress is told from 0.3 to 3 times the best diameter, in a hundred steps of equal ratio.
constexpr double curve_start = 0.3;
constexpr double curve_end = 3.;
constexpr int curve_steps = 100;

loads::Elastic elastic(const model::CaseMaterial& material) {
  return {material.youngs_modulus, material.poissons_ratio};
}

loads::DesignInput design_input(const model::MechanismCase& mechanism) {
  return {mechanism.dimensions,    mechanism.design.given_lengths, mechanism.load,
          mechanism.motion.speed,  mechanism.wheel.density,        elastic(mechanism.pin),
          elastic(mechanism.wheel)};
}

loads::DesignedWheel own_wheel(const model::MechanismCase& mechanism) {
  const model::MechanismState state = model::mechanism_state(mechanism);
  const auto& wheel = std::get<loads::GenevaDimensions>(*state.wheel);
  return {wheel.wheel_diameter,
          wheel.pin_diameter,
          wheel.thickness,
          wheel.locking_radius,
          state.train.wheel_inertia,
          state.load.force,
          loads::johnson_stress(state.load.force, wheel.thickness, wheel.pin_diameter,
                                elastic(mechanism.pin), elastic(mechanism.wheel))};
}

/// Johnson's vibration is that of the load alone, whether the shaft's inertia is added or not.
std::optional<post::ShaftReport> shaft_report(const model::MechanismCase& given,
                                              const double exit_acceleration) {
  if (!given.design.shaft) return std::nullopt;
  const loads::Shaft& shaft = *given.design.shaft;
  return post::ShaftReport{
      loads::torsional_vibration(shaft, given.load.load_inertia, exit_acceleration),
      loads::shaft_inertia(shaft), given.design.adds_shaft_inertia, given.design.amplitude_radius};
}

/// What the user should know of the figures of the table.
std::vector<std::string> notices_of(const model::Case& given, const post::DesignReport& report) {
  std::vector<std::string> notices;
  const loads::DrawnOptimum& drawn = report.drawn;
  if (!report.johnson)
    notices.emplace_back("Johnson's k5 ends at 10 stations: there is only the best wheel as drawn");
  if (report.given_lengths == loads::GivenLengths::stay)
    notices.push_back(fmt::format(
        "the given lengths stay, so that the best wheel as drawn is searched for: its inertia is "
        "{:.3g} (J_L + M_f/a) instead of the 1.5 of Johnson's Eq. 9",
        drawn.inertia_ratio));
  if (drawn.at_limit)
    notices.emplace_back(
        "the stress falls as far as the wheel can be drawn with the given lengths: the best "
        "wheel as drawn is the last one that can be made");
  const bool has_pin_friction =
      given.mechanism->slot_friction != 0. ||
      (given.mechanism->roller && given.mechanism->roller->friction != 0.);
  if (given.mechanism->external_torque != 0. || has_pin_friction)
    notices.emplace_back("external torque and friction of the pin are left out, as Johnson does");
  if (given.mechanism->angle_kind != model::MechanismCase::AngleKind::at_maximum_wheel_acceleration)
    notices.emplace_back(
        "the design is that of the maximum wheel acceleration, not of the case's driver angle");
  return notices;
}

post::DesignReport design_report(const model::Case& given) {
  const model::MechanismCase mechanism = designed_mechanism(given);
  const loads::DesignInput input = design_input(mechanism);
  post::DesignReport report{};
  report.about = model::header_of(given);
  report.geneva_version = version;
  report.row = loads::johnson_row(mechanism.dimensions.stations);
  report.load = mechanism.load;
  report.peak_acceleration = loads::design_acceleration(input);
  report.exit_acceleration =
      report.row.exit_acceleration_ratio * mechanism.motion.speed * mechanism.motion.speed;
  report.cycle = loads::working_cycle(mechanism.dimensions.stations, mechanism.motion.speed);
  report.given_lengths = input.given_lengths;
  report.johnson = loads::johnson_optimum(input);
  report.drawn = loads::drawn_optimum(input);
  report.own = own_wheel(mechanism);
  report.has_johnsons_inertia =
      mechanism.inertia_kind == model::MechanismCase::InertiaKind::johnson;
  if (report.johnson)
    report.pressure_ratio = report.own.peak_pressure / report.johnson->peak_pressure;
  report.shaft = shaft_report(*given.mechanism, report.exit_acceleration);
  const double best = report.johnson.value_or(report.drawn.wheel).diameter;
  report.curve = loads::design_curve(input, curve_start * best, curve_end * best, curve_steps);
  return report;
}

}  // namespace

Design design(const Case& given) {
  return model::naming(given, [&] {
    post::DesignReport report = design_report(given);
    std::vector<std::string> notices = notices_of(given, report);
    return Design{given, std::move(report), std::move(notices)};
  });
}

std::string table(const std::vector<Design>& designs) {
  std::vector<post::DesignReport> reports;
  for (const Design& design : designs) reports.push_back(design.report);
  return post::design_table(reports, designs.front().given.units);
}

Written write(const Design& design, const std::filesystem::path& directory) {
  const auto& [given, report, notices] = design;
  return api::write_results(directory, given, "design",
                            {{"design.json", post::design_summary(report).dump(2) + "\n"},
                             {"design.csv", post::design_csv(report, given.units)},
                             {"mechanism.json", api::mechanism_text(*given.mechanism)}});
}

}  // namespace geneva
