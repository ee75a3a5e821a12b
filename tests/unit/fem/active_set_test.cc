#include "fem/contact/active_set.h"

#include <gtest/gtest.h>

#include "fem/contact/zone.h"
#include "tests/unit/fem/flat_pair.h"

namespace geneva::fem::test {
namespace {

TEST(ActiveSet, FirstTouchIsTheSmallestGap) {
  ContactInterface<2> interface = flat_pair(4);
  for (const double lift : {0., 0.3, -2.}) {
    for (ContactRow<2>& row : interface.rows)
      row.initial_gap = row.weight * (lift + (row.node == 2 || row.node == 3 ? 0. : 0.1));
    EXPECT_EQ(first_touch(interface), (Status{open, open, slip, slip, open}));
  }
}

TEST(ActiveSet, FirstTouchIsAlongTheApproach) {
  ContactInterface<2> interface = flat_pair(2);
  const double root = std::sqrt(0.5);
  const std::vector<dealii::Tensor<1, 2>> normals{
      dealii::Point<2>(1., 0.), dealii::Point<2>(root, root), dealii::Point<2>(0., 1.)};
  const std::vector<double> gaps{-0.1, 0.2, 0.3};
  for (std::size_t i = 0; i < 3; ++i) {
    interface.rows[i].frame = frame_along(normals[i]);
    interface.rows[i].initial_gap = interface.rows[i].weight * gaps[i];
  }
  EXPECT_EQ(first_touch(interface), (Status{slip, open, open})) << "not known";
  interface.approach = dealii::Point<2>(0., -1.);
  EXPECT_EQ(first_touch(interface), (Status{open, slip, open}))
      << "the first never closes, the second after 0.28";
  interface.approach = dealii::Point<2>(0., 1.);
  EXPECT_EQ(first_touch(interface), (Status{slip, open, open})) << "away from all";
}

TEST(ActiveSet, IntervalsReachFromFirstToLastActiveNode) {
  const auto intervals = zone_intervals(with_status({slip, slip, open, open, slip}));
  ASSERT_EQ(intervals.size(), 2U);
  EXPECT_EQ(intervals[0], (std::pair{0., 0.25}));
  EXPECT_EQ(intervals[1], (std::pair{1., 1.}));
  EXPECT_TRUE(zone_intervals(with_status({open, open})).empty());
}

TEST(ActiveSet, IsInheritedByTheNodesWithinTheContactOfTheCoarserMesh) {
  const Status fine = inherited(flat_pair(8), {{0.25, 0.5, false}}, 1.);
  EXPECT_EQ(fine, (Status{open, open, slip, slip, slip, open, open, open, open}));
  EXPECT_EQ(inherited(flat_pair(8), {{0.5, 1., false}}, 2.), fine) << "on a mesh in units of 2 m";
}

/// Rows with nodes at these places.
ContactInterface<3> nodes_at(const std::vector<dealii::Point<3>>& places) {
  ContactInterface<3> interface;
  for (unsigned int i = 0; i < places.size(); ++i) {
    interface.source.nodes.push_back({places[i], {}, {}, 0.});
    interface.rows.push_back({i, 1., {}, 0., {}});
  }
  return interface;
}

TEST(ActiveSet, InSpaceIsInheritedByNodesBetweenActiveOnesOnly) {
  std::vector<ContactNode<3>> coarse(4);
  for (unsigned int i = 0; i < 4; ++i) {
    coarse[i].position = {{i % 2 == 0 ? 0. : 2., 0., i < 2 ? 0. : 6.}};
    coarse[i].status = i != 3 ? slip : open;
  }
  // between two active corners of a face, between an active one and the other, in the middle
  const Status expected{slip, slip, open, open, slip, slip, open};
  for (const double round_off : {-1e-15, 0., 1e-15})
    EXPECT_EQ(inherited(nodes_at({{0.5, 0., 0.},
                                  {0.5 + round_off, 0., 0.},
                                  {0.5 + round_off, 0., 3.},
                                  {0.5, 0., 1.5 + round_off},
                                  {0., 0., 1.5 + round_off},
                                  {0.1, 0., 2.9},
                                  {1., 0., 2.9}}),
                        coarse, 2.),
              expected)
        << round_off;
}

TEST(ActiveSet, InSpaceIsFirstTouchWhereNothingIsInherited) {
  ContactInterface<3> interface = nodes_at({{0., 0., 0.}, {1., 0., 0.}});
  interface.rows[1].initial_gap = -0.1;
  EXPECT_EQ(inherited(interface, std::vector<ContactNode<3>>{}, 1.), (Status{open, slip}));
}

TEST(ActiveSet, IsFirstTouchWhereNothingIsInherited) {
  ContactInterface<2> interface = flat_pair(4);
  interface.rows[1].initial_gap = -0.1;
  EXPECT_EQ(inherited(interface, {}, 1.), (Status{open, slip, open, open, open}));
}

TEST(ActiveSet, OpensUnderTensionAndClosesWhereBodiesOverlap) {
  const ContactInterface<2> interface = with_status({slip, slip, slip, open, open});
  const ContactState state = without_slip({1., 0., -1e-3, 0., 0.}, {0., 0., 0., -1e-3, 1e-3}, 1.);
  EXPECT_EQ(updated(interface, state), (Status{slip, slip, open, slip, open}));
}

TEST(ActiveSet, TakesRoundOffForNoReasonToChange) {
  const ContactInterface<2> interface = with_status({slip, slip, open, open});
  const ContactState state = without_slip({1., -1e-12, 0., 0.}, {0., 0., -1e-12, 1.}, 1.);
  EXPECT_EQ(updated(interface, state), interface.status);
}

TEST(ActiveSet, KnowsWhichOpenNodeLiesAhead) {
  ContactInterface<2> interface = with_status({slip, open, open, open});
  interface.rows[1].frame = frame_along(dealii::Point<2>(0., 1.));
  interface.rows[2].frame = frame_along(dealii::Point<2>(0., -1.));
  interface.rows[3].frame = frame_along(dealii::Point<2>(0.8, -0.6));
  const ContactState state = without_slip({-1., 0., 0., 0.}, {0., 0.1, 0.3, 0.2}, 1.);
  EXPECT_EQ(first_ahead(interface, state, dealii::Point<2>(0., 1.)), 2U)
      << "0.3 straight ahead comes before 0.2 aslant, and behind counts nothing";
  EXPECT_EQ(first_ahead(interface, state, dealii::Point<2>(0., -1.)), 1U);
  EXPECT_FALSE(first_ahead(interface, state, dealii::Point<2>(1., 0.)));
}

}  // namespace
}  // namespace geneva::fem::test
