#include "app/run.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/checkpoint_file.h"
#include "app/checkpoint_keeper.h"
#include "app/mechanism_picture.h"
#include "app/mechanism_results.h"
#include "app/output_directory.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/version.h"
#include "base/allocation.h"
#include "base/output_file.h"
#include "fem/adaptivity/resource_limits.h"
#include "fem/contact_problem.h"
#include "loads/pi.h"
#include "model/input/case_file.h"
#include "model/input/parameters.h"
#include "model/model.h"
#include "model/naming.h"
#include "model/stop_message.h"
#include "model/together.h"
#include "post/analysis/comparison.h"
#include "post/analysis/results.h"
#include "post/output/contact_output.h"
#include "post/output/field_output.h"
#include "post/output/result_files.h"
#include "post/output/summary.h"
#include "post/view/view_output.h"

namespace geneva::app {

namespace fs = std::filesystem;

namespace {

template <int dim>
std::string heading(const model::Case& given, const model::Model<dim>& model) {
  const auto length = base::output_unit(given.units, base::Dimension::length);
  const auto force = base::output_unit(given.units, base::Dimension::force);
  std::string text = name_of(given);
  if (!given.title.empty()) text += ": " + given.title;
  if (model.mechanism) {
    const auto& state = *model.mechanism;
    constexpr double degrees = 180. / loads::pi;
    text += fmt::format(
        "\n{}, wheel diameter {:.5g} {}, pin diameter {:.4g} {}, thickness {:.4g} {}\n"
        "driver angle {:.4f} deg, wheel acceleration {:.6g} rad/s^2, pin distance {:.5g} {}, pin "
        "force {:.6g} {}",
        state.driven.mechanism().name, state.sizes.wheel_diameter * length.factor, length.name,
        state.sizes.pin_diameter * length.factor, length.name,
        state.sizes.thickness * length.factor, length.name, state.load.driver_angle * degrees,
        state.load.wheel_acceleration, state.load.pin_distance * length.factor, length.name,
        state.load.force * force.factor, force.name);
  }
  return text;
}

/// What the user should know before trusting linear elasticity.
template <int dim>
std::vector<std::string> validity_notices(const fem::Solution<dim>& solution) {
  constexpr double small_strain = 0.1;
  double modulus = std::numeric_limits<double>::max();
  for (const fem::Body<dim>& body : solution.problem.bodies)
    modulus = std::min(modulus, body.material.youngs_modulus);
  const double ratio = solution.history.back().peak_pressure / modulus;
  if (ratio < small_strain) return {};
  return {fmt::format(
      "the peak pressure is {:.2g} times Young's modulus: strains are not small there, and linear "
      "elasticity no longer holds; check the load and its unit",
      ratio)};
}

/// What the user should know of a contact that ends before the surfaces do.
std::vector<std::string> length_notices(const fem::Solution<2>& /*unused*/,
                                        const post::Results<2>& /*unused*/,
                                        const base::UnitSystem /*unused*/) {
  return {};
}
std::vector<std::string> length_notices(const fem::Solution<3>& solution,
                                        const post::Results<3>& results,
                                        const base::UnitSystem units) {
  constexpr double nearly_all = 0.95;
  const std::size_t leading = post::leading_contact(solution);
  const auto& sections = results.contacts[leading].sections;
  const double common =
      post::common_length(solution.contacts[leading], results.contacts[leading].frame);
  const double loaded = sections.empty() ? 0. : sections.back().z - sections.front().z;
  if (loaded > nearly_all * common) return {};
  const auto length = base::output_unit(units, base::Dimension::length);
  return {
      fmt::format("the contact is {:.4g} {} long, the surfaces face each other over {:.4g} {}: "
                  "their ends carry nothing",
                  loaded * length.factor, length.name, common * length.factor, length.name)};
}

/// To two digits.
double rounded_up(const double value) {
  const double unit = std::pow(10., std::floor(std::log10(value)) - 1.);
  return std::ceil(value / unit * (1. - 1e-12)) * unit;
}

/// What was reached, what was wanted and why the refinement ended; empty if it converged.
template <int dim>
std::string shortfall(const fem::Solution<dim>& solution, const double accuracy) {
  if (fem::is_success(solution.stop.outcome)) return "";
  const double error = solution.error_estimate;
  const std::string reached =
      error < 1. ? fmt::format("{:.2g} %", 100. * error) : std::string("not even 100 %");
  const std::string message =
      fmt::format("not converged: the accuracy reached is {}, wanted is {:.2g} %: {}", reached,
                  100. * accuracy, model::message_of(solution.stop));
  const double offered = rounded_up(error);
  if (solution.stop.outcome == fem::Outcome::unbounded_pressure ||
      offered > model::greatest_accuracy)
    return message;
  return message + fmt::format("; or be content with 'Accuracy' = {:.2g} %", 100. * offered);
}

/// What the safety factors over the cycle leave out: impacts, which no torque balance knows.
std::vector<std::string> impact_notices(const model::Case& given) {
  const bool has_limit = given.allowed.contact_pressure || given.allowed.pressure_times_slip;
  if (!given.mechanism || !has_limit) return {};
  std::vector<std::string> notices;
  for (const loads::Unbounded& place : model::driven_mechanism(*given.mechanism).unbounded())
    if (place.quantity == "wheel acceleration")
      notices.push_back(
          fmt::format("the wheel's speed jumps at a driver angle of {:.6g} deg: the safety factors "
                      "leave out that impact",
                      place.driver_angle / loads::degree));
  return notices;
}

/// What the user should know of a pin in the round bottom of its slot, whose pressure does not only
/// turn the wheel.
template <int dim>
std::vector<std::string> bottom_notices(const fem::Solution<dim>& solution,
                                        const base::UnitSystem units) {
  constexpr double worth_saying = 0.01;
  const fem::Components<dim>& force = solution.contacts.front().force;
  const double along = std::abs(force[0]);
  if (along < worth_saying * std::abs(force[1])) return {};
  const auto unit = base::output_unit(units, base::Dimension::force);
  return {fmt::format(
      "the pin stands in the round bottom of its slot, which also presses it along the slot, by "
      "{:.4g} {}: the driver holds it there, and the contact force is the resultant of both",
      along * unit.factor, unit.name)};
}

/// What the user should know of the solution.
template <int dim>
std::vector<std::string> notices_of(const model::Case& given, const fem::Solution<dim>& solution,
                                    const post::Results<dim>& results) {
  std::vector<std::string> notices = validity_notices(solution);
  for (const std::string& notice : impact_notices(given)) notices.push_back(notice);
  for (const post::ContactAnalysis<dim>& contact : results.contacts)
    if (!contact.hertz_objection.empty()) notices.push_back(contact.hertz_objection);
  if (!given.mechanism) return notices;
  for (const std::string& notice : bottom_notices(solution, given.units)) notices.push_back(notice);
  for (const std::string& notice : length_notices(solution, results, given.units))
    notices.push_back(notice);
  return notices;
}

/// What the report says beside the solution; times are added as they become known.
template <int dim>
post::RunReport make_report(const MPI_Comm communicator, const model::Case& given,
                            const model::Model<dim>& model, const fem::Solution<dim>& solution,
                            const post::Results<dim>& results) {
  post::RunReport report{};
  report.about = model::header_of(given);
  report.mechanism = mechanism_report(model, given, solution, results);
  report.accuracy = given.settings.accuracy;
  report.notices = model.notices;
  for (const std::string& notice : notices_of(given, solution, results))
    report.notices.push_back(notice);
  report.stop_message = model::message_of(solution.stop);
  report.allowed = given.allowed;
  report.published_peak_pressure = given.published_peak_pressure;
  report.published_source = given.published_source;
  report.geneva_version = version;
  report.gmsh_version = model.gmsh_version;
  report.ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  report.peak_memory = fem::peak_memory(communicator);
  return report;
}

/// Says what the user should know of the solution, then the table.
template <int dim>
void present(const model::Case& given, const fem::Solution<dim>& solution,
             const post::Results<dim>& results, const post::RunReport& report,
             ProgressDisplay& progress) {
  for (const std::string& notice : notices_of(given, solution, results))
    progress.line("note: " + notice);
  if (const std::string why = shortfall(solution, given.settings.accuracy); !why.empty())
    progress.warning(why);
  progress.line("\n" + post::comparison_table(solution, results, report, given.units));
}

/// Writes what rank 0 writes alone, and puts everything in its place.
/// @return names of the files of other cases that it removed
template <int dim>
std::vector<std::string> publish(const model::Case& given, const fem::Solution<dim>& solution,
                                 const post::Results<dim>& results, const post::RunReport& report,
                                 const model::Model<dim>& model, const nlohmann::json& view,
                                 const std::string& log, const CheckpointKeeper& checkpoints,
                                 OutputDirectory& directory) {
  const fs::path& working = directory.working();
  if (!view.is_null()) base::write_text(post::own_file(working, "view.json"), view.dump() + "\n");
  if (model.mechanism)
    base::write_text(post::own_file(working, "mechanism.json"),
                     post::mechanism_document(mechanism_picture(*given.mechanism, *model.mechanism,
                                                                model.mechanism->load))
                             .dump() +
                         "\n");
  post::write_contact(solution, results, given.units, working);
  base::write_text(post::own_file(working, "summary.json"),
                   post::summary(solution, results, report).dump(2) + "\n");
  base::write_text(post::own_file(working, "case.prm"), given.completed);
  base::write_text(post::own_file(working, "log.txt"), log);
  checkpoints.add_to(working);
  std::vector<std::string> removed = directory.publish(write_report);
  checkpoints.remove(fem::is_success(solution.stop.outcome));
  return removed;
}

/// Of the results on a mesh of so many unknowns [byte], at most: measured in the plane 5.3 and 13.3
/// MB with 6 300 and 21 100, in 3-D 5.1, 22.3 and 39.6 MB with 9 100, 46 900 and 89 300; the
/// checkpoint adds 20 to 31 bytes per unknown.
double size_of_results(const double unknowns) { return 2e6 + 581. * unknowns; }

std::string command_to_continue(const fs::path& case_directory, const RunRequest& request) {
  return fmt::format("geneva run --continue {}{}", case_directory.string(),
                     request.output.empty() ? "" : " --output " + request.output.string());
}

template <int dim>
struct Solved {
  fem::Solution<dim> solution;
  std::vector<post::RunFigures> figures;  ///< by mesh
};

/// The contact problem solved, from the beginning or from a checkpoint.
/// @param saved text of the checkpoint; empty: from the beginning
template <int dim>
Solved<dim> solve(const MPI_Comm communicator, const model::Case& given,
                  const model::Model<dim>& model, const std::string& saved,
                  const dealii::Timer& total, CheckpointKeeper& checkpoints,
                  ProgressDisplay& progress) {
  const bool is_first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  std::optional<fem::Checkpoint<dim>> start;
  std::vector<post::RunFigures> figures;
  if (!saved.empty()) {
    SavedRun<dim> run = saved_run(saved, model.mesh);
    progress.line(
        fmt::format("continues from a mesh of {} unknowns", run.state.history.back().dofs));
    for (const fem::LevelRecord& level : run.state.history) progress.level(level);
    start = std::move(run.state);
    figures = std::move(run.figures);
  }
  fem::Progress<dim> watch;
  watch.step = [&](const fem::StepReport& step) { progress.step(step); };
  watch.level = [&](const fem::LevelRecord& level) { progress.level(level); };
  watch.solution = [&](const fem::Solution<dim>& on_mesh) {
    figures.push_back(run_figures(model, given, on_mesh));
  };
  if (checkpoints.is_wanted())
    watch.checkpoint = [&](const fem::Checkpoint<dim>& state) {
      if (!is_first || !checkpoints.is_due(total.wall_time())) return;
      const std::string trouble =
          checkpoints.keep(checkpoint_text(given, model.mesh, SavedRun<dim>{state, figures}));
      if (!trouble.empty()) progress.warning("note: " + trouble);
    };
  fem::Solution<dim> solution = model::naming(given, [&] {
    return fem::solve_contact(communicator, model.mesh, model.problem, given.settings, watch,
                              start);
  });
  figures.resize(solution.history.size());  // after a failed allocation the last mesh may be gone
  return {std::move(solution), std::move(figures)};
}

/// Mesh, solution, results and files of a case.
template <int dim>
int run(const MPI_Comm communicator, const model::Case& given, const RunRequest& request,
        const dealii::Timer& total, std::optional<mesh::Mesher>& mesher) {
  const bool is_first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  const fs::path output = request.output.empty() ? given.directory / "results" : request.output;
  const std::string command = command_to_continue(given.directory, request);
  std::optional<OutputDirectory> directory;
  model::together(communicator, [&] {
    directory.emplace(output, given, "summary", is_first);
    constexpr double few_unknowns = dim == 2 ? 5e3 : 5e4;  // the least that a case takes
    directory->check_space(size_of_results(few_unknowns));
  });
  const std::string saved =
      request.is_continued ? read_checkpoint(communicator, output, given) : "";
  CheckpointKeeper checkpoints(given, output, saved, command);
  ProgressDisplay progress(is_first, given.units);
  dealii::Timer timer;
  const model::Model<dim> model =
      model::naming(given, [&] { return model::make_model<dim>(communicator, given, mesher); });
  const double mesh_seconds = timer.wall_time();
  progress.line(heading(given, model));
  for (const std::string& notice : model.notices) progress.line("note: " + notice);
  if (const std::string left = notice_of_unfinished(output, command);
      !left.empty() && !request.is_continued)
    progress.line("note: " + left);

  timer.restart();
  const auto [solution, figures] =
      solve(communicator, given, model, saved, total, checkpoints, progress);
  const double solve_seconds = timer.wall_time();

  timer.restart();
  base::AllocationWatch allocations;
  const post::Results<dim> results = post::analyse(solution);
  post::RunReport report = make_report(communicator, given, model, solution, results);
  report.errors = post::figure_errors(solution, figures);
  present(given, solution, results, report, progress);
  model::together(communicator, [&] {
    directory->check_space(size_of_results(static_cast<double>(solution.history.back().dofs)));
  });
  post::write_fields(solution, results, given.units, directory->working());
  const nlohmann::json view = post::view_document(solution, results, given.units);
  report.mesh_seconds = mesh_seconds;
  report.solve_seconds = solve_seconds;
  report.post_seconds = timer.wall_time();
  report.total_seconds = total.wall_time();
  std::vector<std::string> removed;
  model::together(communicator, [&] {
    allocations.require_none();
    if (!is_first) return;
    removed = publish(given, solution, results, report, model, view, progress.log(), checkpoints,
                      *directory);
  });
  if (!removed.empty()) progress.line(removal_notice(removed));
  progress.line(fmt::format("results in {}, report.html to look at ({:.2f} s, {:.0f} MB)",
                            shown_path(output), total.wall_time(), report.peak_memory / 1e6));
  if (fem::is_success(solution.stop.outcome)) return 0;
  if (const std::string advice = checkpoints.advice(); !advice.empty())
    progress.line(advice + ", with other limits or another accuracy");
  return 2;
}

}  // namespace

int run_case(const MPI_Comm communicator, const fs::path& case_directory, const RunRequest& request,
             std::optional<mesh::Mesher>& mesher) {
  const dealii::Timer total;
  const model::Case given = model::read_case(case_directory);
  return given.dimension == 3 ? run<3>(communicator, given, request, total, mesher)
                              : run<2>(communicator, given, request, total, mesher);
}

}  // namespace geneva::app
