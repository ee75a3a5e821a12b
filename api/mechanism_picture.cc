#include "api/mechanism_picture.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "loads/wheel/internal_outline.h"
#include "loads/wheel/outline.h"

namespace geneva::api {

namespace {

using loads::Place;

constexpr int steps_of_cycle = 360;
constexpr int steps_of_path = 240;

std::vector<loads::Polyline> wheel_of(const model::MechanismDynamics& dynamics) {
  if (!dynamics.wheel)
    return {loads::schematic_wheel(dynamics.driven.mechanism(), dynamics.sizes.pin_diameter)};
  if (const auto* external = std::get_if<loads::GenevaDimensions>(&*dynamics.wheel))
    return loads::polylines(loads::wheel_outline(*external));
  return loads::polylines(
      loads::internal_wheel_outline(std::get<loads::InternalDimensions>(*dynamics.wheel)));
}

const loads::CommonDimensions* common_dimensions(const model::MechanismDynamics& dynamics) {
  if (!dynamics.wheel) return nullptr;
  return std::visit([](const auto& wheel) -> const loads::CommonDimensions* { return &wheel; },
                    *dynamics.wheel);
}

std::optional<Place> driver_axis(const model::MechanismCase& given,
                                 const model::MechanismDynamics& dynamics) {
  if (const auto* sizes = common_dimensions(dynamics)) return Place{sizes->centre_distance, 0., 0.};
  return given.type->driver_axis();
}

std::vector<post::NamedLength> lengths_of(const model::MechanismCase& given,
                                          const model::MechanismDynamics& dynamics) {
  std::vector<post::NamedLength> lengths{{"wheel diameter", dynamics.sizes.wheel_diameter},
                                         {"pin diameter", dynamics.sizes.pin_diameter},
                                         {"wheel thickness", dynamics.sizes.thickness}};
  if (const auto* sizes = common_dimensions(dynamics)) {
    lengths.push_back({"centre distance", sizes->centre_distance});
    lengths.push_back({"crank radius", sizes->crank_radius});
    lengths.push_back({"slot width", sizes->slot_width});
    lengths.push_back({"slot depth", sizes->slot_depth});
    lengths.push_back({"locking radius", sizes->locking_radius});
  }
  for (const auto& [name, length] : given.type->lengths()) lengths.push_back({name, length});
  return lengths;
}

/// Driver angles at which each of the pins is midway through its engagement.
std::vector<double> middles_of(const model::MechanismCase& given,
                               const loads::Mechanism& mechanism) {
  std::vector<double> middles;
  for (const loads::Engagement& engagement : model::engagements_of(given, mechanism)) {
    middles.resize(std::max(middles.size(), engagement.pin + 1));
    middles[engagement.pin] = engagement.middle;
  }
  return middles;
}

}  // namespace

loads::PinContact pin_contact(const model::MechanismCase& given,
                              const model::MechanismSizes& sizes) {
  return {loads::contact_modulus({given.pin.youngs_modulus, given.pin.poissons_ratio},
                                 {given.wheel.youngs_modulus, given.wheel.poissons_ratio}),
          sizes.thickness, sizes.pin_diameter};
}

post::MechanismDrawing mechanism_picture(const model::MechanismCase& given,
                                         const model::MechanismDynamics& dynamics,
                                         const std::optional<loads::PinLoad>& analysed) {
  const loads::Mechanism& mechanism = dynamics.driven.mechanism();
  const std::vector<double> middles = middles_of(given, mechanism);
  const auto linkage = given.type->linkage(given.dimensions);
  const auto step_of = [&](const loads::KinematicsRow& row) {
    const double angle = row.motion.driver_angle.value;
    post::MechanismStep step{row, {}, {}};
    for (const double middle : middles)
      step.pins.push_back(loads::pin_place(mechanism.motion(angle - middle)));
    if (linkage) step.linkage = linkage(angle - middles.front());
    return step;
  };
  post::MechanismDrawing drawing{};
  drawing.name = mechanism.name;
  drawing.wheel = wheel_of(dynamics);
  drawing.pin_path = loads::pin_path(mechanism, steps_of_path);
  drawing.driver_axis = driver_axis(given, dynamics);
  if (given.type->is_johnsons())
    drawing.locking_radius = common_dimensions(dynamics)->locking_radius;
  drawing.pin_diameter = dynamics.sizes.pin_diameter;
  drawing.lengths = lengths_of(given, dynamics);
  const loads::PinContact contact = pin_contact(given, dynamics.sizes);
  for (const loads::KinematicsRow& row :
       loads::kinematics_rows(dynamics.driven, dynamics.train, contact, steps_of_cycle))
    drawing.steps.push_back(step_of(row));
  if (analysed)
    drawing.analysed = step_of({dynamics.driven.at_engaged_angle(analysed->driver_angle), *analysed,
                                loads::hertz_pressure(contact, analysed->force)});
  return drawing;
}

std::string mechanism_text(const model::MechanismCase& given) {
  std::optional<loads::PinLoad> analysed;
  try {
    analysed = model::mechanism_state(given).load;
  } catch (const std::invalid_argument&) {
    // Nothing presses on the driving wall there: a run refuses the case, its motion is sound.
  }
  return post::mechanism_document(
             mechanism_picture(given, model::mechanism_dynamics(given), analysed))
             .dump() +
         "\n";
}

}  // namespace geneva::api
