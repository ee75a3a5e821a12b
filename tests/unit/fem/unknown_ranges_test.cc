#include "fem/linear/multigrid/unknown_ranges.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <vector>

namespace geneva::fem::test {
namespace {

/// Three times as many unknowns on each rank as ranks before it, so that the first has none.
TEST(UnknownRanges, KnowTheOwnerOfEachUnknown) {
  const auto this_rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const UnknownRanges ranges(static_cast<int>(3 * this_rank), MPI_COMM_WORLD);
  std::vector<unsigned int> owners;
  for (unsigned int rank = 0; rank < ranges.n_ranks(); ++rank)
    owners.insert(owners.end(), std::size_t{3} * rank, rank);
  ASSERT_EQ(ranges.n_all(), static_cast<int>(owners.size()));
  EXPECT_EQ(ranges.n_own(), static_cast<int>(3 * this_rank));
  for (int unknown = 0; unknown < ranges.n_all(); ++unknown) {
    EXPECT_EQ(ranges.owner_of(unknown), owners[static_cast<std::size_t>(unknown)]);
    EXPECT_EQ(ranges.have(unknown), ranges.owner_of(unknown) == this_rank);
  }
  EXPECT_EQ(ranges.own().n_elements(), 3 * this_rank);
}

}  // namespace
}  // namespace geneva::fem::test
