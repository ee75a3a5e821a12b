#include "post/output/cycle_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loads/pi.h"
#include "post/output/kinematics_output.h"

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;

namespace {

constexpr double degrees = 1. / loads::degree;

double relative(const double value, const double to) { return to == 0. ? 0. : value / to - 1.; }

/// "-9.934 deg  driving  ..."
std::string line_of(const CyclePoint& point, const UnitSystem units) {
  const OutputUnit force = output_unit(units, Dimension::force);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const loads::PinLoad& load = point.instant.load;
  const std::string begin = fmt::format(
      "{:>10.4f} {:>8} {:>12.5g} {:>14.6g}", load.driver_angle * degrees, name_of(load.wall),
      std::abs(load.force) * force.factor, point.hertz_pressure * stress.factor);
  const std::string role = loads::name_of(point.instant.role);
  if (!point.contact) return fmt::format("{} {:>14} {:>10} {:>8}  {}\n", begin, "-", "", "", role);
  const CycleContact& contact = *point.contact;
  return fmt::format("{} {:>14.6g} {:>10} {:>+8.2f}  {}{}\n", begin,
                     contact.peak_pressure * stress.factor,
                     contact.error < 1. ? fmt::format("+- {:.2g} %", 100. * contact.error) : "+- ?",
                     100. * relative(contact.peak_pressure, point.hertz_pressure), role,
                     contact.hertz_objection.empty() ? "" : " (no Hertz: see the notes)");
}

std::string ranges_text(const CycleReport& report, const UnitSystem units) {
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::string text;
  for (const CycleStressRange& range : stress_ranges(report)) {
    text += fmt::format(
        "greatest {} of the {}: {:.5g} {} +- {:.2g} % at {:.4f} deg, {}\n", range.greatest.name,
        range.greatest.body, range.greatest.value * stress.factor, stress.name,
        100. * range.greatest.error, range.driver_angle * degrees, range.greatest.where);
    if (range.swing && range.swing->driver_angle)
      text += fmt::format("  along it {:.5g} {} at {:.4f} deg: a range of {:.5g} {}\n",
                          range.swing->least * stress.factor, stress.name,
                          *range.swing->driver_angle * degrees, range.range() * stress.factor,
                          stress.name);
  }
  return text;
}

}  // namespace

const CyclePoint* greatest_pressure(const CycleReport& report) {
  const CyclePoint* greatest = nullptr;
  for (const CyclePoint& point : report.points)
    if (point.contact && point.contact->shortfall.empty() &&
        (greatest == nullptr || point.contact->peak_pressure > greatest->contact->peak_pressure))
      greatest = &point;
  return greatest;
}

std::vector<CycleStressRange> stress_ranges(const CycleReport& report) {
  std::vector<CycleStressRange> ranges;
  for (const CyclePoint& point : report.points) {
    if (!point.contact) continue;
    for (const CycleStress& stress : point.contact->stresses) {
      const auto range =
          std::find_if(ranges.begin(), ranges.end(), [&](const CycleStressRange& one) {
            return one.greatest.body == stress.body && one.greatest.name == stress.name;
          });
      const double angle = point.instant.load.driver_angle;
      if (range == ranges.end()) {
        ranges.push_back({stress, angle, std::nullopt});
        continue;
      }
      if (stress.value <= range->greatest.value) continue;
      range->greatest = stress;
      range->driver_angle = angle;
    }
  }
  for (CycleStressRange& range : ranges)
    for (const Swing& swing : report.swings)
      if (range.greatest.name == "tensile stress" && swing.body == range.greatest.body)
        range.swing = swing;
  return ranges;
}

std::string instant_in_words(const loads::CycleInstant& instant) {
  return fmt::format("{:.6g} deg, {} wall, {}", instant.load.driver_angle * degrees,
                     name_of(instant.load.wall), loads::name_of(instant.role));
}

