#include "app/crown.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include "api/crown.h"
#include "api/crown_confirmation.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/progress.h"
#include "base/directory_replacement.h"
#include "model/together.h"

namespace geneva::app {

int confirmed_crown_of_case(const MPI_Comm communicator,
                            const std::filesystem::path& case_directory,
                            const std::filesystem::path& output, mesh::Mesher* const mesher) {
  const bool is_first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  const Case given = read_case(case_directory);
  const std::filesystem::path directory = results_of(given.directory, output);
  model::together(communicator, [&] {
    if (is_first) base::check_replaceable(directory);
  });
  const base::OutputUnit length = base::output_unit(given.units, base::Dimension::length);
  ProgressDisplay progress(is_first, given.units);
  Crown crown = design_crown(given);
  progress.line(fmt::format("{} {:.4g} {} found in {} trials; solving it by finite elements",
                            crown.report.parameter, crown.report.size * length.factor, length.name,
                            crown.report.trials.size()));
  const bool is_accurate = confirm(crown, communicator, mesher);
  progress.line("\n" + table(crown));
  Written written;
  model::together(communicator, [&] {
    if (is_first) written = write(crown, directory);
  });
  tell_written(written, "crown.json, crown.csv and report.html", directory,
               [&](const std::string& line) { progress.line(line); });
  if (is_accurate) return 0;
  progress.line("not converged: the accuracy wanted was not reached");
  return not_converged;
}

}  // namespace geneva::app
