#include "app/optimise.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include "api/optimum_confirmation.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/progress.h"
#include "base/directory_replacement.h"
#include "model/together.h"

namespace geneva::app {

int confirmed_optimum(const MPI_Comm communicator, const std::filesystem::path& case_directory,
                      const std::filesystem::path& output, mesh::Mesher* const mesher) {
  const bool is_first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  const Case given = read_case(case_directory);
  const std::filesystem::path directory = results_of(given.directory, output);
  model::together(communicator, [&] {
    if (is_first) base::check_replaceable(directory);
  });
  ProgressDisplay progress(is_first, given.units);
  int runs = 0;
  Optimum optimum = optimise(given, [&](const Case& candidate) {
    const double stress = slot_bottom_stress(candidate, communicator, mesher);
    progress.phase(fmt::format("{} wheels solved", ++runs));
    return stress;
  });
  progress.phase("solving the best one");
  const bool is_accurate = confirm(optimum, communicator, mesher);
  progress.line(table(optimum));
  Written written;
  model::together(communicator, [&] {
    if (is_first) written = write(optimum, directory);
  });
  tell_written(written, "optimum.json, optimum.csv, optimum.prm and report.html", directory,
               [&](const std::string& line) { progress.line(line); });
  if (is_accurate) return 0;
  progress.line("not converged: the accuracy wanted was not reached");
  return not_converged;
}

}  // namespace geneva::app
