#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "fem/gather.h"

namespace geneva::fem::test {
namespace {

struct Record {
  int rank;
  double value;
};

TEST(Gather, PutsTheRanksOneBehindTheOther) {
  int rank = 0;
  int ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<Record> own;  // none of the first rank, one of the second, ...
  for (int i = 0; i < rank; ++i) own.push_back({rank, 10. * rank + i});
  const std::vector<Record> all = gathered(MPI_COMM_WORLD, own);
  ASSERT_EQ(all.size(), static_cast<std::size_t>(ranks * (ranks - 1) / 2));
  std::size_t next = 0;
  for (int of = 0; of < ranks; ++of)
    for (int i = 0; i < of; ++i, ++next) {
      EXPECT_EQ(all[next].rank, of);
      EXPECT_EQ(all[next].value, 10. * of + i);
    }
}

TEST(Gather, OfOneRankGivesBackItsVector) {
  const std::vector<double> own{3., 1., 2.};
  EXPECT_EQ(gathered(MPI_COMM_SELF, own), own);
}

}  // namespace
}  // namespace geneva::fem::test
