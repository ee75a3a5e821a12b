#include "app/cycle.h"

#include <fmt/format.h>

#include "api/cycle.h"
#include "api/load_history.h"
#include "app/pace.h"
#include "app/solving_command.h"

namespace geneva::app {

namespace {

int cycle_of_mechanism(const MPI_Comm communicator, SolvingCommand& command,
                       mesh::Mesher* const mesher) {
  ProgressDisplay& progress = command.progress();
  const Pace pace;
  progress.phase("solving the first instants");
  const auto tell = [&](const post::CyclePoint& point, const std::size_t done,
                        const std::size_t of) {
    progress.line(fmt::format("instant {} of {}: {}{}", done, of,
                              post::instant_in_words(point.instant), pace.time_left(done, of)));
    if (done < of) progress.phase("solving the next instants");
  };
  const Cycle found = cycle(command.given(), communicator, mesher, tell);
  for (const std::string& notice : found.report.notices) progress.line("note: " + notice);
  progress.line("\n" + table(found));
  command.write([&](const std::filesystem::path& directory) { return write(found, directory); },
                "cycle.json, cycle.csv and report.html");
  return command.end(found.is_converged);
}

int cycle_of_geometry(const MPI_Comm communicator, SolvingCommand& command,
                      mesh::Mesher* const mesher) {
  ProgressDisplay& progress = command.progress();
  Progress watch = progress.watch();
  watch.start = [&](const AnalysisStart& start) { progress.line(start.heading); };
  progress.phase("meshing");
  const LoadHistory found = load_history(command.given(), communicator, mesher, watch);
  for (const std::string& notice : found.report.notices) progress.line("note: " + notice);
  progress.line("\n" + table(found));
  command.write(
      [&](const std::filesystem::path& directory) { return write(found, directory); },
      "load_steps.json, load_steps.csv, load_steps.pvd, load_steps_envelope.vtu and report.html");
  return command.end(found.is_converged);
}

}  // namespace

int cycle_of_case(const MPI_Comm communicator, const std::filesystem::path& case_directory,
                  const std::filesystem::path& output, mesh::Mesher* const mesher) {
  SolvingCommand command(communicator, case_directory, output);
  return command.given().geometry ? cycle_of_geometry(communicator, command, mesher)
                                  : cycle_of_mechanism(communicator, command, mesher);
}

}  // namespace geneva::app
