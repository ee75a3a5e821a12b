#include "api/crown.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/mechanism_picture.h"
#include "api/output_directory.h"
#include "api/version.h"
#include "base/errors.h"
#include "loads/hertz.h"
#include "loads/pi.h"
#include "model/case_header.h"
#include "model/mechanism_state.h"
#include "model/naming.h"
#include "model/pin_in_space.h"

namespace geneva {

namespace {

using Profile = model::PinCase::Profile;

/// Of the line contacts of the pins before and after, relative.
constexpr double accuracy_shown = 5e-4;

void check(const model::Case& given) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no pin to crown", "geneva design --crown", "mechanism");
  if (!given.mechanism->space)
    throw base::InputError(
        "'Dimension' = '2': the crown acts along the pin; 'geneva design --crown' wants a case "
        "with Dimension = 3");
  if (given.mechanism->space->profile == Profile::table)
    throw base::InputError(
        "'Pin/Profile' = 'table': it has no size to be searched for; 'crown' or 'logarithmic' is "
        "wanted");
}

bool is_logarithmic(const model::MechanismCase& given) {
  return given.space->profile == Profile::logarithmic;
}

model::MechanismCase with_size(const model::MechanismCase& given, const double size) {
  model::MechanismCase changed = given;
  model::PinCase& pin = *changed.space;
  if (is_logarithmic(given)) {
    pin.profile_load.reset();
    pin.profile_amplitude = size;
  } else {
    pin.profile = Profile::crown;
    pin.crown_radius = size;
  }
  return changed;
}

/// The amplitude by which the logarithmic profile carries the pin force evenly on half-spaces, or
/// the radius of a crown that drops three times as much at the wheel's faces.
double first_size(const model::MechanismCase& mechanism, const loads::ProfileDuty& duty) {
  const double thickness = 2. * duty.pin.clearance.wall_half;
  const double length = mechanism.space->profile_length.value_or(thickness);
  const double modulus = loads::contact_modulus(duty.pin.pin, duty.pin.wheel);
  const double amplitude = duty.force / (loads::pi * length * modulus);
  if (is_logarithmic(mechanism)) return amplitude;
  return thickness * thickness / (8. * 3. * amplitude);
}

/// The tilts at whose ends the pressure is greatest: it grows with the tilt to either side.
std::vector<double> tilts_of(const model::PinCase& pin) {
  if (pin.tilt_tolerance == 0.) return {pin.tilt};
  return {pin.tilt - pin.tilt_tolerance, pin.tilt + pin.tilt_tolerance};
}

loads::ProfileDuty duty_of(const model::MechanismCase& mechanism,
                           const model::MechanismState& state) {
  loads::ProfileDuty duty{};
  duty.pin = model::pin_line(mechanism, state);
  duty.profile = [mechanism, state](const double size) {
    return model::pin_clearance(with_size(mechanism, size), state).profile;
  };
  duty.tilts = tilts_of(*mechanism.space);
  duty.force = mechanism.space->load_range ? mechanism.space->load_range->second : state.load.force;
  duty.first_size = first_size(mechanism, duty);
  const loads::PinClearance& clearance = duty.pin.clearance;
  // the pin must not end beyond its crown
  duty.least_size =
      is_logarithmic(mechanism) ? 0. : 1.001 * std::max(-clearance.lower_end, clearance.upper_end);
  return duty;
}

/// The pin of the case at the worst of the tilts.
loads::LoadEvenness as_it_is(const loads::ProfileDuty& duty) {
  loads::LoadEvenness worst{};
  for (const double tilt : duty.tilts) {
    loads::PinLine pin = duty.pin;
    pin.clearance.tilt = tilt;
    const loads::LoadEvenness load =
        loads::load_evenness(pin, loads::pin_line_contact(pin, duty.force, accuracy_shown));
    if (load.maximum > worst.maximum) worst = load;
  }
  return worst;
}

post::CrownReport search(const model::Case& given) {
  const model::MechanismCase& mechanism = *given.mechanism;
  const loads::ProfileDuty duty = duty_of(mechanism, model::mechanism_state(mechanism));
  const loads::ProfileSearch found = loads::find_profile(duty);
  const double tilt = found.best.worst_tilt;
  const loads::PinLine best = loads::pin_of(duty, found.best.size, tilt);
  post::CrownReport report{};
  report.about = model::header_of(given);
  report.geneva_version = version;
  report.profile = is_logarithmic(mechanism) ? "logarithmic" : "crown";
  report.parameter = is_logarithmic(mechanism) ? "Profile amplitude" : "Crown radius";
  report.size = found.best.size;
  loads::PinClearance profile_only;
  profile_only.profile = best.clearance.profile;
  report.drop = profile_only.at(best.clearance.wall_half);
  report.force = duty.force;
  report.tilts = duty.tilts;
  report.worst_tilt = tilt;
  report.trials = found.trials;
  report.map = loads::map_around(duty, found.best.size);
  report.before = as_it_is(duty);
  report.after =
      loads::load_evenness(best, loads::pin_line_contact(best, duty.force, accuracy_shown));
  return report;
}

Case best_case(const Case& given, const post::CrownReport& report) {
  Case best = given;
  best.mechanism = with_size(*given.mechanism, report.size);
  best.mechanism->space->tilt = report.worst_tilt;
  best.mechanism->pin_force = report.force;
  return best;
}

}  // namespace

Crown design_crown(const Case& given) {
  return model::naming(given, [&] {
    check(given);
    post::CrownReport report = search(given);
    Case best = best_case(given, report);
    return Crown{given, std::move(best), std::move(report)};
  });
}

std::string table(const Crown& crown) { return post::crown_table(crown.report, crown.given.units); }

Written write(const Crown& crown, const std::filesystem::path& directory) {
  const auto& [given, best, report] = crown;
  return api::write_results(directory, given, "crown",
                            {{"crown.json", post::crown_summary(report).dump(2) + "\n"},
                             {"crown.csv", post::crown_csv(report, given.units)},
                             {"mechanism.json", api::mechanism_text(*given.mechanism)}});
}

}  // namespace geneva
