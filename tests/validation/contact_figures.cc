#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdio>

#include "tests/support/solving.h"

/// Prints the figures of an unsymmetric line contact with 15 digits: they must not depend on the
/// number of MPI ranks.
int main(int argc, char** argv) {
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using namespace geneva::test;
  LineContact contact;
  contact.turn = 0.17;
  contact.shift = 0.31;
  contact.block_cell = 0.3;
  const auto solution = solve(contact, with_accuracy(0.002));
  if (!prints()) return 0;
  const auto& result = solution.contacts.front();
  std::printf("peak_pressure %.15g\n", result.peak_pressure);
  std::printf("half_width %.15g\n", result.half_width);
  std::printf("max_penetration %.15g\n", result.max_penetration);
  std::printf("error_estimate %.15g\n", solution.error_estimate);
  for (const auto& node : result.nodes)
    if (is_closed(node.status)) std::printf("pressure %.15g\n", node.pressure);
  for (const auto& level : solution.history)
    std::printf("level dofs %u active_nodes %u peak_pressure %.15g\n", level.dofs,
                level.active_nodes, level.peak_pressure);
  return 0;
}
