#include "post/comparison_table.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace geneva::post {

namespace {

/// One line of the closing table; missing values are shown as a dash.
struct TableRow {
  std::string name;
  std::optional<double> computed;
  std::optional<double> closed_form;
  std::optional<double> published;
};

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.5g}", *value) : std::string("-");
}

std::string difference(const TableRow& row) {
  if (!row.computed || !row.closed_form || *row.closed_form == 0.) return "-";
  const double percent = 100. * (*row.computed / *row.closed_form - 1.);
  return std::abs(percent) < 0.005 ? "0.00 %" : fmt::format("{:+.2f} %", percent);
}

std::optional<double> in_unit(const std::optional<double>& value, const OutputUnit& unit) {
  return value ? std::optional(*value * unit.factor) : std::nullopt;
}

/// Value and closed form in output units, with the unit in the row's name.
TableRow row_of(const std::string& name, const double value,
                const std::optional<double>& closed_form, const OutputUnit& unit) {
  return {fmt::format("{} [{}]", name, unit.name), value * unit.factor, in_unit(closed_form, unit),
          std::nullopt};
}

std::vector<TableRow> contact_rows(const fem::Solution<2>& /*unused*/,
                                   const fem::ContactResult<2>& contact,
                                   const ContactAnalysis<2>& analysis, const UnitSystem units) {
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit length = output_unit(units, Dimension::length);
  const auto& form = analysis.hertz;
  const auto closed = [&](const double value) {
    return form ? std::optional(value) : std::nullopt;
  };
  const bool is_point = form && form->point;
  return {row_of("peak contact pressure", contact.peak_pressure,
                 closed(form ? form->peak_pressure() : 0.), stress),
          row_of(is_point ? "contact radius" : "half-width", contact.half_width,
                 closed(form ? form->half_width() : 0.), length),
          row_of("greatest shear", analysis.max_shear.value, closed(form ? form->max_shear() : 0.),
                 stress),
          row_of("its depth", analysis.max_shear_depth, closed(form ? form->max_shear_depth() : 0.),
                 length)};
}

std::vector<TableRow> contact_rows(const fem::Solution<3>& solution,
                                   const fem::ContactResult<3>& contact,
                                   const ContactAnalysis<3>& analysis, const UnitSystem units) {
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit per_length = output_unit(units, Dimension::force_per_length);
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
  std::vector<TableRow> rows;
  if (!analysis.sections.empty())
    rows.push_back(row_of("pressure in the middle",
                          middle_section(contact, analysis.frame, analysis.sections).peak_pressure,
                          peak, stress));
  rows.push_back(row_of(is_bounded ? "peak contact pressure" : "edge pressure, not bounded",
                        contact.peak_pressure, peak, stress));
  rows.push_back(row_of("half-width", analysis.half_width, width, length));
  if (form && form->ellipse)
    rows.push_back(row_of("half-length", analysis.half_length, form->half_length(), length));
  rows.push_back(row_of("greatest shear", analysis.max_shear, shear, stress));
  rows.push_back(row_of("its depth", analysis.max_shear_depth, depth, length));
  if (even && !analysis.sections.empty()) {
    const LineLoad load = line_load(contact, analysis.frame, analysis.sections);
    rows.push_back(row_of("line load, middle", load.middle, even, per_length));
    rows.push_back(row_of("line load, greater end", load.end, even, per_length));
  }
  return rows;
}

/// Johnson's Eq. 2 for a pin that carries evenly, and by what factor bending, tilt and edges exceed
/// it; where an edge pressure is not bounded there is no such factor.
template <int dim>
std::vector<TableRow> even_load_rows([[maybe_unused]] const fem::Solution<dim>& solution,
                                     [[maybe_unused]] const fem::ContactResult<dim>& contact,
                                     [[maybe_unused]] const ContactAnalysis<dim>& analysis,
                                     [[maybe_unused]] const UnitSystem units) {
  if constexpr (dim == 3) {
    if (!analysis.hertz) return {};
    const OutputUnit stress = output_unit(units, Dimension::stress);
    const double even = analysis.hertz->even.peak_pressure;
    std::vector<TableRow> rows{{fmt::format("Johnson's Eq. 2, even load [{}]", stress.name),
                                std::nullopt, even * stress.factor, std::nullopt}};
    if (!solution.edge || solution.edge->is_bounded)
      rows.push_back(
          {"peak over Johnson's Eq. 2", contact.peak_pressure / even, std::nullopt, std::nullopt});
    return rows;
  }
  return {};
}

std::vector<TableRow> pin_rows(const PinReport& pin, const UnitSystem units) {
  if (!pin.beam) return {};
  const OutputUnit slope{"mrad", 1e3};
  return {row_of("pin deflection", pin.bending.tip_deflection, pin.beam->tip_deflection,
                 output_unit(units, Dimension::length)),
          row_of("pin slope in the slot", pin.bending.slope,
                 pin.beam->slope > 0. ? std::optional(pin.beam->slope) : std::nullopt, slope),
          row_of("bending stress at the root", pin.bending.root_stress, pin.beam->root_stress,
                 output_unit(units, Dimension::stress))};
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
std::string comparison_table(const fem::Solution<dim>& solution, const Results<dim>& results,
                             const RunReport& report, const UnitSystem units) {
  const std::size_t leading = leading_contact(solution);
  const fem::ContactResult<dim>& contact = solution.contacts[leading];
  const auto& mechanism = report.mechanism;
  const double parts = mechanism ? mechanism->parts : 1.;
  std::vector<TableRow> rows{row_of("contact force", parts * fem::magnitude(contact.force),
                                    mechanism ? std::optional(mechanism->load.force) : std::nullopt,
                                    output_unit(units, Dimension::force))};
  for (TableRow row : contact_rows(solution, contact, results.contacts[leading], units)) {
    if (row.name.rfind("peak contact pressure", 0) == 0)
      row.published =
          in_unit(report.published_peak_pressure, output_unit(units, Dimension::stress));
    rows.push_back(row);
  }
  if (mechanism)
    for (const TableRow& row : even_load_rows(solution, contact, results.contacts[leading], units))
      rows.push_back(row);
  if (mechanism && mechanism->pin)
    for (const TableRow& row : pin_rows(*mechanism->pin, units)) rows.push_back(row);
  if (mechanism && mechanism->bore_torque)
    rows.push_back(row_of(mechanism->held_surface + " torque", *mechanism->bore_torque,
                          mechanism->expected_bore_torque, output_unit(units, Dimension::moment)));

  std::string table = fmt::format("{:<32}{:>14}{:>14}{:>14}{:>14}\n", "", "this program",
                                  "closed form", "published", "difference");
  for (const TableRow& row : rows)
    table += fmt::format("{:<32}{:>14}{:>14}{:>14}{:>14}\n", row.name, cell(row.computed),
                         cell(row.closed_form), cell(row.published), difference(row));
  return table + error_lines(solution) +
         fmt::format("force balance: defect {:.1e} of the contact force\n",
                     results.equilibrium.force_defect);
}

template std::string comparison_table(const fem::Solution<2>&, const Results<2>&, const RunReport&,
                                      UnitSystem);
template std::string comparison_table(const fem::Solution<3>&, const Results<3>&, const RunReport&,
                                      UnitSystem);

}  // namespace geneva::post
