#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <variant>

#include "app/case_file.h"
#include "app/command_line.h"
#include "app/crown.h"
#include "app/design.h"
#include "app/kinematics.h"
#include "app/report.h"
#include "app/run.h"
#include "app/synthesis.h"
#include "app/threads.h"
#include "fem/contact_problem.h"

namespace {

using geneva::app::Request;

/// A wrong case or a machine that cannot run it, a run that did not converge, a bug.
enum ExitCode { wrong_input = 1, not_converged = 2, internal_error = 3 };

bool is_first_rank() { return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0; }

int say(const int code, const std::string& text) {
  if (is_first_rank()) std::cerr << "geneva: " << text << '\n';
  return code;
}

int obey(const Request& request) {
  using namespace geneva::app;
  using Command = Request::Command;
  const auto& [command, cases, output, steps] = request;
  if (command == Command::run) return run_case(MPI_COMM_WORLD, cases.front(), output);
  if (command == Command::crown) return design_crown(MPI_COMM_WORLD, cases.front(), output);
  if (!is_first_rank()) return 0;
  if (command == Command::synthesize) return synthesize_case(cases.front(), output);
  if (command == Command::kinematics) return kinematics_of_case(cases.front(), output, steps);
  if (command == Command::report) return make_report(cases, output);
  return design_cases(cases, output);
}

int guarded(const Request& request) {
  try {
    return obey(request);
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

int main(int argc, char** argv) try {
  geneva::app::use_one_thread();
  const auto asked = geneva::app::read_command_line(argc, argv);
  if (const int* code = std::get_if<int>(&asked)) return *code;
  const Request& request = std::get<Request>(asked);
  if (request.command == Request::Command::parameters) {
    geneva::app::print_parameters(std::cout);
    return 0;
  }
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  return guarded(request);
} catch (const std::exception& error) {
  std::cerr << "geneva: cannot start: " << error.what() << '\n';
  return internal_error;
}
