#include "api/mechanism_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "loads/motion/four_bar_geneva.h"
#include "loads/pi.h"
#include "loads/wheel/internal_outline.h"
#include "loads/wheel/outline.h"

namespace geneva::api {

namespace {

using Kind = model::MechanismCase::Kind;
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
  if (given.kind != Kind::spherical) return std::nullopt;
  return Place{given.sphere_radius * std::sin(given.shaft_angle), 0.,
               given.sphere_radius * std::cos(given.shaft_angle)};
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
  if (given.kind == Kind::spherical) lengths.push_back({"sphere radius", given.sphere_radius});
  if (given.kind == Kind::long_dwell)
    lengths.push_back({"sprocket spacing", given.sprocket_spacing});
  return lengths;
}

/// The linkage's joints, from its own frame to that of the wheel: the pin stands on the x axis
/// midway and moves towards y there.
class LinkagePicture {
 public:
  explicit LinkagePicture(const model::MechanismCase& given)
      : linkage_(given.linkage),
        assembly_(given.assembly),
        geneva_(loads::four_bar_geneva(given.dimensions.stations, given.linkage, given.assembly,
                                       given.wheel_place)),
        axis_{linkage_.crank_pivot[0] +
                  geneva_.centre_distance * std::cos(given.wheel_place.direction),
              linkage_.crank_pivot[1] +
                  geneva_.centre_distance * std::sin(given.wheel_place.direction)} {
    const loads::FourBarMotion middle = loads::motion(linkage_, assembly_, geneva_.crank_angle);
    const std::array<double, 2> pin{middle.x[0] - axis_[0], middle.y[0] - axis_[1]};
    const double distance = std::hypot(pin[0], pin[1]);
    x_axis_ = {pin[0] / distance, pin[1] / distance};
    side_ = x_axis_[0] * middle.y[1] - x_axis_[1] * middle.x[1] > 0. ? 1. : -1.;
  }

  /// Crank pivot, crank pin, coupler's end, rocker pivot, coupler's end, coupler point, crank pin.
  [[nodiscard]] loads::Polyline at(const double driver_angle) const {
    const double crank = geneva_.crank_angle + driver_angle;
    const loads::FourBarMotion motion = loads::motion(linkage_, assembly_, crank);
    const auto& [ax, ay] = linkage_.crank_pivot;
    const auto& [dx, dy] = linkage_.rocker_pivot;
    const double rocker = motion.rocker_angle[0];
    const Place a = in_wheel_frame(ax, ay);
    const Place b = in_wheel_frame(ax + linkage_.crank * std::cos(crank),
                                   ay + linkage_.crank * std::sin(crank));
    const Place c = in_wheel_frame(dx + linkage_.rocker * std::cos(rocker),
                                   dy + linkage_.rocker * std::sin(rocker));
    const Place d = in_wheel_frame(dx, dy);
    const Place p = in_wheel_frame(motion.x[0], motion.y[0]);
    return {a, b, c, d, c, p, b};
  }

 private:
  [[nodiscard]] Place in_wheel_frame(const double x, const double y) const {
    const double right = x - axis_[0];
    const double up = y - axis_[1];
    return {x_axis_[0] * right + x_axis_[1] * up, side_ * (x_axis_[0] * up - x_axis_[1] * right),
            0.};
  }

  loads::FourBar linkage_;
  loads::Assembly assembly_;
  loads::FourBarGeneva geneva_;
  std::array<double, 2> axis_;
  std::array<double, 2> x_axis_{};
  double side_ = 1.;
};

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
  std::optional<LinkagePicture> linkage;
  if (given.kind == Kind::four_bar) linkage.emplace(given);
  const auto step_of = [&](const loads::KinematicsRow& row) {
    const double angle = row.motion.driver_angle.value;
    post::MechanismStep step{row, {}, {}};
    for (const double middle : middles)
      step.pins.push_back(loads::pin_place(mechanism.motion(angle - middle)));
    if (linkage) step.linkage = linkage->at(angle - middles.front());
    return step;
  };
  post::MechanismDrawing drawing{};
  drawing.name = mechanism.name;
  drawing.wheel = wheel_of(dynamics);
  drawing.pin_path = loads::pin_path(mechanism, steps_of_path);
  drawing.driver_axis = driver_axis(given, dynamics);
  if (given.kind == Kind::external)
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
