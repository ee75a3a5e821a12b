#include "post/comparison.h"

#include <fmt/format.h>

#include <cmath>

#include "post/safety.h"

namespace geneva::post {

namespace {

ComparisonRow row_of(const std::string& name, const Dimension dimension, const double value,
                     const std::optional<double>& closed_form) {
  return {name, dimension, value, closed_form, std::nullopt};
}

std::vector<ComparisonRow> contact_rows(const fem::Solution<2>& /*unused*/,
                                        const fem::ContactResult<2>& contact,
                                        const ContactAnalysis<2>& analysis) {
  const auto& form = analysis.hertz;
  const auto closed = [&](const double value) {
    return form ? std::optional(value) : std::nullopt;
  };
  const bool is_point = form && form->point;
  return {row_of("peak contact pressure", Dimension::stress, contact.peak_pressure,
                 closed(form ? form->peak_pressure() : 0.)),
          row_of(is_point ? "contact radius" : "half-width", Dimension::length, contact.half_width,
                 closed(form ? form->half_width() : 0.)),
          row_of("greatest shear", Dimension::stress, analysis.max_shear.value,
                 closed(form ? form->max_shear() : 0.)),
          row_of("its depth", Dimension::length, analysis.max_shear_depth,
                 closed(form ? form->max_shear_depth() : 0.))};
}

std::vector<ComparisonRow> contact_rows(const fem::Solution<3>& solution,
                                        const fem::ContactResult<3>& contact,
                                        const ContactAnalysis<3>& analysis) {
  const auto& form = analysis.hertz;
  std::optional<double> peak;
  std::optional<double> width;
  std::optional<double> shear;
  std::optional<double> depth;
  std::optional<double> even;
  if (form) {
    peak = form->peak_pressure();
    width = form->half_width();
    shear = form->max_shear();
    depth = form->max_shear_depth();
  }
  if (form && form->line) even = form->force / form->length;
  const bool is_bounded = !solution.edge || solution.edge->is_bounded;
  std::vector<ComparisonRow> rows;
  if (!analysis.sections.empty())
    rows.push_back(
        row_of("pressure in the middle", Dimension::stress,
               (1. + solution.correction) *
                   middle_section(contact, analysis.frame, analysis.sections).peak_pressure,
               peak));
  rows.push_back(row_of(is_bounded ? "peak contact pressure" : "edge pressure, not bounded",
                        Dimension::stress, contact.peak_pressure, peak));
  rows.push_back(row_of("half-width", Dimension::length, analysis.half_width, width));
  if (form && form->ellipse)
    rows.push_back(
        row_of("half-length", Dimension::length, analysis.half_length, form->half_length()));
  rows.push_back(row_of("greatest shear", Dimension::stress, analysis.max_shear, shear));
  rows.push_back(row_of("its depth", Dimension::length, analysis.max_shear_depth, depth));
  if (even && !analysis.sections.empty()) {
    const LineLoad load = line_load(contact, analysis.frame, analysis.sections);
    rows.push_back(row_of("line load, middle", Dimension::force_per_length, load.middle, even));
    rows.push_back(row_of("line load, greater end", Dimension::force_per_length, load.end, even));
  }
  return rows;
}

/// Johnson's Eq. 2 for a pin that carries evenly, and by what factor bending, tilt and edges exceed
/// it; where an edge pressure is not bounded there is no such factor.
template <int dim>
std::vector<ComparisonRow> even_load_rows([[maybe_unused]] const fem::Solution<dim>& solution,
                                          [[maybe_unused]] const fem::ContactResult<dim>& contact,
                                          [[maybe_unused]] const ContactAnalysis<dim>& analysis) {
  if constexpr (dim == 3) {
    if (!analysis.hertz) return {};
    const double even = analysis.hertz->even.peak_pressure;
    std::vector<ComparisonRow> rows{
        {"Johnson's Eq. 2, even load", Dimension::stress, std::nullopt, even, std::nullopt}};
    if (!solution.edge || solution.edge->is_bounded)
      rows.push_back(row_of("peak over Johnson's Eq. 2", Dimension::dimensionless,
                            contact.peak_pressure / even, std::nullopt));
    return rows;
  }
  return {};
}

std::vector<ComparisonRow> pin_rows(const PinReport& pin) {
  if (!pin.beam) return {};
  return {row_of("pin deflection", Dimension::length, pin.bending.tip_deflection,
                 pin.beam->tip_deflection),
          row_of("pin slope in the slot", Dimension::slope, pin.bending.slope,
                 pin.beam->slope > 0. ? std::optional(pin.beam->slope) : std::nullopt),
          row_of("bending stress at the root", Dimension::stress, pin.bending.root_stress,
                 pin.beam->root_stress)};
}

std::string cell(const std::optional<double>& value, const double factor) {
  return value ? fmt::format("{:.5g}", *value * factor) : std::string("-");
}

std::string difference(const ComparisonRow& row) {
  if (!row.computed || !row.closed_form || *row.closed_form == 0.) return "-";
  const double percent = 100. * (*row.computed / *row.closed_form - 1.);
  return std::abs(percent) < 0.005 ? "0.00 %" : fmt::format("{:+.2f} %", percent);
}

std::string line_of(const ComparisonRow& row, const UnitSystem units) {
  const OutputUnit unit = output_unit(units, row.dimension);
  const std::string name =
      unit.name.empty() ? row.quantity : fmt::format("{} [{}]", row.quantity, unit.name);
  return fmt::format("{:<32}{:>14}{:>14}{:>14}{:>14}\n", name, cell(row.computed, unit.factor),
                     cell(row.closed_form, unit.factor), cell(row.published, unit.factor),
                     difference(row));
}

/// The line on the error estimate, and what is said of the edges.
template <int dim>
std::string error_lines(const fem::Solution<dim>& solution) {
  const bool is_edge = solution.outcome == fem::Outcome::unbounded_edge;
  const char* of = is_edge ? "pressure in the middle" : "peak contact pressure";
  if (solution.error_estimate >= 1.)
    return fmt::format("estimated error of the {}: unknown, the mesh is too coarse\n", of);
  return fmt::format("estimated error of the {}: {:.2g} %\n", of, 100. * solution.error_estimate) +
         (is_edge ? solution.message + "\n" : std::string());
}

}  // namespace

template <int dim>
std::vector<ComparisonRow> comparison(const fem::Solution<dim>& solution,
                                      const Results<dim>& results, const RunReport& report) {
  const std::size_t leading = leading_contact(solution);
  const fem::ContactResult<dim>& contact = solution.contacts[leading];
  const ContactAnalysis<dim>& analysis = results.contacts[leading];
  const auto& mechanism = report.mechanism;
  const double parts = mechanism ? mechanism->parts : 1.;
  std::vector<ComparisonRow> rows{
      row_of("contact force", Dimension::force, parts * fem::magnitude(contact.force),
             mechanism ? std::optional(mechanism->load.force) : std::nullopt)};
  const auto append = [&](const std::vector<ComparisonRow>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
  append(contact_rows(solution, contact, analysis));
  for (ComparisonRow& row : rows)
    if (row.quantity == "peak contact pressure") row.published = report.published_peak_pressure;
  if (mechanism) append(even_load_rows(solution, contact, analysis));
  if (mechanism && mechanism->pin) append(pin_rows(*mechanism->pin));
  if (mechanism && mechanism->bore_torque)
    rows.push_back(row_of(mechanism->held_surface + " torque", Dimension::moment,
                          *mechanism->bore_torque, mechanism->expected_bore_torque));
  return rows;
}

template <int dim>
std::string comparison_table(const fem::Solution<dim>& solution, const Results<dim>& results,
                             const RunReport& report, const UnitSystem units) {
  std::string table = fmt::format("{:<32}{:>14}{:>14}{:>14}{:>14}\n", "", "this program",
                                  "closed form", "published", "difference");
  for (const ComparisonRow& row : comparison(solution, results, report))
    table += line_of(row, units);
  return table + error_lines(solution) +
         fmt::format("force balance: defect {:.1e} of the contact force\n",
                     results.equilibrium.force_defect) +
         safety_lines(safety(solution, results, report), units);
}

template std::vector<ComparisonRow> comparison(const fem::Solution<2>&, const Results<2>&,
                                               const RunReport&);
template std::vector<ComparisonRow> comparison(const fem::Solution<3>&, const Results<3>&,
                                               const RunReport&);
template std::string comparison_table(const fem::Solution<2>&, const Results<2>&, const RunReport&,
                                      UnitSystem);
template std::string comparison_table(const fem::Solution<3>&, const Results<3>&, const RunReport&,
                                      UnitSystem);

}  // namespace geneva::post
