#include "api/estimate.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/mechanism_picture.h"
#include "api/output_directory.h"
#include "api/version.h"
#include "model/mechanism_state.h"
#include "model/naming.h"
#include "model/pin_in_space.h"

namespace geneva {

namespace {

using base::Dimension;
using Rows = std::vector<post::EstimateRow>;

constexpr const char* by_hertz = "Hertz";
constexpr const char* by_lines = "half-space and beam";

/// Line load in the middle of the wheel's thickness; 0 if no section there carries any.
double middle_load(const loads::PinLineContact& line) {
  const auto middle = std::find_if(line.sections.begin(), line.sections.end(),
                                   [](const auto& s) { return std::abs(s.place) <= s.width / 2.; });
  return middle == line.sections.end() ? 0. : middle->line_load;
}

void append_hertz(Rows& rows, const loads::HertzLine& hertz, const std::string& basis) {
  rows.push_back({"peak contact pressure", Dimension::stress, hertz.peak_pressure, basis});
  rows.push_back({"half-width", Dimension::length, hertz.half_width, basis});
  rows.push_back({"maximum shear", Dimension::stress, hertz.max_shear, basis});
  rows.push_back({"its depth", Dimension::length, hertz.max_shear_depth, basis});
}

/// The contact of a pin that bends.
void append_line(Rows& rows, const post::EstimateReport& report,
                 const loads::PinClearance& clearance) {
  const loads::PinLineContact& line = *report.line;
  const auto section = [&](const double line_load) {
    return loads::hertz_line(line_load, report.relative_radius, report.contact_modulus);
  };
  if (loads::ends_inside(line, clearance)) {
    append_hertz(rows, section(line.peak_line_load), by_lines);
    rows.push_back(
        {"place of the peak along the pin", Dimension::length, line.peak_place, by_lines});
    rows.push_back({"length of the contact", Dimension::length, line.end - line.begin, by_lines});
    rows.push_back({"peak over Johnson's Eq. 2", Dimension::dimensionless,
                    line.peak_pressure / report.even.peak_pressure, by_lines});
  } else {
    const double load = middle_load(line);
    rows.push_back({"pressure in the middle", Dimension::stress,
                    load > 0. ? section(load).peak_pressure : 0., by_lines});
    rows.push_back({"line load, middle", Dimension::force_per_length, load, by_lines});
  }
  rows.push_back({"bending stress at the root", Dimension::stress, line.root_stress, by_lines});
}

std::vector<std::string> left_out(const post::EstimateReport& report,
                                  const model::MechanismCase& mechanism, const bool is_inside) {
  std::vector<std::string> sentences{
      "the size of wheel and pin, and all stresses away from the contact ('geneva run' has them)"};
  if (!mechanism.space) return sentences;
  if (!report.line) {
    sentences.emplace_back(
        "bending, profile and edges: no model without finite elements for a pin "
        "that is held at its core, or with a negative Poisson's ratio");
    return sentences;
  }
  sentences.emplace_back("the wheel's twist under a load beside its middle");
  if (!is_inside)
    sentences.emplace_back(
        "the pressure at the ends: the contact reaches the wall's edge, where "
        "line contacts have no peak");
  return sentences;
}

post::EstimateReport estimate_report(const Case& given) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no Geneva mechanism", "geneva estimate", "mechanism");
  const model::MechanismCase& mechanism = *given.mechanism;
  const model::MechanismState state = model::mechanism_state(mechanism);
  const loads::PinContact contact = api::pin_contact(mechanism, state.sizes);
  post::EstimateReport report{};
  report.about = model::header_of(given);
  report.geneva_version = version;
  report.mechanism = state.driven.mechanism().name;
  report.load = state.load;
  report.relative_radius = state.sizes.pin_diameter / 2.;
  report.contact_modulus = contact.contact_modulus;
  report.even_line_load = state.load.force / state.sizes.thickness;
  report.even =
      loads::hertz_line(report.even_line_load, report.relative_radius, report.contact_modulus);
  report.rows = {{"pin force", Dimension::force, state.load.force, "F = (J a + M)/r"}};
  bool is_inside = true;
  if (mechanism.space) report.line = model::pin_line_contact(mechanism, state);
  if (report.line) {
    const loads::PinClearance clearance = model::pin_clearance(mechanism, state);
    is_inside = loads::ends_inside(*report.line, clearance);
    report.rows.push_back(
        {"Johnson's Eq. 2, even load", Dimension::stress, report.even.peak_pressure, by_hertz});
    append_line(report.rows, report, clearance);
  } else {
    append_hertz(report.rows, report.even, by_hertz);
  }
  report.left_out = left_out(report, mechanism, is_inside);
  return report;
}

}  // namespace

Estimate estimate(const Case& given) {
  return model::naming(given, [&] {
    post::EstimateReport report = estimate_report(given);
    return Estimate{given, std::move(report), model::notices_of(*given.mechanism, given.units)};
  });
}

std::string table(const Estimate& estimate) {
  return post::estimate_table(estimate.report, estimate.given.units);
}

Written write(const Estimate& estimate, const std::filesystem::path& directory) {
  const auto& [given, report, notices] = estimate;
  return api::write_results(directory, given, "estimate",
                            {{"estimate.json", post::estimate_summary(report).dump(2) + "\n"},
                             {"estimate.csv", post::estimate_csv(report, given.units)},
                             {"mechanism.json", api::mechanism_text(*given.mechanism)}});
}

}  // namespace geneva
