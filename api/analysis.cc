#include "api/analysis.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <cmath>
#include <optional>
#include <utility>

#include "api/analysis_notices.h"
#include "api/analysis_output.h"
#include "api/analysis_state.h"
#include "api/checkpoint_file.h"
#include "api/mechanism_results.h"
#include "api/mesher_on_rank_zero.h"
#include "api/told_together.h"
#include "api/vector_of.h"
#include "api/version.h"
#include "base/allocation.h"
#include "fem/adaptivity/resource_limits.h"
#include "fem/contact_problem.h"
#include "model/case_header.h"
#include "model/naming.h"
#include "model/stop_message.h"
#include "model/together.h"
#include "post/analysis/checks.h"
#include "post/analysis/comparison.h"

namespace geneva {

namespace {

using api::AnalysedModel;
using api::AnalysisState;
using api::vector_of;

bool is_first(const MPI_Comm communicator) {
  return dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
}

template <int dim>
model::Model<dim> model_of(const MPI_Comm communicator, const Case& given,
                           mesh::Mesher* const started) {
  api::MesherOnRankZero mesher(communicator, started);
  return model::naming(given,
                       [&] { return model::make_model<dim>(communicator, given, mesher.get()); });
}

template <int dim>
struct Solved {
  fem::Solution<dim> solution;
  std::vector<post::RunFigures> figures;  ///< by mesh
};

/// The run that a checkpoint stands for, if there is one.
template <int dim>
std::optional<api::SavedRun<dim>> earlier_run(const std::string& saved,
                                              const model::Model<dim>& model) {
  if (saved.empty()) return std::nullopt;
  return api::saved_run<dim>(saved, model.mesh);
}

/// The contact problem solved, from the beginning or from where an earlier run ended.
template <int dim>
Solved<dim> solve(const MPI_Comm communicator, const Case& given, const model::Model<dim>& model,
                  std::optional<api::SavedRun<dim>> earlier, const AnalysisOptions& options) {
  std::optional<fem::Checkpoint<dim>> start;
  std::vector<post::RunFigures> figures;
  if (earlier) {
    start = std::move(earlier->state);
    figures = std::move(earlier->figures);
  }
  fem::Progress<dim> watch;
  watch.step = told_together(communicator, options.progress.step);
  watch.level = told_together(communicator, options.progress.mesh);
  watch.work = told_together(communicator, options.progress.work);
  watch.solution = [&](const fem::Solution<dim>& on_mesh) {
    figures.push_back(api::run_figures(model, given, on_mesh));
  };
  const Checkpointing& checkpoints = options.checkpoints;
  if (checkpoints.is_wanted)
    watch.checkpoint = [&](const fem::Checkpoint<dim>& state) {
      if (is_first(communicator) && checkpoints.is_due())
        checkpoints.keep(
            api::checkpoint_text(given, model.mesh, api::SavedRun<dim>{state, figures}));
    };
  fem::Solution<dim> solution = model::naming(given, [&] {
    return fem::solve_contact(communicator, model.mesh, model.problem, given.settings, watch,
                              start);
  });
  figures.resize(solution.history.size());  // after a failed allocation the last mesh may be gone
  return {std::move(solution), std::move(figures)};
}

/// What the report says beside the solution; times are added as they become known.
template <int dim>
post::RunReport make_report(const MPI_Comm communicator, const Case& given,
                            const AnalysedModel<dim>& analysed) {
  const auto& [model, solution, results] = analysed;
  post::RunReport report{};
  report.about = model::header_of(given);
  report.mechanism = api::mechanism_report(model, given, solution, results);
  report.accuracy = given.settings.accuracy;
  report.notices = model.notices;
  for (const std::string& notice : api::notices_of(given, solution, results))
    report.notices.push_back(notice);
  if (report.mechanism)
    for (const std::string& notice : api::torque_notices(*report.mechanism, given.units))
      report.notices.push_back(notice);
  if constexpr (dim == 3)
    if (report.mechanism && report.mechanism->pin)
      for (const std::string& notice : api::line_notices(*report.mechanism->pin, solution, results))
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

template <int dim>
Contact contact_of(const fem::ContactResult<dim>& found,
                   const post::ContactAnalysis<dim>& analysis) {
  Contact contact{found.source,
                  found.target,
                  vector_of(found.force),
                  found.peak_pressure,
                  post::half_width(found, analysis),
                  {}};
  for (const fem::ContactNode<dim>& node : found.nodes)
    contact.points.push_back(
        {vector_of(node.position), node.pressure, node.gap, post::hertz_pressure(analysis, node)});
  return contact;
}

/// The plain figures of an analysis.
template <int dim>
Analysis described(const Case& given, const AnalysedModel<dim>& analysed,
                   const post::RunReport& report) {
  const fem::Solution<dim>& solution = analysed.solution;
  const post::Results<dim>& results = analysed.results;
  Analysis analysis{};
  analysis.given = given;
  analysis.is_converged = fem::is_success(solution.stop.outcome);
  analysis.shortfall = api::shortfall(solution, given.settings.accuracy);
  analysis.error = solution.error_estimate;
  for (std::size_t i = 0; i < solution.contacts.size(); ++i)
    analysis.contacts.push_back(contact_of(solution.contacts[i], results.contacts[i]));
  analysis.meshes = solution.history;
  analysis.figures = post::comparison(solution, results, report);
  analysis.checks = post::checks(solution, results, report);
  analysis.notices = report.notices;
  analysis.table = post::comparison_table(solution, results, report, given.units);
  analysis.memory = report.peak_memory;
  return analysis;
}

template <int dim>
Analysis analyse_in(const Case& given, const MPI_Comm communicator,
                    const AnalysisOptions& options) {
  const dealii::Timer total;
  dealii::Timer timer;
  AnalysedModel<dim> analysed{model_of<dim>(communicator, given, options.mesher), {}, {}};
  const model::Model<dim>& model = analysed.model;
  const double mesh_seconds = timer.wall_time();
  auto earlier = earlier_run(options.checkpoints.start, model);
  if (options.progress.start)
    end_together(communicator, [&] {
      options.progress.start({api::heading(given, model), model.notices,
                              earlier ? earlier->state.history : std::vector<fem::LevelRecord>{}});
    });

  timer.restart();
  auto [solution, figures] = solve(communicator, given, model, std::move(earlier), options);
  const double solve_seconds = timer.wall_time();

  timer.restart();
  if (options.progress.work)
    end_together(communicator, [&, dofs = solution.history.back().dofs] {
      options.progress.work({fem::Work::results, dofs});
    });
  base::AllocationWatch allocations;
  analysed.solution = std::move(solution);
  analysed.results = post::analyse(analysed.solution);
  post::RunReport report = make_report(communicator, given, analysed);
  report.errors = post::figure_errors(analysed.solution, figures);
  Analysis analysis = described(given, analysed, report);
  model::together(communicator, [&] { allocations.require_none(); });
  report.mesh_seconds = mesh_seconds;
  report.solve_seconds = solve_seconds;
  report.post_seconds = timer.wall_time();
  report.total_seconds = total.wall_time();
  analysis.state = std::make_shared<const AnalysisState>(
      AnalysisState{communicator, std::move(analysed), std::move(report)});
  return analysis;
}

}  // namespace

Analysis analyse(const Case& given, const MPI_Comm communicator, const AnalysisOptions& options) {
  return given.dimension == 3 ? analyse_in<3>(given, communicator, options)
                              : analyse_in<2>(given, communicator, options);
}

Written write(const Analysis& analysis, const std::filesystem::path& directory) {
  api::AnalysisOutput output(analysis.state->communicator, analysis.given, directory);
  return output.write(analysis, "", "");
}

}  // namespace geneva
