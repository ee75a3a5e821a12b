#include <iostream>
#include <string>
#include <variant>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interruption.h"
#include "app/launch.h"
#include "model/input/case_file.h"

namespace {

using namespace geneva::app;
using Command = Request::Command;

int obey(const Request& request) {
  const auto& [command, cases, output, steps, goes_on, is_confirmed] = request;
  if (command == Command::estimate) return estimate_case(cases.front(), output);
  if (command == Command::kinematics) return kinematics_of_case(cases.front(), output, steps);
  if (command == Command::synthesize) return synthesize_case(cases.front(), output);
  if (command == Command::crown) return crown_of_case(cases.front(), output);
  if (command == Command::report) return report_on(cases, output);
  if (command == Command::design) return design_cases(cases, output);
  std::cout << geneva::model::parameter_file();
  return 0;
}

}  // namespace

int main(const int argc, char** const argv) try {
  const auto asked = read_command_line(argc, argv);
  if (const int* const code = std::get_if<int>(&asked)) return with_output_checked(*code);
  const Request& request = std::get<Request>(asked);
  if (request.command == Command::run || request.command == Command::design_with_strength ||
      (request.command == Command::crown && request.is_confirmed))
    become_solver(argv);
  if (!is_launched_as_first_rank()) return 0;
  check_current_directory();
  const std::string task = command_text(argc, argv);
  watch_for_interruption({{}, [] { return true; }});
  watch_for_termination(task);
  return with_output_checked(exit_code_of([&] { return obey(request); }, task, say_failure));
} catch (...) {
  return exit_code_at_start();
}
