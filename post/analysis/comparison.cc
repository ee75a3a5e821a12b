#include "post/analysis/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/analysis/friction.h"
#include "post/analysis/partial_slip_form.h"
#include "post/analysis/roller_rows.h"
#include "post/analysis/safety.h"
#include "post/analysis/strength_rows.h"

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;

namespace {

ComparisonRow row_of(const std::string& name, const Dimension dimension, const double value,
                     const std::optional<double>& closed_form, const std::optional<double>& error) {
  return {name, dimension, value, error, true, closed_form, std::nullopt};
}

/// Of a figure that grows from mesh to mesh without bound.
ComparisonRow unbounded_row(const std::string& name, const Dimension dimension,
                            const std::optional<double>& closed_form) {
  return {name, dimension, std::nullopt, std::nullopt, false, closed_form, std::nullopt};
}

std::vector<ComparisonRow> contact_rows(const fem::Solution<2>& solution,
                                        const fem::ContactResult<2>& contact,
                                        const ContactAnalysis<2>& analysis, const Figures& errors,
                                        const std::optional<PinLineReport>& /*line*/) {
  const auto& form = analysis.hertz;
  const auto closed = [&](const double value) {
    return form ? std::optional(value) : std::nullopt;
  };
  const bool is_point = form && form->point;
  const auto peak = closed(form ? form->peak_pressure() : 0.);
  const auto shear = closed(form ? form->max_shear() : 0.);
  const auto depth = closed(form ? form->max_shear_depth() : 0.);
  const ComparisonRow width =
      row_of(is_point ? "contact radius" : "half-width", Dimension::length, contact.half_width,
             closed(form ? form->half_width() : 0.), value_of(errors, Figure::half_width));
  if (!is_bounded(solution))
    return {unbounded_row("peak contact pressure", Dimension::stress, peak), width,
            unbounded_row("maximum shear", Dimension::stress, shear)};
  return {row_of("peak contact pressure", Dimension::stress, contact.peak_pressure, peak,
                 solution.error_estimate),
          width,
          row_of("maximum shear", Dimension::stress, analysis.max_shear.value, shear,
                 value_of(errors, Figure::max_shear)),
          row_of("its depth", Dimension::length, analysis.max_shear_depth, depth,
                 value_of(errors, Figure::max_shear_depth))};
}

/// What a closed form in 3-D says of the figures; unknown without one.
struct ClosedFigures {
  std::optional<double> peak, middle, width, length, shear, depth, line_load, end_load;
};

ClosedFigures closed_figures(const std::optional<ClosedFormInSpace>& form) {
  if (!form) return {};
  const auto line_load = form->line ? std::optional(form->force / form->length) : std::nullopt;
  return {form->peak_pressure(), form->peak_pressure(),   form->half_width(), form->half_length(),
          form->max_shear(),     form->max_shear_depth(), line_load,          line_load};
}

/// Of line contacts along the pin; width and shear are those of the middle, or of the peak if it is
/// bounded.
ClosedFigures closed_figures(const PinLineReport& line, const bool is_bounded) {
  const loads::PinLineContact& contact = line.contact;
  const auto section = [&](const double line_load) {
    return loads::hertz_line(line_load, line.pin.relative_radius,
                             loads::contact_modulus(line.pin.pin, line.pin.wheel));
  };
  ClosedFigures closed;
  const double middle = loads::line_load_at(contact, 0.);
  closed.length = (contact.end - contact.begin) / 2.;
  closed.line_load = middle;
  if (middle > 0.) {
    const loads::HertzLine hertz = section(middle);
    closed.middle = hertz.peak_pressure;
    closed.width = hertz.half_width;
    if (!is_bounded) {
      closed.shear = hertz.max_shear;
      closed.depth = hertz.max_shear_depth;
    }
  }
  if (line.doubt != loads::PeakDoubt::none) return closed;
  const loads::HertzLine peak = loads::peak_contact(line.pin, contact);
  closed.peak = peak.peak_pressure;
  closed.end_load = std::max(contact.sections.front().line_load, contact.sections.back().line_load);
  if (is_bounded) {
    closed.shear = peak.max_shear;
    closed.depth = peak.max_shear_depth;
  }
  return closed;
}

/// Hertz's, where it is one; of a pin that bends, is tilted or reaches an edge it would be an even
/// load.
ClosedFigures closed_figures(const fem::Solution<3>& solution, const ContactAnalysis<3>& analysis,
                             const std::optional<PinLineReport>& line) {
  const bool is_hertz = analysis.hertz && analysis.hertz->ellipse;
  return line && analysis.hertz && !is_hertz ? closed_figures(*line, is_bounded(solution))
                                             : closed_figures(analysis.hertz);
}

/// Where an edge pressure is not bounded, the stress below the edge is not either: the shear is
/// then that below the middle.
std::vector<ComparisonRow> shear_rows(const fem::Solution<3>& solution,
                                      const fem::ContactResult<3>& contact,
                                      const ContactAnalysis<3>& analysis, const Figures& errors,
                                      const ClosedFigures& closed) {
  if (is_bounded(solution))
    return {row_of("maximum shear", Dimension::stress, analysis.max_shear, closed.shear,
                   value_of(errors, Figure::max_shear)),
            row_of("its depth", Dimension::length, analysis.max_shear_depth, closed.depth,
                   value_of(errors, Figure::max_shear_depth))};
  if (analysis.sections.empty())
    return {unbounded_row("maximum shear", Dimension::stress, closed.shear)};
  const ContactSection middle = middle_section(contact, analysis.frame, analysis.sections);
  return {row_of("maximum shear, middle", Dimension::stress, middle.max_shear, closed.shear,
                 value_of(errors, Figure::mid_length_shear)),
          row_of("its depth", Dimension::length, middle.max_shear_depth, closed.depth,
                 value_of(errors, Figure::mid_length_shear_depth))};
}

std::vector<ComparisonRow> contact_rows(const fem::Solution<3>& solution,
                                        const fem::ContactResult<3>& contact,
                                        const ContactAnalysis<3>& analysis, const Figures& errors,
                                        const std::optional<PinLineReport>& line) {
  ClosedFigures closed = closed_figures(solution, analysis, line);
  if (friction_figures(solution, contact, std::nullopt))  // which moves it to the surface
    closed.shear = closed.depth = std::nullopt;
  const bool is_finite = is_bounded(solution);
  std::vector<ComparisonRow> rows;
  if (!analysis.sections.empty())
    rows.push_back(
        row_of("pressure in the middle", Dimension::stress,
               (1. + solution.correction) *
                   middle_section(contact, analysis.frame, analysis.sections).peak_pressure,
               closed.middle, value_of(errors, Figure::mid_length_pressure)));
  rows.push_back(is_finite ? row_of("peak contact pressure", Dimension::stress,
                                    contact.peak_pressure, closed.peak, solution.error_estimate)
                           : unbounded_row("edge pressure", Dimension::stress, closed.peak));
  rows.push_back(row_of("half-width", Dimension::length, analysis.half_width, closed.width,
                        value_of(errors, Figure::half_width)));
  if (analysis.hertz && analysis.hertz->ellipse)
    rows.push_back(row_of("half-length", Dimension::length, analysis.half_length, closed.length,
                          value_of(errors, Figure::half_length)));
  for (const ComparisonRow& row : shear_rows(solution, contact, analysis, errors, closed))
    rows.push_back(row);
  if (closed.line_load && !analysis.sections.empty()) {
    const LineLoad load = line_load(contact, analysis.frame, analysis.sections);
    rows.push_back(row_of("line load, middle", Dimension::force_per_length, load.middle,
                          closed.line_load, value_of(errors, Figure::line_load_middle)));
    rows.push_back(is_finite
                       ? row_of("line load, greater end", Dimension::force_per_length, load.end,
                                closed.end_load, value_of(errors, Figure::line_load_end))
                       : unbounded_row("line load, greater end", Dimension::force_per_length,
                                       closed.end_load));
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
    std::vector<ComparisonRow> rows{{"Johnson's Eq. 2, even load", Dimension::stress, std::nullopt,
                                     std::nullopt, true, even, std::nullopt}};
    if (is_bounded(solution))
      rows.push_back(row_of("peak over Johnson's Eq. 2", Dimension::dimensionless,
                            contact.peak_pressure / even, std::nullopt, solution.error_estimate));
    return rows;
  }
  return {};
}

/// Finite elements beside line contacts that half-spaces and a beam couple.
template <int dim>
std::vector<ComparisonRow> line_rows(const fem::Solution<dim>& solution,
                                     const fem::ContactResult<dim>& contact,
                                     const std::optional<PinLineReport>& line) {
  if (!line || line->doubt != loads::PeakDoubt::none || !is_bounded(solution)) return {};
  return {row_of("peak, half-space and beam", Dimension::stress, contact.peak_pressure,
                 line->contact.peak_pressure, solution.error_estimate)};
}

/// Of a pin of which only its section is modelled, or of a roller's stud.
std::vector<ComparisonRow> root_rows(const loads::BeamBending& beam, const std::string& part) {
  const auto row = [](const std::string& quantity, const double value) {
    return ComparisonRow{quantity, Dimension::stress, std::nullopt, std::nullopt, true,
                         value,    std::nullopt};
  };
  return {row("bending stress, " + part + " root", beam.root_stress),
          row("shear stress, " + part + " root", beam.root_shear)};
}

std::vector<ComparisonRow> pin_rows(const MechanismReport& mechanism, const Figures& errors) {
  if (!mechanism.beam) return {};
  const loads::BeamBending& beam = *mechanism.beam;
  if (mechanism.roller) return root_rows(beam, "stud");  // a solid pin's in 3-D, if anything
  if (!mechanism.pin) return root_rows(beam, "pin");
  const PinReport& pin = *mechanism.pin;
  const double deflection = pin.line ? pin.line->contact.deflection : beam.tip_deflection;
  const double slope = pin.line ? pin.line->contact.slope : beam.slope;
  const double root_stress = pin.line ? pin.line->contact.root_stress : beam.root_stress;
  const bool is_beam = !pin.line || loads::is_beam(pin.line->pin);
  const bool has_slope = beam.slope > 0.;  // none by symmetry if it is held twice
  return {row_of("pin deflection", Dimension::length, pin.bending.tip_deflection, deflection,
                 value_of(errors, Figure::tip_deflection)),
          row_of("pin slope in the slot", Dimension::slope, pin.bending.slope,
                 has_slope ? std::optional(slope) : std::nullopt, value_of(errors, Figure::slope)),
          row_of("bending stress at the root", Dimension::stress, pin.bending.root_stress,
                 is_beam ? std::optional(root_stress) : std::nullopt,
                 value_of(errors, Figure::root_stress))};
}

void append(std::vector<ComparisonRow>& rows, const std::vector<ComparisonRow>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

std::string cell(const std::optional<double>& value, const double factor) {
  return value ? fmt::format("{:.5g}", *value * factor) : std::string("-");
}

std::string difference(const ComparisonRow& row) {
  if (!row.computed || !row.closed_form || *row.closed_form == 0.) return "-";
  const double percent = 100. * (*row.computed / *row.closed_form - 1.);
  return std::abs(percent) < 0.005 ? "0.00 %" : fmt::format("{:+.2f} %", percent);
}

/// Below a hundredth of a per cent only the solver's tolerance is left.
std::string error_cell(const ComparisonRow& row) {
  if (!row.error) return "";
  if (!(*row.error < 1.)) return "+- ?";
  const double percent = 100. * *row.error;
  return percent < 0.005 ? "+- 0.00 %" : fmt::format("+- {:.2g} %", percent);
}

std::string line_of(const ComparisonRow& row, const UnitSystem units) {
  const OutputUnit unit = output_unit(units, row.dimension);
  const std::string name =
      unit.name.empty() ? row.quantity : fmt::format("{} [{}]", row.quantity, unit.name);
  return fmt::format("{:<32}{:>14} {:<11}{:>14}{:>14}{:>14}\n", name,
                     row.is_bounded ? cell(row.computed, unit.factor) : "not bounded",
                     error_cell(row), cell(row.closed_form, unit.factor),
                     cell(row.published, unit.factor), difference(row));
}

/// What the balance of forces is relative to.
template <int dim>
const char* force_reference(const fem::Solution<dim>& solution) {
  return fem::has_contact(solution.problem) ? "contact force"
                                            : "maximum stress on the square of the model's extent";
}

/// The line on the error estimate, and what is said of the edges.
template <int dim>
std::string error_lines(const fem::Solution<dim>& solution, const RunReport& report) {
  const bool is_edge = solution.stop.outcome == fem::Outcome::unbounded_edge;
  const std::string of = refined_figure(solution);
  if (solution.error_estimate >= 1.)
    return fmt::format("estimated error of the {}: unknown, the mesh is too coarse\n", of);
  return fmt::format("estimated error of the {}: {:.2g} %\n", of, 100. * solution.error_estimate) +
         (is_edge ? report.stop_message + "\n" : std::string());
}

/// Tension of the surface at the end of the contact from which friction pulls: 2 mu p0 where like
/// bodies slide (Smith and Liu 1953).
template <int dim>
std::vector<ComparisonRow> surface_rows([[maybe_unused]] const ContactAnalysis<dim>& analysis,
                                        [[maybe_unused]] const Figures& errors) {
  if constexpr (dim == 2) {
    if (!analysis.surface) return {};
    const auto& form = analysis.hertz;
    const bool slides = form && form->line && form->friction != 0.;
    const std::optional<double> closed =
        slides ? std::optional(2. * std::abs(form->friction) * form->peak_pressure())
               : std::nullopt;
    return {row_of("surface tension", Dimension::stress, analysis.surface->tension, closed,
                   value_of(errors, Figure::surface_tension))};
  }
  return {};
}

/// Of the contact with the maximum pressure, and of the pin.
template <int dim>
std::vector<ComparisonRow> rows_of_contact(const fem::Solution<dim>& solution,
                                           const Results<dim>& results, const RunReport& report) {
  const std::size_t leading = leading_contact(solution);
  const fem::ContactResult<dim>& contact = solution.contacts[leading];
  const ContactAnalysis<dim>& analysis = results.contacts[leading];
  const auto& mechanism = report.mechanism;
  const double parts = mechanism ? mechanism->parts : 1.;
  const Figures& errors = report.errors.contacts[leading];
  std::vector<ComparisonRow> rows{
      row_of("contact force", Dimension::force, parts * fem::magnitude(contact.force),
             mechanism ? std::optional(mechanism->load.force) : std::nullopt,
             value_of(errors, Figure::force))};
  if (const auto friction = friction_figures(solution, contact, mechanism))
    rows.push_back(row_of(
        "friction force", Dimension::force, parts * friction->force,
        mechanism ? std::optional(friction->coefficient * mechanism->load.force) : std::nullopt,
        value_of(errors, Figure::force)));
  append(rows, surface_rows(analysis, errors));
  const auto mindlin = partial_slip(solution, leading, analysis);
  if (const auto friction = friction_figures(solution, contact, mechanism);
      friction && friction->sticking_share)
    rows.push_back(row_of(
        "sticking share of the contact", Dimension::dimensionless, *friction->sticking_share,
        mindlin ? std::optional(mindlin->slip.sticking_share()) : std::nullopt, std::nullopt));
  const bool has_pin = mechanism && mechanism->pin;
  const std::optional<PinLineReport> line = has_pin ? mechanism->pin->line : std::nullopt;
  append(rows, contact_rows(solution, contact, analysis, errors, line));
  for (ComparisonRow& row : rows)
    if (row.quantity == "peak contact pressure") row.published = report.published_peak_pressure;
  if (mechanism) append(rows, even_load_rows(solution, contact, analysis));
  if (has_pin) append(rows, line_rows(solution, contact, line));
  append(rows, roller_rows(solution, results, report));
  if (mechanism) append(rows, pin_rows(*mechanism, report.errors.mechanism));
  return rows;
}

}  // namespace

template <int dim>
std::vector<ComparisonRow> comparison(const fem::Solution<dim>& solution,
                                      const Results<dim>& results, const RunReport& report) {
  std::vector<ComparisonRow> rows;
  if (fem::has_contact(solution.problem)) rows = rows_of_contact(solution, results, report);
  const auto& mechanism = report.mechanism;
  if (mechanism && mechanism->bore_torque)
    rows.push_back(row_of(mechanism->held_surface + " torque", Dimension::moment,
                          *mechanism->bore_torque, mechanism->expected_bore_torque,
                          value_of(report.errors.mechanism, Figure::bore_torque)));
  append(rows, strength_rows(solution));
  return rows;
}

template <int dim>
std::string refined_figure(const fem::Solution<dim>& solution) {
  if (!fem::has_contact(solution.problem)) return "maximum stress";
  return solution.edge && !solution.edge->is_bounded ? "pressure in the middle"
                                                     : "peak contact pressure";
}

template <int dim>
std::string comparison_table(const fem::Solution<dim>& solution, const Results<dim>& results,
                             const RunReport& report, const UnitSystem units) {
  std::string table = fmt::format("{:<32}{:>14} {:<11}{:>14}{:>14}{:>14}\n", "", "this program",
                                  "+- error", "closed form", "published", "difference");
  for (const ComparisonRow& row : comparison(solution, results, report))
    table += line_of(row, units);
  return table + strength_line(solution) + error_lines(solution, report) +
         fmt::format("force balance: residual {:.1e} of the {}\n",
                     results.equilibrium.force_residual, force_reference(solution)) +
         safety_lines(safety(solution, results, report), units);
}

template std::vector<ComparisonRow> comparison(const fem::Solution<2>&, const Results<2>&,
                                               const RunReport&);
template std::vector<ComparisonRow> comparison(const fem::Solution<3>&, const Results<3>&,
                                               const RunReport&);
template std::string refined_figure(const fem::Solution<2>&);
template std::string refined_figure(const fem::Solution<3>&);
template std::string comparison_table(const fem::Solution<2>&, const Results<2>&, const RunReport&,
                                      UnitSystem);
template std::string comparison_table(const fem::Solution<3>&, const Results<3>&, const RunReport&,
                                      UnitSystem);

}  // namespace geneva::post
