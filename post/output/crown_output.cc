#include "post/output/crown_output.h"

#include <fmt/format.h>

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

using nlohmann::json;

namespace {

json evenness_section(const LoadEvenness& load) {
  return {{"maximum_line_load", quantity(load.maximum, "N/m")},
          {"maximum_line_load_place", quantity(load.place, "m")},
          {"even_line_load", quantity(load.even, "N/m")},
          {"ratio", load.ratio()},
          {"peak_pressure", quantity(load.peak_pressure, "Pa")},
          {"mid_length_pressure", quantity(load.middle_pressure, "Pa")},
          {"edge_bounded", load.is_bounded}};
}

std::string row(const std::string& name, const std::string& before, const std::string& after) {
  return fmt::format("{:<36}{:>16}{:>16}\n", name, before, after);
}

std::string row(const std::string& name, const double before, const double after,
                const OutputUnit& unit) {
  const std::string heading = unit.name.empty() ? name : fmt::format("{} [{}]", name, unit.name);
  return row(heading, fmt::format("{:.5g}", before * unit.factor),
             fmt::format("{:.5g}", after * unit.factor));
}

}  // namespace

json crown_summary(const CrownReport& report) {
  json trials = json::array();
  for (const CrownTrial& trial : report.trials)
    trials.push_back({{"size", quantity(trial.size, "m")},
                      {"ratio", trial.ratio},
                      {"meshes", trial.is_scan ? "coarse" : "finer"}});
  return {{"case", case_section(report.about)},
          {"crown",
           {{"profile", report.profile},
            {"parameter", report.parameter},
            {"size", quantity(report.size, "m")},
            {"drop", quantity(report.drop, "m")}}},
          {"before", evenness_section(report.before)},
          {"after", evenness_section(report.after)},
          {"search", trials},
          {"versions", versions_section(report.geneva_version)}};
}

std::string crown_csv(const CrownReport& report, const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit line_load = output_unit(units, Dimension::force_per_length);
  std::string text = fmt::format("pin,z [{}],line_load [{}],peak_pressure [{}]\n", length.name,
                                 line_load.name, stress.name);
  const auto add = [&](const char* const pin, const LoadEvenness& load) {
    for (const ContactSection& section : load.sections)
      text +=
          fmt::format("{},{:.12g},{:.12g},{:.12g}\n", pin, section.z * length.factor,
                      section.line_load * line_load.factor, section.peak_pressure * stress.factor);
  };
  add("before", report.before);
  add("after", report.after);
  return text;
}

std::string crown_table(const CrownReport& report, const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit line_load = output_unit(units, Dimension::force_per_length);
  const LoadEvenness& before = report.before;
  const LoadEvenness& after = report.after;
  const auto edge = [](const LoadEvenness& load) {
    return load.is_bounded ? "bounded" : "not bounded";
  };
  return row("", "as it is", "most even") +
         row("maximum over even line load", before.ratio(), after.ratio(), {"", 1.}) +
         row("maximum line load", before.maximum, after.maximum, line_load) +
         row("its place along the pin", before.place, after.place, length) +
         row("pressure in the middle", before.middle_pressure, after.middle_pressure, stress) +
         row("peak contact pressure", before.peak_pressure, after.peak_pressure, stress) +
         row("pressure at the ends", edge(before), edge(after)) +
         fmt::format(
             "\n  subsection Pin\n    set Profile = {}\n    set {} = {:.4g} {}\n\n"
             "the profile falls {:.3g} {} to the wheel's faces\n",
             report.profile, report.parameter, report.size * length.factor, length.name,
             report.drop * length.factor, length.name);
}

}  // namespace geneva::post
