#include "post/summary.h"

#include <deal.II/base/config.h>
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace geneva::post {

using nlohmann::json;

namespace {

json quantity(const double value, const char* unit) { return {{"value", value}, {"unit", unit}}; }

json place(const std::array<double, 2>& at) {
  return {{"x", quantity(at[0], "m")}, {"y", quantity(at[1], "m")}};
}

json hertz_section(const ClosedForm& form) {
  return {{"peak_pressure", quantity(form.peak_pressure(), "Pa")},
          {"half_width", quantity(form.half_width(), "m")},
          {"max_shear", quantity(form.max_shear(), "Pa")},
          {"max_shear_depth", quantity(form.max_shear_depth(), "m")},
          {"relative_radius", quantity(form.relative_radius, "m")},
          {"contact_modulus", quantity(form.contact_modulus, "Pa")}};
}

json contact_section(const fem::Solution<2>& solution, const fem::ContactResult<2>& contact,
                     const ContactAnalysis& analysis) {
  json section{{"source", contact.source},
               {"target", contact.target},
               {"force", quantity(std::hypot(contact.force[0], contact.force[1]), "N")},
               {"peak_pressure", quantity(contact.peak_pressure, "Pa")},
               {"peak_pressure_error", solution.error_estimate},
               {"half_width", quantity(contact.half_width, "m")},
               {"max_shear", quantity(analysis.max_shear.value, "Pa")},
               {"max_shear_depth", quantity(analysis.max_shear_depth, "m")},
               {"max_penetration", quantity(contact.max_penetration, "m")},
               {"active_nodes", contact.active_nodes}};
  if (analysis.difference) {
    section["stress_difference_source"] = analysis.difference->source_body;
    section["stress_difference_target"] = analysis.difference->target_body;
  }
  return section;
}

json load_section(const loads::PinLoad& load) {
  return {{"force", quantity(load.force, "N")},
          {"moment", quantity(load.moment, "N m")},
          {"driver_angle", quantity(load.driver_angle, "rad")},
          {"driver_speed", quantity(load.driver_speed, "rad/s")},
          {"driver_acceleration", quantity(load.driver_acceleration, "rad/s^2")},
          {"wheel_angle", quantity(load.wheel_angle, "rad")},
          {"wheel_acceleration", quantity(load.wheel_acceleration, "rad/s^2")},
          {"wheel_speed", quantity(load.wheel_speed, "rad/s")},
          {"pin_distance", quantity(load.pin_distance, "m")},
          {"slip_speed", quantity(load.slip_speed, "m/s")}};
}

json bodies_section(const fem::Solution<2>& solution, const Results& results) {
  json bodies = json::object();
  for (std::size_t i = 0; i < results.max_von_mises.size(); ++i)
    bodies[solution.problem.bodies[i].name] = {
        {"max_von_mises", quantity(results.max_von_mises[i].value, "Pa")},
        {"max_von_mises_place", place(results.max_von_mises[i].place)}};
  return bodies;
}

json wheel_section(const fem::Solution<2>& solution, const Results& results,
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

json equilibrium_section(const Results& results, const RunReport& report) {
  json section{{"force_defect", results.equilibrium.force_defect},
               {"moment_defect", results.equilibrium.moment_defect}};
  if (report.mechanism && report.mechanism->bore_torque) {
    section["bore_torque"] = quantity(*report.mechanism->bore_torque, "N m");
    section["expected_bore_torque"] = quantity(report.mechanism->expected_bore_torque, "N m");
  }
  return section;
}

json solver_section(const fem::Solution<2>& solution) {
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
                      {"error_estimate", level.error_estimate},
                      {"elapsed", quantity(level.seconds, "s")}});
    assemble_and_solve = level.one_solve_seconds;
  }
  return {{"levels", levels},
          {"converged", solution.outcome == fem::Outcome::converged},
          {"message", solution.message},
          {"finest_assembly_and_solve", quantity(assemble_and_solve, "s")}};
}

}  // namespace

