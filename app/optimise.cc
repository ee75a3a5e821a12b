#include "app/optimise.h"

#include <fmt/format.h>

#include "api/optimum_confirmation.h"
#include "app/solving_command.h"
#include "base/errors.h"

namespace geneva::app {

namespace {

/// Whether the best case is solved as accurately as asked; what stands in the way is told, and the
/// closed forms remain.
bool is_confirmed(Optimum& optimum, const MPI_Comm communicator, mesh::Mesher* const mesher,
                  ProgressDisplay& progress) {
  try {
    return confirm(optimum, communicator, mesher, progress.watch());
  } catch (const base::InputError& error) {
    progress.warning(fmt::format("the best case could not be solved: {}", error.what()));
    return false;
  }
}

}  // namespace

int confirmed_optimum(const MPI_Comm communicator, const std::filesystem::path& case_directory,
                      const std::filesystem::path& output, mesh::Mesher* const mesher) {
  SolvingCommand command(communicator, case_directory, output);
  ProgressDisplay& progress = command.progress();
  int runs = 0;
  const auto slot_bottom = [&](const Case& candidate) {
    const double stress = slot_bottom_stress(candidate, communicator, mesher);
    progress.phase(fmt::format("{} wheels solved", ++runs));
    return stress;
  };
  const auto tell = [&](const int trials) {
    if (runs == 0) progress.phase(fmt::format("{} candidates worked out", trials));
  };
  Optimum optimum = optimise(command.given(), slot_bottom, tell);
  progress.phase("solving the best one");
  const bool is_accurate = is_confirmed(optimum, communicator, mesher, progress);
  progress.line(table(optimum));
  command.write([&](const std::filesystem::path& directory) { return write(optimum, directory); },
                "optimum.json, optimum.csv, optimum.prm and report.html");
  return command.end(is_accurate);
}

}  // namespace geneva::app
