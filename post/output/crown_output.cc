#include "post/output/crown_output.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_values.h"

namespace geneva::post {

using base::case_section;
using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::quantity;
using base::UnitSystem;
using base::versions_section;

using nlohmann::json;

namespace {

json evenness_section(const loads::LoadEvenness& load) {
  return {{"maximum_line_load", quantity(load.maximum, "N/m")},
          {"maximum_line_load_place", quantity(load.place, "m")},
          {"even_line_load", quantity(load.even, "N/m")},
          {"ratio", load.ratio()},
          {"peak_pressure", quantity(load.peak_pressure, "Pa")},
          {"mid_length_pressure", quantity(load.middle_pressure, "Pa")},
          {"edge_bounded", load.is_bounded}};
}

json map_section(const loads::ProfileMap& map) {
  json pressures = json::array();
  for (std::size_t i = 0; i < map.tilts.size(); ++i)
    pressures.push_back({{"tilt", map.tilts[i]}, {"pressures", map.pressures[i]}});
  return {{"sizes", map.sizes}, {"by_tilt", pressures}};
}

/// The columns of the table: a heading and the pin.
using Pins = std::vector<std::pair<std::string, const loads::LoadEvenness*>>;

Pins pins_of(const CrownReport& report) {
  Pins pins{{"as it is", &report.before}, {"most even", &report.after}};
  if (report.confirmed) pins.emplace_back("finite elements", &*report.confirmed);
  return pins;
}

template <typename TextOf>
std::string row(const std::string& name, const Pins& pins, const TextOf& text_of) {
  std::string text = fmt::format("{:<36}", name);
  for (const auto& [heading, load] : pins) text += fmt::format("{:>16}", text_of(heading, *load));
  return text + "\n";
}

template <typename ValueOf>
std::string row(const std::string& name, const Pins& pins, const OutputUnit& unit,
                const ValueOf& value_of) {
  const std::string heading = unit.name.empty() ? name : fmt::format("{} [{}]", name, unit.name);
  return row(heading, pins, [&](const std::string&, const loads::LoadEvenness& load) {
    return fmt::format("{:.5g}", value_of(load) * unit.factor);
  });
}

/// For which loads and tilts the profile is the best.
std::string duty_text(const CrownReport& report, const UnitSystem units) {
  const OutputUnit force = output_unit(units, Dimension::force);
  const double degrees = output_unit(units, Dimension::angle).factor;
  std::string text = fmt::format("for {:.5g} {}", report.force * force.factor, force.name);
  if (report.tilts.size() > 1)
    text += fmt::format(" and tilts from {:.3g} to {:.3g} deg; worst at {:.3g} deg",
                        report.tilts.front() * degrees, report.tilts.back() * degrees,
                        report.worst_tilt * degrees);
  return text;
}

}  // namespace

json crown_summary(const CrownReport& report) {
  json trials = json::array();
  for (const loads::ProfileTrial& trial : report.trials)
    trials.push_back({{"size", quantity(trial.size, "m")},
                      {"maximum_line_load", quantity(trial.line_load, "N/m")},
                      {"worst_tilt", quantity(trial.worst_tilt, "rad")},
                      {"ratio", trial.line_load / report.after.even}});
  json summary{{"case", case_section(report.about)},
               {"crown",
                {{"profile", report.profile},
                 {"parameter", report.parameter},
                 {"size", quantity(report.size, "m")},
                 {"drop", quantity(report.drop, "m")},
                 {"force", quantity(report.force, "N")},
                 {"least_tilt", quantity(report.tilts.front(), "rad")},
                 {"greatest_tilt", quantity(report.tilts.back(), "rad")},
                 {"worst_tilt", quantity(report.worst_tilt, "rad")}}},
               {"before", evenness_section(report.before)},
               {"after", evenness_section(report.after)},
               {"search", trials},
               {"map", map_section(report.map)},
               {"versions", versions_section(report.geneva_version)}};
  if (report.confirmed) summary["finite_elements"] = evenness_section(*report.confirmed);
  return summary;
}

std::string crown_csv(const CrownReport& report, const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit line_load = output_unit(units, Dimension::force_per_length);
  std::string text = fmt::format("pin,z [{}],line_load [{}],peak_pressure [{}]\n", length.name,
                                 line_load.name, stress.name);
  const auto add = [&](const char* const pin, const loads::LoadEvenness& load) {
    for (const loads::LoadedPlace& place : load.sections)
      text += fmt::format("{},{:.12g},{:.12g},{:.12g}\n", pin, place.z * length.factor,
                          place.line_load * line_load.factor, place.peak_pressure * stress.factor);
  };
  add("before", report.before);
  add("after", report.after);
  if (report.confirmed) add("finite elements", *report.confirmed);
  return text;
}

std::string crown_table(const CrownReport& report, const UnitSystem units) {
  using Load = loads::LoadEvenness;
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit line_load = output_unit(units, Dimension::force_per_length);
  const Pins pins = pins_of(report);
  std::string text = row("", pins, [](const std::string& heading, const Load&) { return heading; });
  text +=
      row("maximum over even line load", pins, {"", 1.}, [](const Load& l) { return l.ratio(); });
  text += row("maximum line load", pins, line_load, [](const Load& load) { return load.maximum; });
  text += row("its place along the pin", pins, length, [](const Load& load) { return load.place; });
  text += row("pressure in the middle", pins, stress,
              [](const Load& load) { return load.middle_pressure; });
  text += row("peak contact pressure", pins, stress,
              [](const Load& load) { return load.peak_pressure; });
  text += row("pressure at the ends", pins, [](const std::string&, const Load& load) {
    return load.is_bounded ? "bounded" : "not bounded";
  });
  return text + fmt::format(
                    "\n  subsection Pin\n    set Profile = {}\n    set {} = {:.4g} {}\n\n"
                    "the most even {}\n"
                    "the profile falls {:.3g} {} to the wheel's faces\n",
                    report.profile, report.parameter, report.size * length.factor, length.name,
                    duty_text(report, units), report.drop * length.factor, length.name);
}

}  // namespace geneva::post
