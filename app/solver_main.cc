#include <string>
#include <variant>

#include "api/session.h"
#include "app/command_line.h"
#include "app/crown.h"
#include "app/cycle.h"
#include "app/design_strength.h"
#include "app/early_mesher.h"
#include "app/ending.h"
#include "app/exit_code.h"
#include "app/interruption.h"
#include "app/launch.h"
#include "app/optimise.h"
#include "app/other_ranks.h"
#include "app/run.h"
#include "app/surfaces.h"
#include "app/worker.h"
#include "app/workers.h"

namespace {

using namespace geneva::app;
using Command = Request::Command;

int obey(const Request& request, geneva::mesh::Mesher* const mesher) {
  const std::filesystem::path& directory = request.cases.front();
  if (request.command == Command::crown)
    return confirmed_crown_of_case(MPI_COMM_WORLD, directory, request.output, mesher);
  if (request.command == Command::cycle)
    return cycle_of_case(MPI_COMM_WORLD, directory, request.output, mesher);
  if (request.command == Command::surfaces)
    return surfaces_of_case(directory, request.output, mesher);
  if (request.command == Command::optimise)
    return confirmed_optimum(MPI_COMM_WORLD, directory, request.output, mesher);
  if (request.command == Command::design_with_strength)
    return design_with_strength(MPI_COMM_WORLD, directory, request.output, mesher);
  return run_case(MPI_COMM_WORLD, directory, {request.output, request.is_continued}, mesher);
}

/// Solves what another process asks for, until it ends this one or asks no more.
int worker(int argc, char** argv) {
  std::FILE* const replies = take_replies();
  check_address_space();
  watch_for_interruption(other_ranks());
  watch_for_termination("run");
  EarlyMesher mesher;
  const geneva::Session session(argc, argv);
  const Ending ending(MPI_COMM_WORLD);
  return work(replies, [&](const std::filesystem::path& directory) {
    return run_case(MPI_COMM_WORLD, directory, {}, mesher.on_rank_zero());
  });
}

}  // namespace

/// What geneva becomes for a contact analysis; the command line is the same.
int main(int argc, char** argv) try {
  if (argc == 2 && std::string(argv[1]) == worker_word) return worker(argc, argv);
  const auto asked = read_command_line(argc, argv);
  if (const int* const code = std::get_if<int>(&asked)) return with_output_checked(*code);
  const Request& request = std::get<Request>(asked);
  check_address_space();
  check_current_directory();
  const std::string task = command_text(argc, argv);
  watch_for_interruption(other_ranks());
  watch_for_termination(task);
  EarlyMesher mesher;  // gets ready while MPI does
  const geneva::Session session(argc, argv);
  Ending ending(MPI_COMM_WORLD);
  const auto fail = [&](const int code, const std::string& text) { ending.fail(code, text); };
  return with_output_checked(
      exit_code_of([&] { return obey(request, mesher.on_rank_zero()); }, task, fail));
} catch (...) {
  return geneva::app::exit_code_at_start();
}
