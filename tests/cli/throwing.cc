// A program that does nothing but fail as it is told, with geneva's own ending:
//   throwing KIND RANK
// where all ranks but one go on to wait for each other, as in a computation; RANK all: all fail.

#include <deal.II/base/mpi.h>

#include <string>

#include "app/ending.h"
#include "app/exit_code.h"
#include "app/interruption.h"
#include "app/other_ranks.h"
#include "fem/problem/stop.h"
#include "tests/cli/failure_kinds.h"

namespace {

void fail(const std::string& kind) {
  if (kind == "not converged") throw geneva::fem::NotConverged({geneva::fem::Outcome::no_progress});
  failure_kinds().at(kind)();
}

}  // namespace

int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
  if (argc != 3) return 1;
  const std::string kind = argv[1];
  const std::string failing = argv[2];
  geneva::app::watch_for_interruption(geneva::app::other_ranks());
  geneva::app::watch_for_termination("throwing");
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  geneva::app::Ending ending(MPI_COMM_WORLD);
  const auto command = [&] {
    const auto rank = std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
    if (failing == "all" || failing == rank) fail(kind);
    MPI_Barrier(MPI_COMM_WORLD);
    return 0;
  };
  return geneva::app::exit_code_of(
      command, "throwing",
      [&](const int code, const std::string& text) { ending.fail(code, text); });
}
