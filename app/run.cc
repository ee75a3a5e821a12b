#include "app/run.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <fmt/format.h>

#include <algorithm>

#include "api/analysis.h"
#include "api/analysis_output.h"
#include "api/checkpoint_file.h"
#include "app/checkpoint_keeper.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/progress.h"

namespace geneva::app {

namespace fs = std::filesystem;

namespace {

std::string command_to_continue(const fs::path& case_directory, const RunRequest& request) {
  return fmt::format("geneva run --continue {}{}", case_directory.string(),
                     request.output.empty() ? "" : " --output " + request.output.string());
}

/// @param left note on an earlier run that did not end; empty if there is none
void show_start(const AnalysisStart& start, const std::string& left, ProgressDisplay& progress) {
  progress.line(start.heading);
  for (const std::string& notice : start.notices) progress.line("note: " + notice);
  if (!left.empty()) progress.line("note: " + left);
  if (start.earlier.empty()) return;
  progress.line(fmt::format("continues from a mesh of {} unknowns", start.earlier.back().dofs));
  for (const fem::LevelRecord& level : start.earlier) progress.level(level);
}

/// Whether a check failed, other than that of the accuracy, which the shortfall tells.
bool is_failed(const post::Check& check) {
  return !check.is_passed() && check.name != "convergence";
}

/// What the user should know of the solution, then the table.
/// @param told notices that the user knows already
void present(const Analysis& analysis, const std::size_t told, ProgressDisplay& progress) {
  for (std::size_t i = told; i < analysis.notices.size(); ++i)
    progress.line("note: " + analysis.notices[i]);
  for (const post::Check& check : analysis.checks)
    if (is_failed(check))
      progress.line(fmt::format("note: the check '{}' failed ({}): {:.2g}, at most {:.2g} is sound",
                                check.name, check.meaning, check.value, check.limit));
  if (!analysis.shortfall.empty()) progress.warning(analysis.shortfall);
  progress.line("\n" + analysis.table);
}

/// How much longer the files take than the figures that stand in them: 4.3 times with 620 000
/// unknowns in the plane, 1.4 and 2.1 times with 930 000 and 500 000 in 3-D.
double writing_over_working_out(const int dimension) { return dimension == 2 ? 4. : 2.; }

Checkpointing checkpointing(CheckpointKeeper& keeper, const dealii::Timer& total,
                            ProgressDisplay& progress) {
  const auto keep = [&](std::string text) {
    const std::string trouble = keeper.keep(std::move(text));
    if (!trouble.empty()) progress.warning("note: " + trouble);
  };
  return {keeper.last(), keeper.is_wanted(), [&] { return keeper.is_due(total.wall_time()); },
          keep};
}

}  // namespace

int run_case(const MPI_Comm communicator, const fs::path& case_directory, const RunRequest& request,
             mesh::Mesher* const mesher) {
  const dealii::Timer total;
  const bool is_first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  const Case given = read_case(case_directory);
  const fs::path directory = results_of(given.directory, request.output);
  const std::string command = command_to_continue(given.directory, request);
  api::AnalysisOutput output(communicator, given, directory);
  const std::string saved =
      request.is_continued ? api::read_checkpoint(communicator, directory, given) : "";
  CheckpointKeeper checkpoints(given, directory, saved, command);
  const std::string left = request.is_continued ? "" : notice_of_unfinished(directory, command);
  ProgressDisplay progress(is_first, given.units);
  std::size_t told = 0;
  AnalysisOptions options;
  options.progress = progress.watch();
  options.mesher = mesher;
  options.checkpoints = checkpointing(checkpoints, total, progress);
  options.progress.start = [&](const AnalysisStart& start) {
    show_start(start, left, progress);
    told = start.notices.size();
  };

  progress.phase("meshing");
  const Analysis analysis = analyse(given, communicator, options);
  present(analysis, told, progress);
  progress.work({fem::Work::writing, analysis.meshes.back().dofs},
                writing_over_working_out(given.dimension));
  const Written written = output.write(analysis, progress.log(), checkpoints.last());
  if (is_first) checkpoints.remove(analysis.is_converged);
  warn_of_missing_packages(written);
  if (const std::string notice = removal_notice(written); !notice.empty()) progress.line(notice);
  progress.line(fmt::format("results in {}, report.html to look at ({:.2f} s, {:.0f} MB)",
                            shown_path(directory), total.wall_time(), analysis.memory / 1e6));
  if (analysis.is_converged) {
    const auto& checks = analysis.checks;
    return std::any_of(checks.begin(), checks.end(), is_failed) ? not_converged : 0;
  }
  if (const std::string advice = checkpoints.advice(); !advice.empty())
    progress.line(advice + ", with other limits or another accuracy");
  return not_converged;
}

}  // namespace geneva::app
