#include "fem/holding_nodes.h"

#include <gtest/gtest.h>

#include "tests/unit/fem/flat_pair.h"

namespace geneva::fem::test {
namespace {

constexpr NodeStatus stick = NodeStatus::stick;

/// A level with one contact that holds its source.
Level<2> held_by(const Status& status) {
  Level<2> level;
  level.interfaces.push_back(with_status(status));
  level.holds_by_contact = {true};
  level.is_held_by_friction = true;
  level.holds_by_friction = {true};
  return level;
}

/// With friction that may stick, of nodes that slide along x or against it.
Level<2> held_by_friction(const Status& status, const std::vector<double>& sliding) {
  Level<2> level = held_by(status);
  ContactInterface<2>& interface = level.interfaces.front();
  interface.law = std::make_shared<const Coulomb<2>>(0.1);
  for (std::size_t i = 0; i < status.size(); ++i) {
    const double along_x = interface.rows[i].frame.tangents[0][0];
    interface.sliding.push_back({0., along_x * sliding[i]});
  }
  return level;
}

/// Slip and friction along x.
ContactState state_along_x(const Level<2>& level, const std::vector<double>& pressure,
                           const std::vector<double>& slip_x,
                           const std::vector<double>& friction_x) {
  ContactState state = without_slip(pressure, std::vector<double>(pressure.size(), 0.), 1.);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const double along_x = level.interfaces.front().rows[i].frame.tangents[0][0];
    state.slip[i] = {along_x * slip_x[i], 0.};
    state.friction[i] = {along_x * friction_x[i], 0.};
  }
  return state;
}

TEST(HoldingNodes, ANodeAheadClosesWhereAllWouldOpen) {
  Level<2> level = held_by({open, slip, slip, open});
  level.interfaces.front().rows[3].frame = frame_along(dealii::Point<2>(0., -1.));
  const std::vector<ContactState> states{without_slip({0., -2., -1., 0.}, {0.5, 0., 0., 0.5}, 1.)};
  ActiveSets next{{open, open, open, open}};
  EXPECT_FALSE(keep_one_closed(level, states, next));
  EXPECT_EQ(next.front(), (Status{open, open, open, slip})) << "on the other side";
}

TEST(HoldingNodes, TheNodeThatIsPulledLeastStaysClosedWhereNoneLiesAhead) {
  const Level<2> level = held_by({open, slip, slip, open});
  const std::vector<ContactState> states{without_slip({0., -2., -1., 0.}, {0.5, 0., 0., 0.5}, 1.)};
  ActiveSets next{{open, open, open, open}};
  EXPECT_TRUE(keep_one_closed(level, states, next)) << "the load pulls the bodies apart";
  EXPECT_EQ(next.front(), (Status{open, open, slip, open}));
}

TEST(HoldingNodes, AreLeftAloneWhereAnotherTouchesOrNothingIsHeld) {
  Level<2> level = held_by({open, slip, slip, open});
  const std::vector<ContactState> states{without_slip({0., -2., -1., 0.}, {0.5, 0., 0., 0.5}, 1.)};
  ActiveSets next{{open, open, slip, open}};
  EXPECT_FALSE(keep_one_closed(level, states, next));
  EXPECT_EQ(next.front(), (Status{open, open, slip, open}));
  level.holds_by_contact = {false};
  next = {{open, open, open, open}};
  EXPECT_FALSE(keep_one_closed(level, states, next));
  EXPECT_EQ(next.front(), (Status{open, open, open, open}));
}

TEST(HoldingNodes, TheNodeThatTurnsFirstSticksInPlaceOfOneThatCarriesTooMuch) {
  const Level<2> level = held_by_friction({slip, stick, slip, slip}, {-1., 0., 1., 1.});
  // pushed along x: what sticks is held back, what slides along x is not in the way
  const std::vector<ContactState> states{
      state_along_x(level, {1., 1., 1., 1.}, {-0.2, 0., 0.1, 0.3}, {0.1, -0.2, -0.1, -0.1})};
  ActiveSets next{{slip, slip, slip, slip}};
  EXPECT_FALSE(keep_one_stuck(level, states, next));
  EXPECT_EQ(next.front(), (Status{stick, slip, slip, slip})) << "the only one that slides back";
}

TEST(HoldingNodes, NothingHoldsABodyWhereAllFrictionPointsOneWay) {
  const Level<2> level = held_by_friction({slip, stick, slip, slip}, {1., 0., 1., 1.});
  const std::vector<ContactState> states{
      state_along_x(level, {1., 1., 1., 1.}, {0.2, 0., 0.1, 0.3}, {-0.1, -0.2, -0.1, -0.1})};
  ActiveSets next{{slip, slip, slip, slip}};
  EXPECT_TRUE(keep_one_stuck(level, states, next));
  EXPECT_EQ(next.front(), (Status{slip, stick, slip, slip}));
}

TEST(HoldingNodes, OfSeveralThatWantToSlideTheOneNearestToStickingIsKept) {
  const Level<2> level = held_by_friction({slip, stick, stick, slip}, {-1., 0., 0., 1.});
  const std::vector<ContactState> states{
      state_along_x(level, {1., 1., 2., 1.}, {-0.2, 0., 0., 0.3}, {0.1, -0.2, -0.3, -0.1})};
  ActiveSets next{{slip, slip, slip, slip}};
  EXPECT_TRUE(keep_one_stuck(level, states, next));
  EXPECT_EQ(next.front(), (Status{slip, slip, stick, slip}));
}

}  // namespace
}  // namespace geneva::fem::test
