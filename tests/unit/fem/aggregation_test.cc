#include "fem/linear/multigrid/aggregation.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

namespace geneva::fem::test {
namespace {

using Neighbours = std::vector<std::vector<int>>;

/// Two square grids of n x n nodes, coupled as by quadrilateral cells, the second on the first: the
/// nodes of the first one's last row are coupled to those of the second one's first row.
struct Grids {
  explicit Grids(const int n) : neighbours(static_cast<std::size_t>(2 * n * n)) {
    for (int row = 0; row < 2 * n; ++row)
      for (int column = 0; column < n; ++column) {
        bodies.push_back(row < n ? 0 : 1);
        for (int other_row = 0; other_row < 2 * n; ++other_row)
          for (int other = 0; other < n; ++other)
            if (std::abs(other_row - row) <= 1 && std::abs(other - column) <= 1 &&
                (other_row != row || other != column))
              neighbours[bodies.size() - 1].push_back(other_row * n + other);
      }
  }

  Neighbours neighbours;
  std::vector<unsigned int> bodies;
};

/// A chain of nodes of one body: 0 begins with 1, 3 with its neighbours, 6 too; 8 has nobody left.
TEST(Aggregates, OfAChainHaveThreeNodesAndTheLastOneWhatIsLeft) {
  Neighbours chain(9);
  for (int i = 0; i < 9; ++i)
    for (const int other : {i - 1, i + 1})
      if (0 <= other && other < 9) chain[static_cast<std::size_t>(i)].push_back(other);
  const Aggregates aggregates = aggregate(chain, std::vector<unsigned int>(9, 7), 2);
  EXPECT_EQ(aggregates.of_nodes, (std::vector<int>{0, 0, 1, 1, 1, 2, 2, 2, 2}));
  EXPECT_EQ(aggregates.bodies, (std::vector<unsigned int>{7, 7, 7}));
}

TEST(Aggregates, HoldEveryCoupledNodeAndNodesOfOneBody) {
  const Grids grids(10);
  const Aggregates aggregates = aggregate(grids.neighbours, grids.bodies, 2);
  std::set<int> seen;
  for (std::size_t node = 0; node < grids.bodies.size(); ++node) {
    const int number = aggregates.of_nodes[node];
    ASSERT_NE(number, no_aggregate) << node;
    EXPECT_EQ(aggregates.bodies.at(static_cast<std::size_t>(number)), grids.bodies[node]);
    seen.insert(number);
  }
  EXPECT_EQ(seen.size(), aggregates.bodies.size());
  EXPECT_EQ(*seen.begin(), 0);
  EXPECT_LT(seen.size(), grids.bodies.size() / 6);
}

TEST(Aggregates, LeaveOutNodesWithoutNeighbours) {
  const Aggregates aggregates = aggregate({{1}, {0}, {}}, {0, 0, 0}, 1);
  EXPECT_EQ(aggregates.of_nodes, (std::vector<int>{0, 0, no_aggregate}));
}

/// On the edge of a rank a node may be coupled to the other body only, or to itself in this list.
TEST(Aggregates, OfANodeWithoutNeighboursInItsBodyIsThatNode) {
  const Aggregates aggregates = aggregate({{1}, {0}, {2}}, {0, 1, 0}, 1);
  EXPECT_EQ(std::set<int>(aggregates.of_nodes.begin(), aggregates.of_nodes.end()),
            (std::set<int>{0, 1, 2}));
}

TEST(Aggregates, OfOneNodeAreLeftOutWhereTwoAreTheLeast) {
  const Aggregates aggregates = aggregate({{1}, {0}, {3}, {2}}, {0, 1, 0, 0}, 2);
  EXPECT_EQ(aggregates.of_nodes, (std::vector<int>{no_aggregate, no_aggregate, 0, 0}));
  EXPECT_EQ(aggregates.bodies, std::vector<unsigned int>{0});
}

}  // namespace
}  // namespace geneva::fem::test