json summary(const fem::Solution<2>& solution, const Results& results, const RunReport& report) {
  const std::size_t leading = leading_contact(solution);
  json result{
      {"case", {{"name", report.case_name}, {"title", report.title}}},
      {"contact", contact_section(solution, solution.contacts[leading], results.contacts[leading])},
      {"bodies", bodies_section(solution, results)},
      {"equilibrium", equilibrium_section(results, report)},
      {"solver", solver_section(solution)}};
  const fem::LevelRecord& finest = solution.history.back();
  result["mesh"] = {
      {"levels", solution.history.size()}, {"cells", finest.cells}, {"dofs", finest.dofs}};
  json pairs = json::array();
  for (std::size_t i = 0; i < solution.contacts.size(); ++i) {
    pairs.push_back(contact_section(solution, solution.contacts[i], results.contacts[i]));
    if (results.contacts[i].hertz)
      pairs.back()["hertz"] = hertz_section(*results.contacts[i].hertz);
  }
  result["contact_pairs"] = pairs;
  if (results.contacts[leading].hertz)
    result["hertz"] = hertz_section(*results.contacts[leading].hertz);
  if (report.mechanism) {
    result["load"] = load_section(report.mechanism->load);
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
  result["versions"] = {{"geneva", report.geneva_version},
                        {"deal.II", DEAL_II_PACKAGE_VERSION},
                        {"gmsh", report.gmsh_version}};
  return result;
}

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

std::vector<TableRow> contact_rows(const fem::ContactResult<2>& contact,
                                   const ContactAnalysis& analysis, const RunReport& report,
                                   const UnitSystem units) {
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit length = output_unit(units, Dimension::length);
  const auto closed = [&](const double value, const OutputUnit& unit) {
    return analysis.hertz ? std::optional(value * unit.factor) : std::nullopt;
  };
  const ClosedForm form =
      analysis.hertz.value_or(ClosedForm{loads::HertzLine{}, {}, 0., 0., 0., {}, 0., {}});
  const auto published = report.published_peak_pressure
                             ? std::optional(*report.published_peak_pressure * stress.factor)
                             : std::nullopt;
  return {{"peak contact pressure [" + stress.name + "]", contact.peak_pressure * stress.factor,
           closed(form.peak_pressure(), stress), published},
          {(form.point ? "contact radius [" : "half-width [") + length.name + "]",
           contact.half_width * length.factor, closed(form.half_width(), length), std::nullopt},
          {"greatest shear [" + stress.name + "]", analysis.max_shear.value * stress.factor,
           closed(form.max_shear(), stress), std::nullopt},
          {"its depth [" + length.name + "]", analysis.max_shear_depth * length.factor,
           closed(form.max_shear_depth(), length), std::nullopt}};
}

}  // namespace

std::string comparison_table(const fem::Solution<2>& solution, const Results& results,
                             const RunReport& report, const UnitSystem units) {
  const std::size_t leading = leading_contact(solution);
  const fem::ContactResult<2>& contact = solution.contacts[leading];
  const OutputUnit force = output_unit(units, Dimension::force);
  const OutputUnit moment = output_unit(units, Dimension::moment);
  std::vector<TableRow> rows;
  const double contact_force = std::hypot(contact.force[0], contact.force[1]) * force.factor;
  rows.push_back(
      {"contact force [" + force.name + "]", contact_force,
       report.mechanism ? std::optional(report.mechanism->load.force * force.factor) : std::nullopt,
       std::nullopt});
  for (const TableRow& row : contact_rows(contact, results.contacts[leading], report, units))
    rows.push_back(row);
  if (report.mechanism && report.mechanism->bore_torque)
    rows.push_back({report.mechanism->held_surface + " torque [" + moment.name + "]",
                    *report.mechanism->bore_torque * moment.factor,
                    report.mechanism->expected_bore_torque * moment.factor, std::nullopt});

  std::string table = fmt::format("{:<32}{:>14}{:>14}{:>14}{:>14}\n", "", "this program",
                                  "closed form", "published", "difference");
  for (const TableRow& row : rows)
    table += fmt::format("{:<32}{:>14}{:>14}{:>14}{:>14}\n", row.name, cell(row.computed),
                         cell(row.closed_form), cell(row.published), difference(row));
  table += solution.error_estimate < 1.
               ? fmt::format("estimated error of the peak contact pressure: {:.2g} %\n",
                             100. * solution.error_estimate)
               : "estimated error of the peak contact pressure: unknown, the mesh is too coarse\n";
  table += fmt::format("force balance: defect {:.1e} of the contact force\n",
                       results.equilibrium.force_defect);
  return table;
}

}  // namespace geneva::post
