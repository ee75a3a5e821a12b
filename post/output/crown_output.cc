#include "post/output/crown_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/errors.h"
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
  return {{"greatest_line_load", quantity(load.greatest, "N/m")},
          {"greatest_line_load_place", quantity(load.place, "m")},
          {"even_line_load", quantity(load.even, "N/m")},
          {"ratio", load.ratio()},
          {"peak_pressure", quantity(load.peak_pressure, "Pa")},
          {"mid_length_pressure", quantity(load.middle_pressure, "Pa")},
          {"edge_bounded", load.is_bounded}};
}

/// Part of the length over which the line load is averaged.
constexpr double window = 0.05;

/// Load up to a place: the line load is linear between the sections.
double load_up_to(const std::vector<ContactSection>& sections, const double z) {
  double load = 0.;
  for (std::size_t i = 1; i < sections.size() && sections[i - 1].z < z; ++i) {
    const ContactSection& from = sections[i - 1];
    const ContactSection& to = sections[i];
    const double step = std::min(z, to.z) - from.z;
    const double end = from.line_load + step / (to.z - from.z) * (to.line_load - from.line_load);
    load += step * (from.line_load + end) / 2.;
  }
  return load;
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

GreatestMean greatest_mean_load(const std::vector<ContactSection>& sections, const double length) {
  GreatestMean greatest{0., 0.};
  // a mean is greatest around a peak, or where the window begins or ends at an end of the load
  for (const ContactSection& section : sections)
    for (const double start : {section.z, section.z - length / 2., section.z - length}) {
      const double mean =
          (load_up_to(sections, start + length) - load_up_to(sections, start)) / length;
      if (mean > greatest.value) greatest = {mean, start + length / 2.};
    }
  return greatest;
}

LoadEvenness load_evenness(const fem::Solution<3>& solution, const Results<3>& results) {
  const std::size_t leading = leading_contact(solution);
  const fem::ContactResult<3>& contact = solution.contacts[leading];
  const auto& sections = results.contacts[leading].sections;
  if (sections.empty()) throw base::InputError("the contact carries no load along its length");
  const ContactFrame& frame = results.contacts[leading].frame;
  const double length = common_length(contact, frame);
  const GreatestMean greatest = greatest_mean_load(sections, window * length);
  double force = 0.;
  for (const fem::ContactNode<3>& node : contact.nodes) force += node.pressure * node.tributary;
  return {greatest.value,
          greatest.place,
          frame.parts() * force / length,
          contact.peak_pressure,
          middle_section(contact, frame, sections).peak_pressure,
          !solution.edge || solution.edge->is_bounded,
          sections};
}

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
         row("greatest over even line load", before.ratio(), after.ratio(), {"", 1.}) +
         row("greatest line load", before.greatest, after.greatest, line_load) +
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
