#include "post/output/estimate_output.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/json_values.h"

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::quantity;
using base::UnitSystem;

using nlohmann::json;

namespace {

json line_section(const loads::PinLineContact& line, const double wheel_twist) {
  return {{"peak_pressure", quantity(line.peak_pressure, "Pa")},
          {"peak_pressure_place", quantity(line.peak_place, "m")},
          {"begin", quantity(line.begin, "m")},
          {"end", quantity(line.end, "m")},
          {"root_moment", quantity(line.root_moment, "N m")},
          {"root_stress", quantity(line.root_stress, "Pa")},
          {"deflection", quantity(line.deflection, "m")},
          {"slope", quantity(line.slope, "rad")},
          {"approach", quantity(line.approach, "m")},
          {"wheel_twist", quantity(wheel_twist, "rad/(N m)")},
          {"sections", line.sections.size()},
          {"error_of_sections", line.error}};
}

const char* name_of(const loads::PeakDoubt doubt) {
  switch (doubt) {
    case loads::PeakDoubt::reaches_edge:
      return "reaches the edge";
    case loads::PeakDoubt::at_profile_end:
      return "at the end of the profile";
    case loads::PeakDoubt::not_settled:
      return "not settled";
    case loads::PeakDoubt::none:
      break;
  }
  return "none";
}

json engagement_section(const std::vector<EngagementPoint>& points) {
  json section{{"driver_angle", json::array()},
               {"force", json::array()},
               {"even_pressure", json::array()},
               {"peak_pressure", json::array()}};
  for (const EngagementPoint& point : points) {
    section["driver_angle"].push_back(point.driver_angle);
    section["force"].push_back(point.force);
    section["even_pressure"].push_back(point.even_pressure);
    section["peak_pressure"].push_back(point.peak_pressure ? json(*point.peak_pressure)
                                                           : json(nullptr));
  }
  return section;
}

/// Stress in the plane of symmetry below each section, by McEwen's field of its load.
std::string sections_csv(const EstimateReport& report, const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit load = output_unit(units, Dimension::force_per_length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::string text = fmt::format(
      "z [{0}],line load [{1}],pressure [{2}],half-width [{0}],maximum shear [{2}],"
      "depth of maximum shear [{0}],maximum von Mises [{2}],depth of maximum von Mises [{0}]\n",
      length.name, load.name, stress.name);
  for (const loads::PinSection& section : report.line->sections) {
    const bool is_loaded = section.line_load > 0.;
    const loads::HertzLine hertz =
        is_loaded
            ? loads::hertz_line(section.line_load, report.relative_radius, report.contact_modulus)
            : loads::HertzLine{};
    const loads::DeepStress deep =
        is_loaded ? loads::maximum_von_mises(hertz, report.poissons_ratio) : loads::DeepStress{};
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                        section.place * length.factor, section.line_load * load.factor,
                        hertz.peak_pressure * stress.factor, hertz.half_width * length.factor,
                        hertz.max_shear * stress.factor, hertz.max_shear_depth * length.factor,
                        deep.value * stress.factor, deep.depth * length.factor);
  }
  return text;
}

std::string depth_csv(const EstimateReport& report, const UnitSystem units) {
  constexpr int n_depths = 60;
  constexpr double deepest = 3.;  // in half-widths
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::string text = fmt::format(
      "depth [{0}],stress along the wall [{1}],stress normal to it [{1}],"
      "shear [{1}]\n",
      length.name, stress.name);
  for (int i = 0; i <= n_depths; ++i) {
    const double depth = report.even.half_width * deepest * i / n_depths;
    const loads::ContactStress at = report.even.stress(0., depth);
    text +=
        fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", depth * length.factor, at.xx * stress.factor,
                    at.zz * stress.factor, (at.xx - at.zz) / 2. * stress.factor);
  }
  return text;
}

}  // namespace

json estimate_summary(const EstimateReport& report) {
  json rows = json::array();
  for (const EstimateRow& row : report.rows)
    rows.push_back({{"quantity", row.quantity},
                    {"dimension", base::name_of(row.dimension)},
                    {"value", base::quantity(row.value, row.dimension)},
                    {"basis", row.basis}});
  json summary{{"case", base::case_section(report.about)},
               {"versions", base::versions_section(report.geneva_version)},
               {"mechanism", report.mechanism},
               {"load",
                {{"driver_angle", quantity(report.load.driver_angle, "rad")},
                 {"force", quantity(report.load.force, "N")}}},
               {"hertz",
                {{"peak_pressure", quantity(report.even.peak_pressure, "Pa")},
                 {"half_width", quantity(report.even.half_width, "m")}}},
               {"estimate", rows},
               {"safety", limits_section(report.limits)},
               {"left_out", report.left_out}};
  summary["engagement"] = engagement_section(report.engagement);
  if (!report.line) {
    if (report.expected_error) summary["hertz"]["expected_error"] = *report.expected_error;
    return summary;
  }
  summary["half_space_and_beam"] = line_section(*report.line, report.wheel_twist);
  summary["half_space_and_beam"]["peak_doubt"] = name_of(report.doubt);
  if (report.expected_error)
    summary["half_space_and_beam"]["expected_error"] = *report.expected_error;
  return summary;
}

std::string estimate_csv(const EstimateReport& report, const UnitSystem units) {
  return report.line ? sections_csv(report, units) : depth_csv(report, units);
}

std::string estimate_table(const EstimateReport& report, const UnitSystem units) {
  std::string text = fmt::format(
      "{}\ndriver angle {:.6g} deg\n\n{:<36}{:>14}   {}\n", report.mechanism,
      report.load.driver_angle * output_unit(units, Dimension::angle).factor, "estimate", "", "by");
  for (const EstimateRow& row : report.rows) {
    const OutputUnit unit = output_unit(units, row.dimension);
    text += fmt::format(
        "{:<36}{:>14.5g}   {}\n",
        unit.name.empty() ? row.quantity : fmt::format("{} [{}]", row.quantity, unit.name),
        row.value * unit.factor, row.basis);
  }
  text += limit_lines(report.limits, units);
  for (const std::string& sentence : report.left_out) text += "left out: " + sentence + "\n";
  return text;
}

}  // namespace geneva::post
