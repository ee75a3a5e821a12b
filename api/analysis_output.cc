#include "api/analysis_output.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <nlohmann/json.hpp>

#include "api/analysis_state.h"
#include "api/mechanism_picture.h"
#include "base/allocation.h"
#include "base/output_file.h"
#include "model/together.h"
#include "post/output/contact_output.h"
#include "post/output/field_output.h"
#include "post/output/result_files.h"
#include "post/output/summary.h"
#include "post/view/view_output.h"

namespace geneva::api {

namespace fs = std::filesystem;

namespace {

/// Of the results on a mesh of so many unknowns [byte], at most: measured in the plane 5.3 and 13.3
/// MB with 6 300 and 21 100, in 3-D 5.1, 22.3 and 39.6 MB with 9 100, 46 900 and 89 300; the
/// checkpoint adds 20 to 31 bytes per unknown.
double size_of_results(const double unknowns) { return 2e6 + 581. * unknowns; }

void write_json(const fs::path& directory, const char* const name, const nlohmann::json& document,
                const int indent = -1) {
  base::write_text(post::own_file(directory, name), document.dump(indent) + "\n");
}

/// What rank 0 writes alone.
template <int dim>
void write_alone(const Case& given, const AnalysedModel<dim>& analysed,
                 const post::RunReport& report, const nlohmann::json& view,
                 const fs::path& directory) {
  const auto& [model, solution, results] = analysed;
  if (!view.is_null()) write_json(directory, "view.json", view);
  if (model.mechanism)
    write_json(directory, "mechanism.json",
               post::mechanism_document(
                   mechanism_picture(*given.mechanism, *model.mechanism, model.mechanism->load)));
  const bool has_pin = report.mechanism && report.mechanism->pin;
  if (fem::has_contact(solution.problem))
    post::write_contact(
        solution, results,
        has_pin ? report.mechanism->pin->line : std::optional<post::PinLineReport>(), given.units,
        directory);
  write_json(directory, "summary.json", post::summary(solution, results, report), 2);
  base::write_text(post::own_file(directory, "case.prm"), given.completed);
}

}  // namespace

AnalysisOutput::AnalysisOutput(const MPI_Comm communicator, const Case& given,
                               const fs::path& directory)
    : communicator_(communicator),
      is_first_(dealii::Utilities::MPI::this_mpi_process(communicator) == 0) {
  model::together(communicator, [&] {
    directory_.emplace(directory, given, "summary", is_first_);
    const double few_unknowns = given.dimension == 2 ? 5e3 : 5e4;  // the least that a case takes
    directory_->check_space(size_of_results(few_unknowns));
  });
}

Written AnalysisOutput::write(const Analysis& analysis, const std::string& log,
                              const std::string& checkpoint) {
  return std::visit(
      [&](const auto& analysed) { return write(analysis, analysed, log, checkpoint); },
      analysis.state->analysed);
}

template <int dim>
Written AnalysisOutput::write(const Analysis& analysis, const AnalysedModel<dim>& analysed,
                              const std::string& log, const std::string& checkpoint) {
  const dealii::Timer timer;
  base::AllocationWatch allocations;
  const Case& given = analysis.given;
  const fs::path& working = directory_->working();
  model::together(communicator_, [&] {
    const double unknowns = analysed.solution.history.back().dofs;
    directory_->check_space(size_of_results(unknowns));
  });
  post::write_fields(analysed.solution, analysed.results, given.units, working);
  const nlohmann::json view = post::view_document(analysed.solution, analysed.results, given.units);
  Written written;
  model::together(communicator_, [&] {
    allocations.require_none();
    if (!is_first_) return;
    post::RunReport report = analysis.state->report;
    report.post_seconds += timer.wall_time();
    report.total_seconds += timer.wall_time();
    write_alone(given, analysed, report, view, working);
    base::write_text(post::own_file(working, "log.txt"), log);
    if (!checkpoint.empty())
      base::write_text(post::own_file(working, "checkpoint.bin"), checkpoint);
    written = directory_->publish();
  });
  return written;
}

}  // namespace geneva::api

namespace geneva {

nlohmann::json summary(const Analysis& analysis) {
  return std::visit(
      [&](const auto& analysed) {
        return post::summary(analysed.solution, analysed.results, analysis.state->report);
      },
      analysis.state->analysed);
}

}  // namespace geneva
