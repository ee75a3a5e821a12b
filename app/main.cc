#include <iostream>
#include <string>
#include <variant>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/init.h"
#include "app/interruption.h"
#include "app/launch.h"
#include "app/materials.h"
#include "app/sweep.h"
#include "model/input/case_file.h"

namespace {

using namespace geneva::app;
using Command = Request::Command;

/// Of init: a type of two words as one.
std::string type_of(const std::string& word) { return word == "long-dwell" ? "long dwell" : word; }

int obey(const Request& request) {
  const std::filesystem::path& directory = request.cases.front();
  switch (request.command) {
    case Command::estimate:
      return estimate_case(directory, request.output);
    case Command::kinematics:
      return kinematics_of_case(directory, request.output, request.steps);
    case Command::synthesize:
      return synthesize_case(directory, request.output);
    case Command::crown:
      return crown_of_case(directory, request.output);
    case Command::report:
      return report_on(request.cases, request.output);
    case Command::design:
      return design_cases(request.cases, request.output);
    case Command::sweep:
      return sweep_case(directory,
                        {request.variations, request.method, request.jobs, request.output});
    case Command::init:
      return init_case(directory, {type_of(request.type), request.stations,
                                   geneva::base::unit_system_named(request.units)});
    case Command::materials:
      return show_materials(request.topic, directory);
    default:
      std::cout << geneva::model::parameter_file();
      return 0;
  }
}

}  // namespace

int main(const int argc, char** const argv) try {
  const auto asked = read_command_line(argc, argv);
  if (const int* const code = std::get_if<int>(&asked)) return with_output_checked(*code);
  const Request& request = std::get<Request>(asked);
  if (request.command == Command::run || request.command == Command::cycle ||
      request.command == Command::optimise || request.command == Command::surfaces ||
      request.command == Command::design_with_strength ||
      (request.command == Command::crown && request.is_confirmed))
    become("geneva-solver", argv);
  if (request.command == Command::export_drawings) become("geneva-cad", argv);
  if (!is_launched_as_first_rank()) return 0;
  check_current_directory();
  const std::string task = command_text(argc, argv);
  watch_for_interruption({{}, [] { return true; }});
  watch_for_termination(task);
  return with_output_checked(exit_code_of([&] { return obey(request); }, task, say_failure));
} catch (...) {
  return exit_code_at_start();
}
