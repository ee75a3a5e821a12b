#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "app/case_file.h"
#include "app/run.h"
#include "app/version.h"
#include "fem/contact_problem.h"

namespace {

/// Exit codes: a wrong case or a machine that cannot run it, a run that did not converge, a bug.
enum ExitCode { wrong_input = 1, not_converged = 2, internal_error = 3 };

int say(const int code, const std::string& text) {
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cerr << "geneva: " << text << '\n';
  return code;
}

int run(const std::string& case_directory, const std::string& output) {
  try {
    return geneva::app::run_case(MPI_COMM_WORLD, case_directory, output);
  } catch (const std::invalid_argument& error) {
    return say(wrong_input, error.what());
  } catch (const geneva::fem::NotConverged& error) {
    return say(not_converged, error.what());
  } catch (const std::runtime_error& error) {
    return say(wrong_input, error.what());  // of the machine: a full disk, a missing unit database
  } catch (const std::exception& error) {
    return say(internal_error, std::string("internal error, please report it: ") + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  setenv("OMP_NUM_THREADS", "1",
         1);  // threads of the linear algebra libraries would fight the MPI ranks
  CLI::App app("Contact stress analysis of Geneva mechanisms", "geneva");
  app.set_version_flag("--version", geneva::app::version);
  app.require_subcommand(1);
  std::string case_directory;
  std::string output;
  auto* run_command = app.add_subcommand("run", "Solve a case and write its results");
  run_command->add_option("CASE_DIR", case_directory, "Directory with a case.prm")->required();
  run_command->add_option("-o,--output", output,
                          "Where the results go (default: CASE_DIR/results)");
  auto* parameters_command = app.add_subcommand(
      "parameters", "Print the whole parameter file with defaults and explanations");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : wrong_input;
  }
  if (parameters_command->parsed()) {
    geneva::app::print_parameters(std::cout);
    return 0;
  }
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  return run(case_directory, output);
}
