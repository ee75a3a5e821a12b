#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "fem/discretisation/gather.h"

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

TEST(Gather, OnTheFirstRankLeavesTheOthersNothing) {
  int rank = 0;
  int ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::vector<int> all = gathered_on_first(MPI_COMM_WORLD, std::vector<int>{rank, -rank});
  ASSERT_EQ(all.size(), rank == 0 ? static_cast<std::size_t>(2 * ranks) : 0U);
  for (std::size_t i = 0; i < all.size(); i += 2) {
    EXPECT_EQ(all[i], static_cast<int>(i / 2));
    EXPECT_EQ(all[i + 1], -static_cast<int>(i / 2));
  }
}

TEST(Gather, KeepsTheTextsOfTheRanksApart) {
  int rank = 0;
  int ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const auto text_of = [](const int of) { return std::string(static_cast<std::size_t>(of), 'x'); };
  const std::vector<std::string> texts = gathered_texts(MPI_COMM_WORLD, text_of(rank));
  ASSERT_EQ(texts.size(), static_cast<std::size_t>(ranks));
  for (int of = 0; of < ranks; ++of) EXPECT_EQ(texts[static_cast<std::size_t>(of)], text_of(of));
}

TEST(Gather, OfOneRankGivesBackItsVector) {
  const std::vector<double> own{3., 1., 2.};
  EXPECT_EQ(gathered(MPI_COMM_SELF, own), own);
}

}  // namespace
}  // namespace geneva::fem::test
