#include "api/limits.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "loads/material_limits.h"

namespace geneva::api {

namespace {

using base::Dimension;
using post::LimitRow;
using Rows = std::vector<LimitRow>;

/// The pressure times the slip speed, or of a roller that in its bore.
void append_wear(Rows& rows, const Case& given, const PlacedValue& wear) {
  if (!given.allowed.pressure_times_slip) return;
  rows.push_back({given.mechanism->roller ? "mean bore pressure times sliding speed"
                                          : "peak contact pressure times slip speed",
                  Dimension::pressure_times_speed, wear.value, *given.allowed.pressure_times_slip,
                  wear.driver_angle, ""});
}

/// Where peak pressure times slip is greatest on the curve between the instants.
PlacedValue greatest_wear(const post::CycleReport& report) {
  PlacedValue greatest{0., 0.};
  for (const post::CycleCurvePoint& point : report.curve) {
    const double wear = point.peak_pressure * std::abs(point.slip_speed);
    if (wear > greatest.value) greatest = {wear, point.driver_angle};
  }
  return greatest;
}

PlacedValue greatest_force(const post::CycleReport& report) {
  PlacedValue greatest{0., 0.};
  for (const post::CycleCurvePoint& point : report.curve)
    if (std::abs(point.force) > greatest.value)
      greatest = {std::abs(point.force), point.driver_angle};
  return greatest;
}

/// Whether there are closed forms of them: in 3-D contacts are ellipses, of which those with
/// friction or a hardened layer have none.
bool has_yield_limits(const Case& given, const std::string& body) {
  const model::MechanismCase& mechanism = *given.mechanism;
  if (!mechanism.space) return true;
  return mechanism.slot_friction == 0. && given.allowed.layers.count(body) == 0;
}

}  // namespace

std::string unjudged_yield(const Case& given) {
  std::vector<std::string> bodies;
  for (const char* const body : {"pin", "wheel"})
    if (given.allowed.yield_strengths.count(body) > 0 && !has_yield_limits(given, body))
      bodies.emplace_back(body);
  if (bodies.empty()) return "";
  return fmt::format(
      "first yield and shakedown of the contact of the {}: there is no closed form for a contact "
      "in 3-D {}",
      fmt::join(bodies, " and of the "),
      given.mechanism->slot_friction > 0. ? "with friction" : "with a hardened layer");
}

std::vector<LimitRow> pressure_limits(const Case& given, const loads::PinContact& contact,
                                      const PlacedValue& pressure) {
  Rows rows;
  const auto add = [&](const std::string& quantity, const double allowed,
                       const std::string& meaning) {
    rows.push_back(
        {quantity, Dimension::stress, pressure.value, allowed, pressure.driver_angle, meaning});
  };
  const model::MechanismCase& mechanism = *given.mechanism;
  if (given.allowed.contact_pressure)
    add("peak contact pressure", *given.allowed.contact_pressure, "");
  const loads::ContactKind line{0., mechanism.slot_friction,
                                contact.pin_diameter / contact.contact_modulus};
  for (const loads::TouchingBody& body :
       {loads::TouchingBody{"pin", mechanism.pin.poissons_ratio},
        loads::TouchingBody{"wheel", mechanism.wheel.poissons_ratio}})
    for (const loads::MaterialLimit& limit : loads::material_limits(
             body, has_yield_limits(given, body.name) ? std::optional(line) : std::nullopt,
             given.allowed))
      add("contact, " + limit.name, limit.pressure, limit.meaning);
  return rows;
}

namespace {

/// Of a roller on needles under the greatest force of the cycle.
void append_needles(Rows& rows, const Case& given, const PlacedValue& force) {
  const auto& roller = given.mechanism->roller;
  if (!roller || !roller->needles) return;
  const double pressure = loads::needle_pressure(
      *roller->needles, roller->diameter, force.value,
      {given.mechanism->stud.youngs_modulus, given.mechanism->stud.poissons_ratio});
  for (const loads::NeedleLimit& limit : loads::needle_limits(given.allowed))
    rows.push_back({limit.name, Dimension::stress, pressure, limit.pressure, force.driver_angle,
                    limit.meaning});
}

}  // namespace

std::vector<LimitRow> motion_limits(const Case& given, const loads::PinContact& contact,
                                    const loads::Characteristics& values,
                                    const std::optional<PlacedValue>& pressure) {
  Rows rows;
  if (pressure) rows = pressure_limits(given, contact, *pressure);
  if (given.mechanism->roller) {
    const loads::PlacedPeak& wear = values.bore_pressure_times_speed;
    append_wear(rows, given, {wear.value, wear.driver_angle});
  } else if (pressure && values.pressure.value > 0.) {
    const loads::PlacedPeak& wear = values.pressure_times_slip;
    append_wear(rows, given,
                {wear.value * pressure->value / values.pressure.value, wear.driver_angle});
  }
  const loads::PlacedPeak& force =
      values.braking_force.value > values.force.value ? values.braking_force : values.force;
  append_needles(rows, given, {force.value, force.driver_angle});
  return rows;
}

std::vector<LimitRow> cycle_limits(const Case& given, const loads::PinContact& contact,
                                   const post::CycleReport& report) {
  Rows rows;
  if (const post::CyclePoint* const greatest = post::greatest_pressure(report))
    rows = pressure_limits(given, contact,
                           {greatest->contact->peak_pressure, greatest->instant.load.driver_angle});
  if (!given.mechanism->roller) append_wear(rows, given, greatest_wear(report));
  append_needles(rows, given, greatest_force(report));
  for (const post::CycleStressRange& range : post::stress_ranges(report)) {
    const post::CycleStress& stress = range.greatest;
    const bool is_tensile = stress.name == "tensile stress";
    const auto& strengths =
        is_tensile ? given.allowed.fatigue_strengths : given.allowed.yield_strengths;
    const auto strength = strengths.find(stress.body);
    if (strength == strengths.end()) continue;
    rows.push_back({stress.name + " away from the contact" + (is_tensile ? " (fatigue), " : ", ") +
                        stress.body,
                    Dimension::stress, range.range(), strength->second, range.driver_angle,
                    stress.where});
  }
  return rows;
}

}  // namespace geneva::api
