#include "app/crown.h"

#include <fmt/format.h>

#include "api/crown.h"
#include "api/crown_confirmation.h"
#include "app/solving_command.h"

namespace geneva::app {

int confirmed_crown_of_case(const MPI_Comm communicator,
                            const std::filesystem::path& case_directory,
                            const std::filesystem::path& output, mesh::Mesher* const mesher) {
  SolvingCommand command(communicator, case_directory, output);
  const base::OutputUnit length = base::output_unit(command.given().units, base::Dimension::length);
  Crown crown = design_crown(command.given());
  command.progress().line(fmt::format("{} {:.4g} {} found in {} trials", crown.report.parameter,
                                      crown.report.size * length.factor, length.name,
                                      crown.report.trials.size()));
  command.progress().phase("solving it by finite elements");
  const bool is_accurate = confirm(crown, communicator, mesher, command.progress().watch());
  command.progress().line("\n" + table(crown));
  command.write([&](const std::filesystem::path& directory) { return write(crown, directory); },
                "crown.json, crown.csv and report.html");
  return command.end(is_accurate);
}

}  // namespace geneva::app
