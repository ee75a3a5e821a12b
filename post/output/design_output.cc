#include "post/output/design_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/json_values.h"

namespace geneva::post {

using base::case_section;
using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::quantity;
using base::UnitSystem;
using base::versions_section;

using loads::DesignedWheel;
using nlohmann::json;

namespace {

json wheel_section(const DesignedWheel& wheel, const char* prefix) {
  return {{std::string(prefix) + "diameter", quantity(wheel.diameter, "m")},
          {std::string(prefix) + "inertia", quantity(wheel.inertia, "kg m^2")},
          {"force", quantity(wheel.force, "N")},
          {"peak_pressure", quantity(wheel.peak_pressure, "Pa")},
          {"pin_diameter", quantity(wheel.pin_diameter, "m")},
          {"thickness", quantity(wheel.thickness, "m")},
          {"locking_radius", quantity(wheel.locking_radius, "m")}};
}

json geometry_section(const DesignReport& report) {
  json section = wheel_section(report.drawn.wheel, "optimum_");
  section["inertia_ratio"] = report.drawn.inertia_ratio;
  section["at_limit"] = report.drawn.at_limit;
  section["given_lengths"] =
      report.given_lengths == loads::GivenLengths::scale ? "scale with the wheel" : "stay as given";
  return section;
}

json motion_section(const DesignReport& report) {
  return {{"peak_acceleration", quantity(report.peak_acceleration, "rad/s^2")},
          {"exit_acceleration", quantity(report.exit_acceleration, "rad/s^2")},
          {"motion_time", quantity(report.cycle.motion_time, "s")},
          {"dwell_time", quantity(report.cycle.dwell_time, "s")},
          {"motion_fraction", report.cycle.motion_fraction},
          {"k_t", report.cycle.time_ratio},
          {"maximum_pins", report.cycle.maximum_pins}};
}

json shaft_section(const ShaftReport& shaft) {
  json section{{"torque", quantity(shaft.vibration.torque, "N m")},
               {"stiffness", quantity(shaft.vibration.stiffness, "N m/rad")},
               {"twist", quantity(shaft.vibration.twist, "rad")},
               {"frequency", quantity(shaft.vibration.frequency, "Hz")},
               {"energy", quantity(shaft.vibration.energy, "J")},
               {"inertia", quantity(shaft.inertia, "kg m^2")},
               {"inertia_added", shaft.is_inertia_added}};
  if (shaft.amplitude_radius) {
    section["amplitude_radius"] = quantity(*shaft.amplitude_radius, "m");
    section["double_amplitude"] =
        quantity(shaft.vibration.double_amplitude(*shaft.amplitude_radius), "m");
  }
  return section;
}

json table_section() {
  json table = json::array();
  for (const loads::DesignTableRow& row : loads::design_table()) {
    table.push_back({{"n", row.johnson.stations},
                     {"beta", quantity(row.johnson.peak_acceleration_angle, "rad")},
                     {"a_max", row.johnson.peak_acceleration_ratio},
                     {"a_v", row.johnson.exit_acceleration_ratio},
                     {"k", row.johnson.k},
                     {"k2", row.johnson.k2},
                     {"k3", row.johnson.k3},
                     {"k4", row.johnson.k4},
                     {"k5_geometry", row.drawn_k5}});
    if (row.johnson.k5) table.back()["k5"] = *row.johnson.k5;
  }
  return table;
}

json strength_section(const std::vector<WheelStrength>& strength) {
  json rows = json::array();
  for (const WheelStrength& wheel : strength)
    rows.push_back({{"diameter", quantity(wheel.diameter, "m")},
                    {"peak_pressure", quantity(wheel.peak_pressure, "Pa")},
                    {"peak_pressure_error", wheel.peak_pressure_error},
                    {"von_mises", quantity(wheel.von_mises, "Pa")},
                    {"von_mises_error", wheel.von_mises_error},
                    {"tensile", quantity(wheel.tensile, "Pa")},
                    {"tensile_error", wheel.tensile_error},
                    {"where", wheel.where}});
  return rows;
}

}  // namespace

json design_summary(const DesignReport& report) {
  json result = report.johnson ? wheel_section(*report.johnson, "optimum_") : json::object();
  result["case"] = case_section(report.about);
  result["stations"] = report.row.stations;
  result["load_inertia"] = quantity(report.load.load_inertia, "kg m^2");
  result["friction_moment"] = quantity(report.load.friction_moment, "N m");
  result["motion"] = motion_section(report);
  result["geometry"] = geometry_section(report);
  result["wheel"] = wheel_section(report.own, "");
  result["wheel"]["has_johnsons_inertia"] = report.has_johnsons_inertia;
  if (report.pressure_ratio) result["wheel"]["peak_pressure_ratio"] = *report.pressure_ratio;
  if (report.shaft) result["shaft"] = shaft_section(*report.shaft);
  if (!report.strength.empty()) result["strength"] = strength_section(report.strength);
  result["table"] = table_section();
  result["versions"] = versions_section(report.geneva_version);
  return result;
}

std::string strength_table(const DesignReport& report, const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::string text =
      fmt::format("{:>14}{:>30}{:>30}{:>30}\n", fmt::format("diameter [{}]", length.name),
                  fmt::format("contact pressure [{}]", stress.name),
                  fmt::format("von Mises stress [{}]", stress.name),
                  fmt::format("tensile stress [{}]", stress.name));
  const auto with_error = [&](const double value, const double error) {
    return fmt::format("{:.5g} +- {:.2g} %", value * stress.factor, 100. * error);
  };
  for (const WheelStrength& wheel : report.strength)
    text += fmt::format("{:>14.5g}{:>30}{:>30}{:>30}\n", wheel.diameter * length.factor,
                        with_error(wheel.peak_pressure, wheel.peak_pressure_error),
                        with_error(wheel.von_mises, wheel.von_mises_error),
                        with_error(wheel.tensile, wheel.tensile_error));
  return text;
}

std::string design_csv(const DesignReport& report, const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit inertia = output_unit(units, Dimension::inertia);
  const OutputUnit force = output_unit(units, Dimension::force);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::string text = fmt::format("diameter [{}]", length.name);
  for (const char* wheel : {"johnson", "geometry"})
    text += fmt::format(",inertia_{0} [{1}],force_{0} [{2}],stress_{0} [{3}]", wheel, inertia.name,
                        force.name, stress.name);
  text += '\n';
  const auto fields = [&](const std::optional<DesignedWheel>& wheel) {
    return wheel ? fmt::format(",{:.12g},{:.12g},{:.12g}", wheel->inertia * inertia.factor,
                               wheel->force * force.factor, wheel->peak_pressure * stress.factor)
                 : std::string(",,,");
  };
  for (const loads::DesignPoint& point : report.curve)
    text += fmt::format("{:.12g}{}{}\n", point.diameter * length.factor, fields(point.johnson),
                        fields(point.drawn));
  return text;
}

namespace {

/// One line of the table: a value of each report, or nothing; a line without values is a heading.
struct TableLine {
  std::string name;
  std::function<std::optional<double>(const DesignReport&)> value;
};

/// "  pin force [lbf]" and the values in that unit.
TableLine in_unit(const std::string& name, const OutputUnit& unit,
                  const std::function<std::optional<double>(const DesignReport&)>& value) {
  return {fmt::format("  {} [{}]", name, unit.name),
          [=](const DesignReport& report) -> std::optional<double> {
            const auto found = value(report);
            return found ? std::optional(*found * unit.factor) : std::nullopt;
          }};
}

void add_motion(std::vector<TableLine>& lines, const UnitSystem units) {
  const OutputUnit acceleration{"rad/s^2", 1.};
  const OutputUnit seconds{"s", 1.};
  lines.push_back({"motion", {}});
  lines.push_back({"  stations", [](const DesignReport& r) { return r.row.stations; }});
  lines.push_back(in_unit("maximum wheel acceleration", acceleration,
                          [](const DesignReport& r) { return r.peak_acceleration; }));
  lines.push_back(in_unit("deceleration as the pin leaves", acceleration,
                          [](const DesignReport& r) { return r.exit_acceleration; }));
  lines.push_back(in_unit("load inertia", output_unit(units, Dimension::inertia),
                          [](const DesignReport& r) { return r.load.load_inertia; }));
  lines.push_back(
      in_unit("motion time", seconds, [](const DesignReport& r) { return r.cycle.motion_time; }));
  lines.push_back(
      in_unit("dwell time", seconds, [](const DesignReport& r) { return r.cycle.dwell_time; }));
  lines.push_back(
      {"  motion time over dwell time", [](const DesignReport& r) { return r.cycle.time_ratio; }});
  lines.push_back({"  motion time over a turn's time",
                   [](const DesignReport& r) { return r.cycle.motion_fraction; }});
  lines.push_back(
      {"  maximum number of pins", [](const DesignReport& r) { return r.cycle.maximum_pins; }});
}

using WheelOf = std::function<std::optional<DesignedWheel>(const DesignReport&)>;

void add_wheel(std::vector<TableLine>& lines, const std::string& heading, const UnitSystem units,
               const WheelOf& wheel) {
  const auto add = [&](const char* name, const Dimension dimension,
                       double DesignedWheel::*const member) {
    lines.push_back(in_unit(name, output_unit(units, dimension),
                            [=](const DesignReport& report) -> std::optional<double> {
                              const auto found = wheel(report);
                              return found ? std::optional((*found).*member) : std::nullopt;
                            }));
  };
  lines.push_back({heading, {}});
  add("diameter", Dimension::length, &DesignedWheel::diameter);
  add("pin diameter", Dimension::length, &DesignedWheel::pin_diameter);
  add("thickness", Dimension::length, &DesignedWheel::thickness);
  add("locking radius", Dimension::length, &DesignedWheel::locking_radius);
  add("inertia", Dimension::inertia, &DesignedWheel::inertia);
  add("pin force", Dimension::force, &DesignedWheel::force);
  add("peak contact pressure", Dimension::stress, &DesignedWheel::peak_pressure);
}

void add_shaft(std::vector<TableLine>& lines, const UnitSystem units) {
  const auto add = [&](const char* name, const OutputUnit& unit,
                       const std::function<std::optional<double>(const ShaftReport&)>& value) {
    lines.push_back(in_unit(name, unit, [=](const DesignReport& report) {
      return report.shaft ? value(*report.shaft) : std::nullopt;
    }));
  };
  lines.push_back({"load on its shaft", {}});
  add("torque as the pin leaves", output_unit(units, Dimension::moment),
      [](const ShaftReport& shaft) { return shaft.vibration.torque; });
  add("twist", {"rad", 1.}, [](const ShaftReport& shaft) { return shaft.vibration.twist; });
  add("double amplitude", output_unit(units, Dimension::length),
      [](const ShaftReport& shaft) -> std::optional<double> {
        if (!shaft.amplitude_radius) return std::nullopt;
        return shaft.vibration.double_amplitude(*shaft.amplitude_radius);
      });
  add("at the radius", output_unit(units, Dimension::length),
      [](const ShaftReport& shaft) { return shaft.amplitude_radius; });
  add("natural frequency", {"Hz", 1.},
      [](const ShaftReport& shaft) { return shaft.vibration.frequency; });
  add("energy", output_unit(units, Dimension::moment),
      [](const ShaftReport& shaft) { return shaft.vibration.energy; });
  add("inertia of the shaft", output_unit(units, Dimension::inertia),
      [](const ShaftReport& shaft) { return shaft.inertia; });
}

/// Five digits, without an exponent where a stress in psi would get one.
std::string cell(const std::optional<double>& value) {
  if (!value) return "-";
  return *value >= 1e5 && *value < 1e7 ? fmt::format("{:.0f}", *value)
                                       : fmt::format("{:.5g}", *value);
}

std::vector<TableLine> table_lines(const std::vector<DesignReport>& reports,
                                   const UnitSystem units) {
  std::vector<TableLine> lines;
  add_motion(lines, units);
  add_wheel(lines, "best wheel, Johnson's proportions", units,
            [](const DesignReport& report) { return report.johnson; });
  add_wheel(lines, "best wheel as drawn", units,
            [](const DesignReport& report) { return report.drawn.wheel; });
  lines.push_back({"  inertia over J_L + M_f/a",
                   [](const DesignReport& report) { return report.drawn.inertia_ratio; }});
  add_wheel(lines, "wheel of the case", units,
            [](const DesignReport& report) { return report.own; });
  lines.push_back({"  pressure over that of Johnson's best wheel",
                   [](const DesignReport& report) { return report.pressure_ratio; }});
  if (std::any_of(reports.begin(), reports.end(),
                  [](const DesignReport& report) { return report.shaft.has_value(); }))
    add_shaft(lines, units);
  return lines;
}

}  // namespace

std::string design_table(const std::vector<DesignReport>& reports, const UnitSystem units) {
  constexpr std::size_t name_width = 44;
  std::size_t width = 14;
  for (const DesignReport& report : reports) width = std::max(width, report.about.name.size() + 2);
  std::string table = fmt::format("{:<{}}", "", name_width);
  for (const DesignReport& report : reports)
    table += fmt::format("{:>{}}", report.about.name, width);
  table += '\n';
  for (const TableLine& line : table_lines(reports, units)) {
    table += line.value ? fmt::format("{:<{}}", line.name, name_width) : line.name;
    for (const DesignReport& report : reports) {
      if (!line.value) break;
      table += fmt::format("{:>{}}", cell(line.value(report)), width);
    }
    table += '\n';
  }
  return table;
}

}  // namespace geneva::post
