#include "post/output/summary.h"

#include <deal.II/base/config.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_values.h"
#include "post/analysis/checks.h"
#include "post/analysis/comparison.h"
#include "post/analysis/friction.h"
#include "post/analysis/safety.h"
#include "post/analysis/strength_rows.h"

namespace geneva::post {

using base::case_section;
using base::Dimension;
using base::finite;
using base::quantity;
using base::versions_section;

using nlohmann::json;

namespace {

template <std::size_t dim>
json place(const std::array<double, dim>& at) {
  json result = json::object();
  const std::array<const char*, 3> axes{"x", "y", "z"};
  for (std::size_t i = 0; i < dim; ++i) result[axes[i]] = quantity(at[i], "m");
  return result;
}

json moment_section(const double moment) { return quantity(moment, "N m"); }

json moment_section(const dealii::Tensor<1, 3>& moment) {
  return {{"x", quantity(moment[0], "N m")},
          {"y", quantity(moment[1], "N m")},
          {"z", quantity(moment[2], "N m")}};
}

/// What supports and ties exert on their bodies, by surface.
template <int dim>
json reactions_section(const fem::Solution<dim>& solution) {
  const std::array<const char*, 3> axes{"x", "y", "z"};
  json surfaces = json::object();
  for (const fem::Reaction<dim>& reaction : solution.reactions) {
    json force = json::object();
    for (std::size_t i = 0; i < dim; ++i) force[axes[i]] = quantity(reaction.force[i], "N");
    surfaces[reaction.surface] = {{"force", force},
                                  {"total", quantity(fem::magnitude(reaction.force), "N")},
                                  {"moment", moment_section(reaction.moment)}};
  }
  return surfaces;
}

json hertz_section(const ClosedForm& form) {
  return {{"peak_pressure", quantity(form.peak_pressure(), "Pa")},
          {"half_width", quantity(form.half_width(), "m")},
          {"max_shear", quantity(form.max_shear(), "Pa")},
          {"max_shear_depth", quantity(form.max_shear_depth(), "m")},
          {"relative_radius", quantity(form.relative_radius, "m")},
          {"contact_modulus", quantity(form.contact_modulus, "Pa")}};
}

json hertz_section(const ClosedFormInSpace& form) {
  json section{{"peak_pressure", quantity(form.peak_pressure(), "Pa")},
               {"half_width", quantity(form.half_width(), "m")},
               {"relative_radius", quantity(form.radius_across, "m")},
               {"contact_modulus", quantity(form.contact_modulus, "Pa")}};
  if (const auto shear = form.max_shear()) {
    section["max_shear"] = quantity(*shear, "Pa");
    section["max_shear_depth"] = quantity(*form.max_shear_depth(), "m");
  }
  if (form.line) {
    section["length"] = quantity(form.length, "m");
  } else {
    section["relative_radius_along"] = quantity(form.radius_along, "m");
    section["half_length"] = quantity(form.half_length(), "m");
  }
  return section;
}

/// The figure's estimated error, null where it has none.
json error_value(const Figures& errors, const Figure figure) {
  const std::optional<double> error = value_of(errors, figure);
  return error ? finite(*error) : json();
}

/// Adds the errors of figures that grow without bound where a pressure does.
template <int dim>
void add_shear_errors(json& section, const fem::Solution<dim>& solution, const Figures& errors) {
  const bool is_finite = is_bounded(solution);
  section["max_shear_error"] = is_finite ? error_value(errors, Figure::max_shear) : json();
  section["max_shear_depth_error"] =
      is_finite ? error_value(errors, Figure::max_shear_depth) : json();
}

/// Of a pair with friction.
/// @param parts of the whole over the modelled one
json friction_section(const FrictionFigures& friction, const double parts) {
  json section{{"coefficient", friction.coefficient},
               {"force", quantity(parts * friction.force, "N")},
               {"sticking_nodes", friction.sticking},
               {"slipping_nodes", friction.slipping}};
  if (friction.sticking_share) section["sticking_share"] = *friction.sticking_share;
  if (friction.speed)
    section["power"] = quantity(parts * friction.force * *friction.speed, "W");
  else
    section["dissipated"] = quantity(parts * friction.dissipated, "J");
  return section;
}

/// Greatest stresses along the surfaces in contact.
void add_surface(json& section, const ContactAnalysis<2>& analysis, const Figures& errors) {
  if (!analysis.surface) return;
  section["surface_tension"] = quantity(analysis.surface->tension, "Pa");
  section["surface_tension_error"] = error_value(errors, Figure::surface_tension);
  section["surface_compression"] = quantity(analysis.surface->compression, "Pa");
}

template <int dim>
json common_contact_section(const fem::Solution<dim>& solution,
                            const fem::ContactResult<dim>& contact, const Figures& errors,
                            const double parts) {
  return {{"source", contact.source},
          {"target", contact.target},
          {"force", quantity(parts * fem::magnitude(contact.force), "N")},
          {"force_error", error_value(errors, Figure::force)},
          {"lateral_force", quantity(fem::magnitude(contact.lateral_force), "N")},
          {"peak_pressure", quantity(contact.peak_pressure, "Pa")},
          {"peak_pressure_error", solution.error_estimate},
          {"peak_pressure_correction", solution.correction},
          {"max_penetration", quantity(contact.max_penetration, "m")},
          {"active_nodes", contact.active_nodes}};
}

json contact_section(const fem::Solution<3>& solution, const fem::ContactResult<3>& contact,
                     const ContactAnalysis<3>& analysis, const Figures& errors,
                     const double parts) {
  json section = common_contact_section(solution, contact, errors, parts);
  section["peak_pressure_place"] = place(analysis.peak_place);
  section["half_width"] = quantity(analysis.half_width, "m");
  section["half_width_error"] = error_value(errors, Figure::half_width);
  section["half_length"] = quantity(analysis.half_length, "m");
  section["half_length_error"] = error_value(errors, Figure::half_length);
  section["max_shear"] = quantity(analysis.max_shear, "Pa");
  section["max_shear_depth"] = quantity(analysis.max_shear_depth, "m");
  add_shear_errors(section, solution, errors);
  if (!analysis.sections.empty()) {
    const ContactSection middle = middle_section(contact, analysis.frame, analysis.sections);
    section["mid_length_pressure"] =
        quantity((1. + solution.correction) * middle.peak_pressure, "Pa");
    section["mid_length_pressure_error"] = error_value(errors, Figure::mid_length_pressure);
    section["mid_length_shear"] = quantity(middle.max_shear, "Pa");
    section["mid_length_shear_error"] = error_value(errors, Figure::mid_length_shear);
    section["mid_length_shear_depth"] = quantity(middle.max_shear_depth, "m");
    section["mid_length_shear_depth_error"] = error_value(errors, Figure::mid_length_shear_depth);
  }
  if (solution.edge)
    section["edge"] = {{"bounded", solution.edge->is_bounded},
                       {"growth_exponent", solution.edge->growth_exponent},
                       {"pressure", quantity(solution.edge->pressure, "Pa")}};
  return section;
}

json line_load_section(const LineLoad& load, const Figures& errors, const bool is_finite) {
  return {{"end", quantity(load.end, "N/m")},
          {"end_error", is_finite ? error_value(errors, Figure::line_load_end) : json()},
          {"middle", quantity(load.middle, "N/m")},
          {"middle_error", error_value(errors, Figure::line_load_middle)},
          {"ratio", load.ratio()}};
}

/// The factor is null where an edge pressure is not bounded.
json johnson_section(const fem::Solution<3>& solution, const fem::ContactResult<3>& contact,
                     const loads::HertzLine& even) {
  const bool is_finite = is_bounded(solution);
  return {{"peak_pressure", quantity(even.peak_pressure, "Pa")},
          {"factor", is_finite ? json(contact.peak_pressure / even.peak_pressure) : json()}};
}

/// Without a peak where line contacts know none.
json line_section(const PinLineReport& line) {
  const loads::PinLineContact& contact = line.contact;
  json section{{"half_length", quantity((contact.end - contact.begin) / 2., "m")},
               {"mid_length_line_load", quantity(loads::line_load_at(contact, 0.), "N/m")},
               {"root_stress", quantity(contact.root_stress, "Pa")},
               {"tip_deflection", quantity(contact.deflection, "m")},
               {"slope", quantity(contact.slope, "rad")},
               {"sections", contact.sections.size()},
               {"error_of_sections", contact.error}};
  if (line.doubt != loads::PeakDoubt::none) return section;
  section["peak_pressure"] = quantity(contact.peak_pressure, "Pa");
  section["peak_pressure_place"] = quantity(contact.peak_place, "m");
  section["expected_error"] = loads::expected_error(line.pin, contact);
  return section;
}

/// Where the crank holds the pin, by beam theory.
json root_section(const loads::BeamBending& beam) {
  return {{"root_force", quantity(beam.root_force, "N")},
          {"root_moment", quantity(beam.root_moment, "N m")},
          {"root_stress_beam_theory", quantity(beam.root_stress, "Pa")},
          {"root_shear_stress_beam_theory", quantity(beam.root_shear, "Pa")}};
}

/// Of a pin in 3-D that is a beam: nothing bends one that is held at its core.
json pin_section(const PinReport& pin, const loads::BeamBending& beam, const Figures& errors) {
  json section{{"tip_deflection", quantity(pin.bending.tip_deflection, "m")},
               {"tip_deflection_error", error_value(errors, Figure::tip_deflection)},
               {"slope", quantity(pin.bending.slope, "rad")},
               {"slope_error", error_value(errors, Figure::slope)},
               {"root_stress", quantity(pin.bending.root_stress, "Pa")},
               {"root_stress_error", error_value(errors, Figure::root_stress)}};
  section.update(root_section(beam));
  section["tip_deflection_beam_theory"] = quantity(beam.tip_deflection, "m");
  section["slope_beam_theory"] = quantity(beam.slope, "rad");
  if (pin.line) section["half_space_and_beam"] = line_section(*pin.line);
  return section;
}

json crown_section(const PinReport& pin) {
  json section{{"profile", pin.profile}, {"amplitude", quantity(pin.amplitude, "m")}};
  if (pin.crown_radius > 0.) section["radius"] = quantity(pin.crown_radius, "m");
  return section;
}

json contact_section(const fem::Solution<2>& solution, const fem::ContactResult<2>& contact,
                     const ContactAnalysis<2>& analysis, const Figures& errors,
                     const double parts) {
  json section = common_contact_section(solution, contact, errors, parts);
  section["half_width"] = quantity(contact.half_width, "m");
  section["half_width_error"] = error_value(errors, Figure::half_width);
  section["max_shear"] = quantity(analysis.max_shear.value, "Pa");
  section["max_shear_depth"] = quantity(analysis.max_shear_depth, "m");
  add_shear_errors(section, solution, errors);
  if (analysis.difference) {
    section["stress_difference_source"] = analysis.difference->source_body;
    section["stress_difference_target"] = analysis.difference->target_body;
  }
  return section;
}

json load_section(const MechanismReport& mechanism) {
  const loads::PinLoad& load = mechanism.load;
  return {{"pin_type", mechanism.roller ? "roller" : "fixed"},
          {"force", quantity(load.force, "N")},
          {"moment", quantity(load.moment, "N m")},
          {"driver_angle", quantity(load.driver_angle, "rad")},
          {"driver_speed", quantity(load.driver_speed, "rad/s")},
          {"driver_acceleration", quantity(load.driver_acceleration, "rad/s^2")},
          {"wheel_angle", quantity(load.wheel_angle, "rad")},
          {"wheel_acceleration", quantity(load.wheel_acceleration, "rad/s^2")},
          {"wheel_speed", quantity(load.wheel_speed, "rad/s")},
          {"pin_distance", quantity(load.pin_distance, "m")},
          {"travel_speed", quantity(load.travel_speed, "m/s")},
          {"pin_turn_speed", quantity(load.pin_turn_speed, "rad/s")},
          {"slip_speed", quantity(load.slip_speed, "m/s")},
          {"slip_speed_driving", quantity(load.slip_driving, "m/s")},
          {"slip_speed_braking", quantity(load.slip_braking, "m/s")},
          {"bore_speed", quantity(load.bore_speed, "m/s")}};
}

template <int dim>
json bodies_section(const fem::Solution<dim>& solution, const Results<dim>& results) {
  json bodies = json::object();
  for (std::size_t i = 0; i < results.max_von_mises.size(); ++i)
    bodies[solution.problem.bodies[i].name] = {
        {"max_von_mises", quantity(results.max_von_mises[i].value, "Pa")},
        {"max_von_mises_place", place(results.max_von_mises[i].place)}};
  return bodies;
}

/// Outside of the contacts' own field.
template <int dim>
json strength_section(const fem::Solution<dim>& solution) {
  json bodies = json::object();
  for (const fem::Body<dim>& body : solution.problem.bodies)
    bodies[body.name] = {{"von_mises", json()}, {"tensile", json()}};
  for (const NamedStress<dim>& stress : named_stresses(solution))
    bodies[stress.body][stress.name == "tensile stress" ? "tensile" : "von_mises"] = {
        {"value", stress.maximum.value},
        {"unit", "Pa"},
        {"error", finite(stress.maximum.total_error())},
        {"error_by_choice", stress.maximum.choice},
        {"bounded", stress.is_bounded},
        {"place", place(stress.maximum.place)},
        {"where", stress.where}};
  return bodies;
}

const char* name_of(const fem::Singularity why) {
  switch (why) {
    case fem::Singularity::end_of_support:
      return "end of support";
    case fem::Singularity::re_entrant_corner:
      return "re-entrant corner";
    default:
      return "growth";
  }
}

/// Where stresses have no bound and are left out; in 3-D from `place` to `end`.
template <int dim>
json left_out_section(const fem::Solution<dim>& solution) {
  json list = json::array();
  for (const fem::SingularPlace<dim>& singular : solution.singular)
    list.push_back({{"surface", solution.mesh.surfaces[singular.surface]},
                    {"why", name_of(singular.why)},
                    {"place", place(singular.begin)},
                    {"end", place(singular.end)},
                    {"radius", quantity(singular.radius, "m")}});
  return list;
}

template <int dim>
json wheel_section(const fem::Solution<dim>& solution, const Results<dim>& results,
                   const MechanismReport& mechanism) {
  json wheel{{"inertia_used", quantity(mechanism.inertia_used, "kg m^2")}};
  if (mechanism.inertia_from_geometry)
    wheel["inertia_from_geometry"] = quantity(*mechanism.inertia_from_geometry, "kg m^2");
  for (std::size_t i = 0; i < results.max_von_mises.size(); ++i)
    if (solution.problem.bodies[i].name == "wheel") {
      wheel["max_von_mises"] = quantity(results.max_von_mises[i].value, "Pa");
      wheel["max_von_mises_place"] = place(results.max_von_mises[i].place);
    }
  return wheel;
}

template <int dim>
json equilibrium_section(const Results<dim>& results, const RunReport& report) {
  json section{{"force_residual", results.equilibrium.force_residual},
               {"moment_residual", results.equilibrium.moment_residual}};
  if (report.mechanism && report.mechanism->bore_torque) {
    section["bore_torque"] = quantity(*report.mechanism->bore_torque, "N m");
    section["bore_torque_error"] = error_value(report.errors.mechanism, Figure::bore_torque);
    section["expected_bore_torque"] = quantity(report.mechanism->expected_bore_torque, "N m");
  }
  return section;
}

json quantity_if(const std::optional<double>& value, const Dimension dimension) {
  return value ? quantity(*value, dimension) : json();
}

template <int dim>
json comparison_section(const fem::Solution<dim>& solution, const Results<dim>& results,
                        const RunReport& report) {
  json rows = json::array();
  for (const ComparisonRow& row : comparison(solution, results, report)) {
    rows.push_back({{"quantity", row.quantity},
                    {"dimension", name_of(row.dimension)},
                    {"computed", quantity_if(row.computed, row.dimension)},
                    {"error", row.error ? finite(*row.error) : json()},
                    {"bounded", row.is_bounded},
                    {"closed_form", quantity_if(row.closed_form, row.dimension)},
                    {"published", quantity_if(row.published, row.dimension)}});
  }
  return rows;
}

template <int dim>
json checks_section(const fem::Solution<dim>& solution, const Results<dim>& results,
                    const RunReport& report) {
  json list = json::array();
  for (const Check& check : checks(solution, results, report))
    list.push_back({{"name", check.name},
                    {"meaning", check.meaning},
                    {"value", finite(check.value)},
                    {"limit", check.limit},
                    {"passed", check.is_passed()}});
  return list;
}

template <int dim>
json safety_section(const fem::Solution<dim>& solution, const Results<dim>& results,
                    const RunReport& report) {
  json rows = json::array();
  for (const SafetyRow& row : safety(solution, results, report)) {
    const auto number_if = [](const std::optional<double>& value) {
      return value ? json(*value) : json();
    };
    rows.push_back({{"quantity", row.quantity},
                    {"dimension", name_of(row.dimension)},
                    {"computed", quantity_if(row.computed, row.dimension)},
                    {"computed_factor", number_if(row.computed_factor())},
                    {"cycle", row.cycle ? quantity(row.cycle->value, row.dimension) : json()},
                    {"cycle_angle", row.cycle ? quantity(row.cycle->driver_angle, "rad") : json()},
                    {"allowed", quantity(row.allowed, row.dimension)},
                    {"factor", number_if(row.factor())},
                    {"driver_angle", quantity_if(row.driver_angle(), Dimension::angle)},
                    {"meaning", row.meaning}});
  }
  return rows;
}

json run_case_section(const RunReport& report, const int dimension) {
  json section = case_section(report.about);
  section["dimension"] = dimension;
  section["accuracy"] = report.accuracy;
  return section;
}

/// Of all bodies, away from the contact [Pa].
double maximum_von_mises(const fem::LevelRecord& level) {
  double maximum = 0.;
  for (const fem::StrengthRecord& body : level.strength)
    maximum = std::max(maximum, body.von_mises.value);
  return maximum;
}

template <int dim>
json solver_section(const fem::Solution<dim>& solution, const RunReport& report) {
  json levels = json::array();
  double assemble_and_solve = 0.;
  for (const fem::LevelRecord& level : solution.history) {
    levels.push_back({{"cells", level.cells},
                      {"dofs", level.dofs},
                      {"active_nodes", level.active_nodes},
                      {"active_set_iterations", level.linear_iterations.size()},
                      {"active_set_cycled", level.cycled},
                      {"linear_iterations", level.linear_iterations},
                      {"peak_pressure", quantity(level.peak_pressure, "Pa")},
                      {"maximum_von_mises", quantity(maximum_von_mises(level), "Pa")},
                      {"error_estimate", level.error_estimate},
                      {"elapsed", quantity(level.seconds, "s")}});
    assemble_and_solve = level.one_solve_seconds;
  }
  return {{"levels", levels},
          {"converged", fem::is_success(solution.stop.outcome)},
          {"message", report.stop_message},
          {"finest_assembly_and_solve", quantity(assemble_and_solve, "s")}};
}

/// What was refined for, and how accurate it is.
template <int dim>
json accuracy_section(const fem::Solution<dim>& solution, const RunReport& report) {
  return {{"of", refined_figure(solution)},
          {"error_estimate", solution.error_estimate},
          {"wanted", report.accuracy}};
}

/// All contacts, and again the one with the maximum pressure.
template <int dim>
void add_contacts(json& result, const fem::Solution<dim>& solution, const Results<dim>& results,
                  const RunReport& report) {
  const std::size_t leading = leading_contact(solution);
  const double parts = report.mechanism ? report.mechanism->parts : 1.;
  result["contact"] =
      contact_section(solution, solution.contacts[leading], results.contacts[leading],
                      report.errors.contacts[leading], parts);
  json pairs = json::array();
  for (std::size_t i = 0; i < solution.contacts.size(); ++i) {
    pairs.push_back(contact_section(solution, solution.contacts[i], results.contacts[i],
                                    report.errors.contacts[i], parts));
    if (const auto friction = friction_figures(solution, solution.contacts[i], report.mechanism)) {
      pairs.back()["friction"] = friction_section(*friction, parts);
      if constexpr (dim == 2)
        add_surface(pairs.back()["friction"], results.contacts[i], report.errors.contacts[i]);
      if (i == leading) result["contact"]["friction"] = pairs.back()["friction"];
    }
    if (results.contacts[i].hertz)
      pairs.back()["hertz"] = hertz_section(*results.contacts[i].hertz);
  }
  result["contact_pairs"] = pairs;
  if (results.contacts[leading].hertz)
    result["hertz"] = hertz_section(*results.contacts[leading].hertz);
  if constexpr (dim == 3)
    if (!results.contacts[leading].sections.empty())
      result["line_load"] =
          line_load_section(line_load(solution.contacts[leading], results.contacts[leading].frame,
                                      results.contacts[leading].sections),
                            report.errors.contacts[leading], is_bounded(solution));
  if constexpr (dim == 3)
    if (report.mechanism && results.contacts[leading].hertz)
      result["johnson"] = johnson_section(solution, solution.contacts[leading],
                                          results.contacts[leading].hertz->even);
}

void add_pin(json& result, const MechanismReport& mechanism, const Figures& errors) {
  if (mechanism.beam)
    result["pin"] = mechanism.pin ? pin_section(*mechanism.pin, *mechanism.beam, errors)
                                  : root_section(*mechanism.beam);
  if (mechanism.pin) result["crown"] = crown_section(*mechanism.pin);
  if (mechanism.roller)
    result["roller"] = {{"bore_diameter", quantity(mechanism.roller->diameter, "m")},
                        {"bearing_load", quantity(std::abs(mechanism.load.force), "N")}};
  if (mechanism.roller && !mechanism.needle)
    result["roller"]["mean_bore_pressure"] = quantity(mechanism.bore_pressure, "Pa");
  if (mechanism.needle) {
    result["roller"]["stud_diameter"] = quantity(mechanism.roller->stud(), "m");
    result["roller"]["needle_load"] = quantity(mechanism.needle->load, "N");
    result["roller"]["needle_pressure"] = quantity(mechanism.needle->pressure, "Pa");
  }
}

}  // namespace

template <int dim>
json summary(const fem::Solution<dim>& solution, const Results<dim>& results,
             const RunReport& report) {
  json result{{"case", run_case_section(report, dim)},
              {"accuracy", accuracy_section(solution, report)},
              {"bodies", bodies_section(solution, results)},
              {"strength", strength_section(solution)},
              {"strength_left_out", left_out_section(solution)},
              {"equilibrium", equilibrium_section(results, report)},
              {"reactions", reactions_section(solution)},
              {"solver", solver_section(solution, report)},
              {"comparison", comparison_section(solution, results, report)},
              {"checks", checks_section(solution, results, report)},
              {"safety", safety_section(solution, results, report)},
              {"notices", report.notices}};
  const fem::LevelRecord& finest = solution.history.back();
  result["mesh"] = {
      {"levels", solution.history.size()}, {"cells", finest.cells}, {"dofs", finest.dofs}};
  result["contact_pairs"] = json::array();
  if (fem::has_contact(solution.problem)) add_contacts(result, solution, results, report);
  if (report.mechanism) {
    add_pin(result, *report.mechanism, report.errors.mechanism);
    result["load"] = load_section(*report.mechanism);
    result["wheel"] = wheel_section(solution, results, *report.mechanism);
  }
  if (report.published_peak_pressure)
    result["published"] = {{"peak_pressure", quantity(*report.published_peak_pressure, "Pa")},
                           {"source", report.published_source}};
  result["time"] = {{"mesh", quantity(report.mesh_seconds, "s")},
                    {"solve", quantity(report.solve_seconds, "s")},
                    {"post", quantity(report.post_seconds, "s")},
                    {"total", quantity(report.total_seconds, "s")}};
  result["memory"] = {{"peak", quantity(report.peak_memory, "byte")}, {"ranks", report.ranks}};
  result["versions"] = versions_section(report.geneva_version);
  result["versions"]["deal.II"] = DEAL_II_PACKAGE_VERSION;
  result["versions"]["gmsh"] = report.gmsh_version;
  return result;
}

template json summary(const fem::Solution<2>&, const Results<2>&, const RunReport&);
template json summary(const fem::Solution<3>&, const Results<3>&, const RunReport&);

}  // namespace geneva::post
