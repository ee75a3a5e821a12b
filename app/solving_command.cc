#include "app/solving_command.h"

#include <deal.II/base/mpi.h>

#include "app/commands.h"
#include "app/exit_code.h"
#include "base/directory_replacement.h"
#include "model/together.h"

namespace geneva::app {

SolvingCommand::SolvingCommand(const MPI_Comm communicator,
                               const std::filesystem::path& case_directory,
                               const std::filesystem::path& output)
    : communicator_(communicator),
      is_first_(dealii::Utilities::MPI::this_mpi_process(communicator) == 0),
      given_(read_case(case_directory)),
      directory_(results_of(given_.directory, output)),
      progress_(is_first_, given_.units) {
  model::together(communicator, [&] {
    if (is_first_) base::check_replaceable(directory_);
  });
}

void SolvingCommand::write(const std::function<Written(const std::filesystem::path&)>& write_into,
                           const std::string& files) {
  Written written;
  progress_.phase("writing the results");
  model::together(communicator_, [&] {
    if (is_first_) written = write_into(directory_);
  });
  tell_written(written, files, directory_, [&](const std::string& line) { progress_.line(line); });
}

int SolvingCommand::end(const bool is_accurate) {
  if (is_accurate) return 0;
  progress_.line("not converged: the accuracy wanted was not reached");
  return not_converged;
}

}  // namespace geneva::app
