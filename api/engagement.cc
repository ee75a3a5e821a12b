#include "api/engagement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "api/mechanism_picture.h"
#include "base/errors.h"
#include "loads/motion/kinematics.h"
#include "model/pin_in_space.h"

namespace geneva::api {

namespace {

using post::EngagementPoint;

constexpr int steps_of_cycle = 240;
constexpr std::size_t most_points = 60;

/// The pin on the wall that carries: on the braking one it leans the other way.
std::optional<double> peak_of(loads::PinLine pin, const double force) {
  constexpr double accuracy = 2e-3;
  if (force < 0.) pin.clearance.tilt = -pin.clearance.tilt;
  try {
    const loads::PinLineContact contact = loads::pin_line_contact(pin, std::abs(force), accuracy);
    if (loads::peak_doubt(pin, contact) == loads::PeakDoubt::none) return contact.peak_pressure;
  } catch (const base::InputError&) {
    // no balance: no figure
  }
  return std::nullopt;
}

/// Every so many rows that a force acts in.
std::vector<EngagementPoint> loaded_points(const std::vector<loads::KinematicsRow>& rows) {
  std::vector<EngagementPoint> loaded;
  for (const loads::KinematicsRow& row : rows)
    if (row.load.force != 0.)
      loaded.push_back({row.load.driver_angle, row.load.force, row.pressure, std::nullopt});
  const std::size_t stride = loaded.size() / most_points + 1;
  std::vector<EngagementPoint> points;
  for (std::size_t i = 0; i < loaded.size(); i += stride) points.push_back(loaded[i]);
  return points;
}

/// The angle of the greatest force of either wall, which falls between the others.
void add_greatest(std::vector<EngagementPoint>& points, const loads::Characteristics& cycle,
                  const loads::PinContact& contact) {
  const auto add = [&](const loads::PlacedPeak& peak, const double sign) {
    if (!(peak.value > 0.)) return;
    const EngagementPoint point{peak.driver_angle, sign * peak.value,
                                loads::hertz_pressure(contact, peak.value), std::nullopt};
    const auto next = std::find_if(points.begin(), points.end(), [&](const EngagementPoint& other) {
      return other.driver_angle > point.driver_angle;
    });
    points.insert(next, point);
  };
  add(cycle.force, 1.);
  add(cycle.braking_force, -1.);
}

}  // namespace

std::vector<EngagementPoint> engagement(const model::MechanismCase& mechanism,
                                        const model::MechanismState& state,
                                        const std::optional<loads::PinLine>& pin) {
  const loads::PinContact contact = pin_contact(mechanism, state.sizes);
  std::vector<EngagementPoint> points =
      loaded_points(loads::kinematics_rows(state.driven, state.train, contact, steps_of_cycle));
  add_greatest(points, loads::characteristics(state.driven, state.train, contact), contact);
  if (pin)
    for (EngagementPoint& point : points) point.peak_pressure = peak_of(*pin, point.force);
  return points;
}

std::optional<LinePressures> line_pressures(const model::MechanismCase& mechanism,
                                            const model::MechanismState& state,
                                            const loads::Characteristics& cycle) {
  const auto known = model::pin_line_contact(mechanism, state);
  if (!known || loads::peak_doubt(known->pin, known->contact) != loads::PeakDoubt::none)
    return std::nullopt;
  LinePressures pressures{known->contact.peak_pressure,
                          {known->contact.peak_pressure, state.load.driver_angle, 0.}};
  for (const auto& [force, sign] :
       {std::pair(cycle.force, 1.), std::pair(cycle.braking_force, -1.)}) {
    if (!(force.value > 0.)) continue;
    const auto peak = peak_of(known->pin, sign * force.value);
    if (!peak) return std::nullopt;
    if (*peak > pressures.of_cycle.value)
      pressures.of_cycle = {*peak, force.driver_angle, force.time};
  }
  return pressures;
}

std::optional<PlacedValue> limited_pressure(const model::MechanismCase& mechanism,
                                            const loads::Characteristics& cycle) try {
  if (!mechanism.space) return PlacedValue{cycle.pressure.value, cycle.pressure.driver_angle};
  const auto line = line_pressures(mechanism, model::mechanism_state(mechanism), cycle);
  if (!line) return std::nullopt;
  return PlacedValue{line->of_cycle.value, line->of_cycle.driver_angle};
} catch (const base::InputError&) {  // nothing presses at the analysed angle
  return std::nullopt;
}

}  // namespace geneva::api