std::string cycle_csv(const CycleReport& report, const UnitSystem units) {
  const auto unit = [&](const Dimension dimension) { return output_unit(units, dimension); };
  const OutputUnit force = unit(Dimension::force);
  const OutputUnit length = unit(Dimension::length);
  const OutputUnit stress = unit(Dimension::stress);
  const OutputUnit speed = unit(Dimension::speed);
  const OutputUnit moment = unit(Dimension::moment);
  std::string text = fmt::format(
      "role,engagement,time [s],driver_angle [deg],wall,pin_force [{0}],pin_distance [{1}],"
      "slip_speed [{2}],hertz_pressure [{3}],peak_pressure [{3}],error,half_width [{1}],"
      "bore_torque [{4}],expected_bore_torque [{4}]\n",
      force.name, length.name, speed.name, stress.name, moment.name);
  for (const CyclePoint& point : report.points) {
    const loads::PinLoad& load = point.instant.load;
    text += fmt::format("{},{},{:.9g},{:.9g},{},{:.9g},{:.9g},{:.9g},{:.9g},",
                        loads::name_of(point.instant.role), point.instant.engagement + 1, load.time,
                        load.driver_angle * degrees, name_of(load.wall),
                        std::abs(load.force) * force.factor, load.pin_distance * length.factor,
                        load.slip_speed * speed.factor, point.hertz_pressure * stress.factor);
    if (!point.contact) {
      text += ",,,,\n";
      continue;
    }
    const CycleContact& contact = *point.contact;
    text += fmt::format(
        "{:.9g},{:.3g},{:.9g},{},{:.9g}\n", contact.peak_pressure * stress.factor, contact.error,
        contact.half_width * length.factor,
        contact.bore_torque ? fmt::format("{:.9g}", *contact.bore_torque * moment.factor) : "",
        contact.expected_bore_torque * moment.factor);
  }
  return text;
}

std::string cycle_curve_csv(const CycleReport& report, const UnitSystem units) {
  const OutputUnit force = output_unit(units, Dimension::force);
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit speed = output_unit(units, Dimension::speed);
  const OutputUnit wear = output_unit(units, Dimension::pressure_times_speed);
  std::string text = fmt::format(
      "driver_angle [deg],wall,pin_force [{}],pin_distance [{}],pin_turn [deg],hertz_pressure [{}],"
      "peak_pressure [{}],slip_speed [{}],pressure_times_slip [{}],wall_heat [J/m^2],"
      "pin_heat [J/m^2]\n",
      force.name, length.name, stress.name, stress.name, speed.name, wear.name);
  const auto cell = [](const double value) {
    return std::isfinite(value) ? fmt::format("{:.9g}", value) : std::string();
  };
  for (const CycleCurvePoint& point : report.curve) {
    const loads::Wall wall = point.force > 0.   ? loads::Wall::driving
                             : point.force < 0. ? loads::Wall::braking
                                                : loads::Wall::none;
    text += fmt::format("{:.9g},{},{:.9g},{:.9g},{:.9g},{:.9g},{},{:.9g},{},{},{}\n",
                        point.driver_angle * degrees, name_of(wall),
                        std::abs(point.force) * force.factor, point.pin_distance * length.factor,
                        point.pin_turn * degrees, point.hertz_pressure * stress.factor,
                        cell(point.peak_pressure * stress.factor), point.slip_speed * speed.factor,
                        cell(point.peak_pressure * std::abs(point.slip_speed) * wear.factor),
                        cell(point.wall_heat), cell(point.pin_heat));
  }
  return text;
}

std::string cycle_table(const CycleReport& report, const UnitSystem units) {
  const OutputUnit force = output_unit(units, Dimension::force);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::string text =
      fmt::format("{:>10} {:>8} {:>12} {:>14} {:>14} {:>10} {:>8}\n", "angle deg", "wall",
                  fmt::format("force {}", force.name), fmt::format("Hertz {}", stress.name),
                  fmt::format("peak {}", stress.name), "error", "to Hertz");
  for (const CyclePoint& point : report.points) text += line_of(point, units);
  for (const double angle : report.wall_changes)
    text +=
        fmt::format("the wall changes at {:.6g} deg, where nothing is pressed\n", angle * degrees);
  if (const CyclePoint* const greatest = greatest_pressure(report))
    text +=
        fmt::format("greatest peak pressure: {:.6g} {} +- {:.2g} % at {:.4f} deg, {} wall\n",
                    greatest->contact->peak_pressure * stress.factor, stress.name,
                    100. * greatest->contact->error, greatest->instant.load.driver_angle * degrees,
                    name_of(greatest->instant.load.wall));
  text += ranges_text(report, units) + limit_lines(report.limits, units);
  const CycleWork& work = report.work;
  if (work.friction > 0.)
    text += fmt::format("friction in the slot takes {:.4g} J of each engagement{}\n", work.friction,
                        work.driving > 0.
                            ? fmt::format(", {:.2f} % of what drives the wheel",
                                          100. * work.friction / (work.driving + work.friction))
                            : "");
  return text;
}

}  // namespace geneva::post
