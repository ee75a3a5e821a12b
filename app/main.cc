#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <variant>

#include "app/command_line.h"
#include "app/crown.h"
#include "app/design.h"
#include "app/early_mesher.h"
#include "app/ending.h"
#include "app/exit_code.h"
#include "app/interruption.h"
#include "app/kinematics.h"
#include "app/launch.h"
#include "app/report.h"
#include "app/run.h"
#include "app/synthesis.h"
#include "app/threads.h"
#include "mesh/mesher.h"
#include "model/input/case_file.h"

namespace {

using geneva::app::Request;
using geneva::mesh::Mesher;

bool is_first_rank() { return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0; }

int obey(const Request& request, std::optional<Mesher>& mesher) {
  using namespace geneva::app;
  using Command = Request::Command;
  const auto& [command, cases, output, steps, goes_on] = request;
  if (is_first_rank()) start_if_needed(request, mesher);
  if (command == Command::run)
    return run_case(MPI_COMM_WORLD, cases.front(), {output, goes_on}, mesher);
  if (command == Command::crown) return design_crown(MPI_COMM_WORLD, cases.front(), output, mesher);
  if (!is_first_rank()) return 0;
  if (command == Command::synthesize) return synthesize_case(cases.front(), output);
  if (command == Command::kinematics) return kinematics_of_case(cases.front(), output, steps);
  if (command == Command::report) return make_report(cases, output);
  return design_cases(cases, output);
}

}  // namespace

int main(int argc, char** argv) try {
  geneva::app::use_one_thread();
  const auto asked = geneva::app::read_command_line(argc, argv);
  if (const int* code = std::get_if<int>(&asked)) return geneva::app::with_output_checked(*code);
  const Request& request = std::get<Request>(asked);
  geneva::app::check_that_mpi_can_start();
  const std::string task = geneva::app::command_text(argc, argv);
  geneva::app::watch_for_interruption();
  geneva::app::watch_for_termination(task);
  if (request.command == Request::Command::parameters) {
    std::cout << geneva::model::parameter_file();
    return geneva::app::with_output_checked(0);
  }
  std::optional<Mesher> mesher = geneva::app::early_mesher(request);  // gets ready while MPI does
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  geneva::app::start_task_scheduler();
  dealii::deal_II_exceptions::disable_abort_on_exception();
  geneva::app::Ending ending(MPI_COMM_WORLD);
  return geneva::app::with_output_checked(
      geneva::app::exit_code_of([&] { return obey(request, mesher); }, task, ending));
} catch (...) {
  return geneva::app::exit_code_at_start();
}
