#include "fem/contact/sliding_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace geneva::fem::test {
namespace {

constexpr std::size_t n_nodes = 30;
constexpr double bound = 0.3;  // mu p

/// Nodes on a line that slip by what is imposed less what the friction moves, which reaches from
/// node to node.
struct Slipping {
  ContactInterface<3> interface;
  std::vector<Tangential> imposed;

  explicit Slipping(const unsigned int seed, const double least_slip) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> between(-1., 1.);
    interface.law = std::make_shared<const Coulomb<3>>(bound);
    for (std::size_t i = 0; i < n_nodes; ++i) {
      ContactRow<3> row;
      row.weight = 1.;
      interface.rows.push_back(row);
      interface.status.push_back(NodeStatus::slip);
      const double angle = 3. * between(random);
      interface.sliding.push_back({0., std::cos(angle), std::sin(angle)});
      const double slip = least_slip * (2. + between(random));
      const double along = 0.3 * between(random);
      imposed.push_back({slip * std::cos(along) + bound * moved_by_all(i), slip * std::sin(along)});
    }
  }

  static double compliance(const std::size_t i, const std::size_t j) {
    return 1. / (1. + std::abs(static_cast<double>(i) - static_cast<double>(j)));
  }

  static double moved_by_all(const std::size_t i) {
    double sum = 0.;
    for (std::size_t j = 0; j < n_nodes; ++j) sum += compliance(i, j);
    return sum;
  }

  /// With the directions of now.
  [[nodiscard]] ContactState state() const {
    ContactState state;
    state.approach = moved_by_all(n_nodes / 2);
    for (std::size_t i = 0; i < n_nodes; ++i) {
      state.pressure.push_back(1.);
      state.friction.push_back(
          {-bound * interface.sliding[i][1], -bound * interface.sliding[i][2]});
      state.slip.push_back(imposed[i]);
      for (std::size_t j = 0; j < n_nodes; ++j)
        for (std::size_t t = 0; t < 2; ++t)
          state.slip[i][t] -= bound * compliance(i, j) * interface.sliding[j][t + 1];
    }
    return state;
  }

  /// Maximum angle between slip and direction.
  [[nodiscard]] double misalignment() const {
    const ContactState now = state();
    double most = 0.;
    for (std::size_t i = 0; i < n_nodes; ++i) {
      const double along =
          now.slip[i][0] * interface.sliding[i][1] + now.slip[i][1] * interface.sliding[i][2];
      const double across =
          now.slip[i][1] * interface.sliding[i][1] - now.slip[i][0] * interface.sliding[i][2];
      most = std::max(most, std::abs(std::atan2(across, along)));
    }
    return most;
  }
};

/// Steps until the directions stay; 0: they do not within 200.
int steps_to_settle(Slipping& nodes) {
  SlidingSearch search;
  for (int step = 1; step <= 200; ++step) {
    auto sliding = nodes.interface.sliding;
    const double turn =
        search.advance(nodes.interface, nodes.state(), nodes.interface.status, sliding);
    nodes.interface.sliding = sliding;
    if (turn < 1e-6) return step;
  }
  return 0;
}

TEST(SlidingSearch, FindsTheDirectionsAlongTheSlip) {
  for (const unsigned int seed : {1U, 2U, 3U, 4U, 5U}) {
    Slipping nodes(seed, 0.2);
    const int steps = steps_to_settle(nodes);
    EXPECT_GT(steps, 0);
    EXPECT_LT(steps, 40);
    EXPECT_LT(nodes.misalignment(), 1e-4);
  }
}

TEST(SlidingSearch, SettlesWhereTheSlipIsSmallBesideWhatFrictionMoves) {
  for (const unsigned int seed : {1U, 2U, 3U, 4U, 5U}) {
    Slipping nodes(seed, 0.01);
    const double moved = bound * Slipping::compliance(0, 0);
    ASSERT_LT(0.03, moved);  // the slip's own direction would turn over at each step
    EXPECT_GT(steps_to_settle(nodes), 0);
    EXPECT_LT(nodes.misalignment(), 1e-2);
  }
}

TEST(SlidingSearch, LeavesNodesThatStickOrOpenAlone) {
  Slipping nodes(1, 0.2);
  nodes.interface.status[3] = NodeStatus::stick;
  nodes.interface.status[4] = NodeStatus::open;
  auto sliding = nodes.interface.sliding;
  auto next = nodes.interface.status;
  next[5] = NodeStatus::stick;
  SlidingSearch search;
  search.advance(nodes.interface, nodes.state(), next, sliding);
  for (std::size_t i = 3; i <= 5; ++i) EXPECT_EQ(sliding[i], nodes.interface.sliding[i]);
  EXPECT_NE(sliding[6], nodes.interface.sliding[6]);
}

}  // namespace
}  // namespace geneva::fem::test
