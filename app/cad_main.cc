#include <string>
#include <variant>

#include "app/command_line.h"
#include "app/exit_code.h"
#include "app/export.h"
#include "app/interruption.h"
#include "app/launch.h"

/// What geneva becomes to write drawings: the CAD kernel takes longer to start than most commands
/// to run.
int main(const int argc, char** const argv) try {
  using namespace geneva::app;
  const auto asked = read_command_line(argc, argv);
  if (const int* const code = std::get_if<int>(&asked)) return with_output_checked(*code);
  const Request& request = std::get<Request>(asked);
  if (!is_launched_as_first_rank()) return 0;
  check_current_directory();
  const std::string task = command_text(argc, argv);
  watch_for_interruption({{}, [] { return true; }});
  watch_for_termination(task);
  return with_output_checked(exit_code_of(
      [&] { return export_case(request.cases.front(), request.output, request.angle); }, task,
      say_failure));
} catch (...) {
  return geneva::app::exit_code_at_start();
}
