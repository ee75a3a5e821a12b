#include "fem/contact/active_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "fem/adaptivity/error_estimate.h"
#include "fem/contact/conditions.h"
#include "fem/contact/result.h"
#include "fem/contact/zone.h"
#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {
namespace {

/// A flat source on a flat target with nodes every 1/n.
ContactInterface<2> flat_pair(const unsigned int n, const double gap = 0.) {
  std::vector<double> x;
  for (unsigned int i = 0; i <= n; ++i) x.push_back(static_cast<double>(i) / n);
  ContactInterface<2> interface;
  interface.source = underside(x, gap);
  interface.target = upper_side(x);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  interface.status.assign(interface.rows.size(), NodeStatus::open);
  return interface;
}

constexpr NodeStatus open = NodeStatus::open;
constexpr NodeStatus slip = NodeStatus::slip;
using Status = std::vector<NodeStatus>;

ContactInterface<2> with_status(const Status& status) {
  ContactInterface<2> interface = flat_pair(static_cast<unsigned int>(status.size()) - 1);
  interface.status = status;
  return interface;
}

ContactInterface<2> with_active(const std::vector<bool>& active) {
  Status status;
  for (const bool touches : active) status.push_back(touches ? slip : open);
  return with_status(status);
}

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

ContactState without_slip(const std::vector<double>& pressure, const std::vector<double>& gap,
                          const double approach) {
  return {pressure, gap, approach, std::vector<Tangential>(gap.size()),
          std::vector<Tangential>(gap.size())};
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

/// gap_j(u) = 0 solved for the component with the maximum share of the normal.
TEST(ContactLines, CloseTheGapOfEveryActiveNode) {
  const double slope = 0.3;
  ContactInterface<2> interface;
  interface.source = underside({0., 1., 2.5}, 1.);
  interface.target = upper_side({-1., 0.4, 3.}, slope);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  interface.status = {slip, open, slip};
  std::set<global_dof_index> held;
  const ContactLines contact = contact_lines(interface, held);
  EXPECT_TRUE(contact.are_equal);
  const auto& lines = contact.displacement;
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(held.size(), 2U);
  // Any displacement that satisfies the line has no gap at its row.
  const auto displacement = [](const global_dof_index dof) { return std::sin(double(dof)); };
  for (std::size_t i = 0; i < 2; ++i) {
    const ContactRow<2>& row = interface.rows[2 * i];
    const SurfaceNode<2>& node = interface.source.nodes[row.node];
    ASSERT_EQ(lines[i].dof, node.dofs[1]) << "the normal points along y more than along x";
    double solved = lines[i].inhomogeneity;
    for (const auto& [dof, coefficient] : lines[i].entries)
      solved += coefficient * displacement(dof);
    dealii::Tensor<1, 2> change = row.weight * dealii::Point<2>(displacement(node.dofs[0]), solved);
    for (const auto& [target, coupling] : row.coupling)
      for (unsigned int c = 0; c < 2; ++c)
        change[c] -= coupling * displacement(interface.target.nodes[target].dofs[c]);
    EXPECT_NEAR(row.initial_gap + row.frame.normal * change, 0., 1e-13)
        << "a dozen products of size 1";
  }
}

TEST(ContactLines, LeaveHeldComponentsAlone) {
  ContactInterface<2> interface;
  interface.source = underside({0., 1.}, 1.);
  interface.target = upper_side({-1., 2.}, 0.3);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  interface.status = {slip, slip};
  const auto& dofs_of_first = interface.source.nodes[0].dofs;
  const auto& dofs_of_second = interface.source.nodes[1].dofs;
  std::set<global_dof_index> held{dofs_of_first[1], dofs_of_second[0], dofs_of_second[1]};
  const auto lines = contact_lines(interface, held).displacement;
  ASSERT_EQ(lines.size(), 1U) << "nothing is left to move the second node";
  EXPECT_EQ(lines[0].dof, dofs_of_first[0]);
}

/// Value that a line gives its dof in a field.
double solved(const ConstraintLine& line, const std::function<double(global_dof_index)>& field) {
  double value = line.inhomogeneity;
  for (const auto& [dof, coefficient] : line.entries) value += coefficient * field(dof);
  return value;
}

/// D u_j - sum_k M_jk u_k of a field in which lines give their dofs.
dealii::Tensor<1, 2> relative(const ContactInterface<2>& interface, const ContactRow<2>& row,
                              const std::vector<ConstraintLine>& lines) {
  const auto field = [](const global_dof_index dof) { return std::sin(double(dof)); };
  dealii::Tensor<1, 2> result;
  for (unsigned int c = 0; c < 2; ++c) {
    const auto dof = interface.source.nodes[row.node].dofs[c];
    double value = field(dof);
    for (const ConstraintLine& line : lines)
      if (line.dof == dof) value = solved(line, field);
    result[c] = row.weight * value;
    for (const auto& [target, coupling] : row.coupling)
      result[c] -= coupling * field(interface.target.nodes[target].dofs[c]);
  }
  return result;
}

ContactInterface<2> tilted_pair() {
  ContactInterface<2> interface;
  interface.source = underside({0., 1., 2.5}, 1.);
  interface.target = upper_side({-1., 0.4, 3.}, 0.3);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  interface.sliding.assign(3, {0., 1.});
  return interface;
}

/// p (n - mu t) does no work on the virtual displacements, and the gap closes.
TEST(ContactLines, WithFrictionVirtualDisplacementsAreAcrossTheTraction) {
  const double friction = 0.4;
  ContactInterface<2> interface = tilted_pair();
  interface.status.assign(3, slip);
  interface.law = std::make_shared<const Sliding<2>>(friction);
  std::set<global_dof_index> held;
  const ContactLines lines = contact_lines(interface, held);
  EXPECT_FALSE(lines.are_equal);
  ASSERT_EQ(lines.virtual_displacement.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const ContactRow<2>& row = interface.rows[i];
    EXPECT_EQ(lines.displacement[i].dof, lines.virtual_displacement[i].dof);
    EXPECT_NEAR(row.initial_gap + row.frame.normal * relative(interface, row, lines.displacement),
                0., 1e-13);
    const auto traction = row.frame.normal - friction * row.frame.tangents[0];
    EXPECT_NEAR(traction * relative(interface, row, lines.virtual_displacement), 0., 1e-13);
  }
}

TEST(ContactLines, NodesThatStickFollowTheTarget) {
  ContactInterface<2> interface = tilted_pair();
  interface.status = {NodeStatus::stick, open, NodeStatus::stick};
  interface.law = std::make_shared<const Coulomb<2>>(0.1);
  std::set<global_dof_index> held;
  const ContactLines lines = contact_lines(interface, held);
  EXPECT_TRUE(lines.are_equal);
  ASSERT_EQ(lines.displacement.size(), 4U);
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    const ContactRow<2>& row = interface.rows[i];
    const auto left = relative(interface, row, lines.displacement);
    EXPECT_NEAR(row.initial_gap + row.frame.normal * left, 0., 1e-13);
    EXPECT_NEAR(row.frame.tangents[0] * left, 0., 1e-13);
  }
}

/// Hertz's pressure at the nodes of a flat pair, contact from 0.5 + offset - b to 0.5 + offset + b.
ContactState hertz_state(ContactInterface<2>& interface, const double centre,
                         const double half_width) {
  ContactState state;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const double x = interface.source.nodes[interface.rows[i].node].position[0] - centre;
    const double square = 1. - x * x / (half_width * half_width);
    interface.status[i] = square > 0. ? slip : open;
    state.pressure.push_back(square > 0. ? std::sqrt(square) : 0.);
    state.gap.push_back(square > 0. ? 0. : -square);
    state.slip.push_back({});
    state.friction.push_back({});
  }
  return state;
}

TEST(ContactResult, HalfWidthOfHertzPressureIsExactWhereverTheEndsLieBetweenNodes) {
  for (const double centre : {0.5, 0.503, 0.5077})
    for (const double half_width : {0.2, 0.243, 0.2499}) {
      ContactInterface<2> interface = flat_pair(40);
      const ContactState state = hertz_state(interface, centre, half_width);
      const ContactResult<2> result = contact_result({"a", "b"}, interface, state, {1., 1.});
      // The squared pressure is a parabola: the fit is exact up to its conditioning.
      EXPECT_NEAR(result.half_width, half_width, 1e-10);
      EXPECT_FALSE(result.symmetric);
    }
}

TEST(ContactResult, HalfWidthOfHalfAModelReachesFromThePlaneOfSymmetry) {
  ContactInterface<2> interface = flat_pair(40);
  const ContactState state = hertz_state(interface, 0., 0.333);
  const ContactResult<2> result = contact_result({"a", "b"}, interface, state, {1., 1.});
  EXPECT_TRUE(result.symmetric);
  EXPECT_NEAR(result.half_width, 0.333, 1e-10);
}

TEST(ContactResult, IsInTheUnitsOfTheScales) {
  ContactInterface<2> interface = flat_pair(40, 0.01);
  const ContactState state = hertz_state(interface, 0.5, 0.2);
  const Scales scales{2., 3.};
  const ContactResult<2> plain = contact_result({"a", "b"}, interface, state, {1., 1.});
  const ContactResult<2> result = contact_result({"a", "b"}, interface, state, scales);
  EXPECT_EQ(result.active_nodes, plain.active_nodes);
  EXPECT_NEAR(result.half_width, 2. * plain.half_width, 1e-14);
  EXPECT_NEAR(result.peak_pressure, 3. * plain.peak_pressure, 1e-14);
  EXPECT_NEAR(result.force[1], 12. * plain.force[1], 1e-13);
  EXPECT_NEAR(result.moment, 24. * plain.moment, 1e-13);
  for (std::size_t i = 0; i < result.nodes.size(); ++i) {
    EXPECT_NEAR(result.nodes[i].tributary, 4. * plain.nodes[i].tributary, 1e-14);
    EXPECT_NEAR(result.nodes[i].initial_gap, 0.02, 1e-14);
    EXPECT_NEAR(result.nodes[i].gap, 2. * plain.nodes[i].gap, 1e-14);
    EXPECT_NEAR(result.nodes[i].position[0], 2. * plain.nodes[i].position[0], 1e-14);
  }
}

TEST(ContactResult, ForceIsThePressureTimesTheNodesAreasAlongTheNormal) {
  ContactInterface<2> interface = flat_pair(4);
  interface.status.assign(5, slip);
  const ContactState state = without_slip({1., 2., 3., 4., 5.}, {0., 0., 0., 0., 0.}, 1.);
  const ContactResult<2> result = contact_result({"a", "b"}, interface, state, {1., 1.});
  // Linear pressure 1 + 4 x on a unit length: 3; its moment is the integral of x (1 + 4 x), where
  // the lumped areas give 1/8 (5) + 1/4 (1/4 2 + 1/2 3 + 3/4 4) in place of 11/6.
  EXPECT_NEAR(result.force[1], 3., 1e-14);
  EXPECT_NEAR(result.force[0], 0., 1e-14);
  EXPECT_NEAR(result.moment, 1.875, 1e-14);
  EXPECT_EQ(result.peak_pressure, 5.);
}

TEST(ContactResult, PenetrationIsTheMaximumOverlapOfInactiveNodes) {
  ContactInterface<2> interface = flat_pair(3);
  interface.status = {slip, open, open, open};
  const ContactState state = without_slip({1., 0., 0., 0.}, {-0.5, -0.1, -0.2, 0.3}, 1.);
  EXPECT_EQ(contact_result({"a", "b"}, interface, state, {1., 1.}).max_penetration, 0.2);
}

/// Pressures that rise in the active rows to a peak in the middle, or in a given row.
ContactState rising(const std::vector<bool>& active, const double peak,
                    const std::optional<std::size_t> at = {}) {
  const std::size_t top = at.value_or(active.size() / 2);
  ContactState state{};
  for (std::size_t i = 0; i < active.size(); ++i) {
    const double distance = i > top ? static_cast<double>(i - top) : static_cast<double>(top - i);
    state.pressure.push_back(active[i] ? peak * (1. - 1e-3 * distance) : 0.);
  }
  return state;
}

TEST(ErrorEstimate, KnowsThatAFreeEndLiesSomewhereOnAnEdge) {
  const std::vector<bool> free_ends{false, true, true, true, true, true, true, true, false};
  const std::vector<bool> one_end{true, true, true, true, false};
  const std::vector<bool> no_end(8, true);
  const double with_two = end_error<2>({with_active(free_ends)}, {rising(free_ends, 1.)}, false);
  EXPECT_GT(with_two, 0.5 / 49.) << "of the order 1/N^2 with 7 nodes";
  EXPECT_NEAR(end_error<2>({with_active(one_end)}, {rising(one_end, 1., 0)}, false), with_two,
              1e-15)
      << "half of that contact";
  EXPECT_NEAR(end_error<2>({with_active(one_end)}, {rising(one_end, 1., 0)}, true),
              with_two * 49. / 16., 1e-15)
      << "on an axis";
  EXPECT_EQ(end_error<2>({with_active(no_end)}, {rising(no_end, 1.)}, false), 0.);
  EXPECT_FALSE(has_free_ends<2>({with_active(no_end)}));
  EXPECT_TRUE(has_free_ends<2>({with_active(one_end)}));
}

TEST(ErrorEstimate, CountsTheNodesBetweenAFreeEndAndThePeak) {
  std::vector<bool> active(42, true);
  active.front() = active.back() = false;
  const std::vector<bool> seven{false, true, true, true, true, true, true, true, false};
  const double of_seven = end_error<2>({with_active(seven)}, {rising(seven, 1.)}, false);
  EXPECT_NEAR(end_error<2>({with_active(active)}, {rising(active, 1., 4)}, false), of_seven, 1e-15);
  EXPECT_NEAR(end_error<2>({with_active(active)}, {rising(active, 1., 37)}, false), of_seven,
              1e-15);
  ContactInterface<2> interface = with_active(active);
  const auto at = [&](const std::size_t i) { return interface.source.nodes[i].arc_length; };
  interface.smooth = {{at(9), at(30)}};
  EXPECT_NEAR(end_error<2>({interface}, {rising(active, 1., 4)}, false), of_seven, 1e-15)
      << "and not those of a smooth middle";
}

TEST(ErrorEstimate, TellsAPeakBesideAnEndFromOneInTheMiddle) {
  std::vector<bool> active(42, true);
  active.front() = active.back() = false;
  const std::vector<bool> all_open(4, false);
  const std::vector<bool> half{true, true, true, true, true, true, false};
  const auto is_beside_end = [&](const std::size_t peak) {
    return peaks_beside_end<2>({with_active(all_open), with_active(active)},
                               {rising(all_open, 0.), rising(active, 1., peak)});
  };
  EXPECT_TRUE(is_beside_end(5));
  EXPECT_TRUE(is_beside_end(36));
  EXPECT_FALSE(is_beside_end(14));
  EXPECT_FALSE(is_beside_end(20));
  EXPECT_FALSE(peaks_beside_end<2>({with_active(half)}, {rising(half, 1., 0)}))
      << "half of a contact with the peak on the plane of symmetry";
  EXPECT_FALSE(peaks_beside_end<2>({with_active(active), with_active(half)},
                                   {rising(active, 1., 5), rising(half, 2., 0)}))
      << "the pair with the maximum pressure decides";
}

TEST(ErrorEstimate, OfALoneNodeBeyondTheContactCountsLittle) {
  const std::vector<bool> active{false, true, false, true, true, true, true, true, true, false};
  ContactState state = rising(active, 1.);
  state.pressure[1] = 0.01;
  EXPECT_LT(end_error<2>({with_active(active)}, {state}, false), 0.1);
}

TEST(ErrorEstimate, OfSeveralPairsCountsEachAsItsPeakAndNotOpenOnes) {
  const std::vector<bool> eight{false, true, true, true, true, true, true, true, true, false};
  const std::vector<bool> two{false, true, true, false};
  const std::vector<bool> all_open(4, false);
  const double of_eight = end_error<2>({with_active(eight)}, {rising(eight, 1.)}, false);
  const double of_two = end_error<2>({with_active(two)}, {rising(two, 1.)}, false);
  EXPECT_DOUBLE_EQ(end_error<2>({with_active(eight), with_active(all_open)},
                                {rising(eight, 3.), rising(all_open, 0.)}, false),
                   of_eight);
  EXPECT_DOUBLE_EQ(end_error<2>({with_active(eight), with_active(two)},
                                {rising(eight, 4.), rising(two, 2.)}, false),
                   of_two / 2.);
}

std::vector<LevelRecord> history_of(const std::vector<double>& peaks, const unsigned int nodes) {
  std::vector<LevelRecord> history;
  for (const double peak : peaks) {
    LevelRecord record{};
    record.peak_pressure = peak;
    record.nodes_across = nodes;
    record.active_nodes = nodes;
    record.refined = history.empty() ? Refined::nothing : Refined::zone;
    history.push_back(record);
  }
  return history;
}

TEST(SmoothParts, AreFoundWhereAPressureHasNoBend) {
  constexpr unsigned int count = 201;
  ContactInterface<2> interface = flat_pair(count - 1);
  interface.status.assign(count, slip);
  ContactState state{std::vector<double>(count, 0.5), {}, 0.};
  for (const std::size_t i : {1U, 199U}) state.pressure[i] = 1.;
  const ArcIntervals smooth = smooth_intervals(interface, state, 1e-3);
  ASSERT_EQ(smooth.size(), 1U);
  EXPECT_NEAR((smooth[0].second - smooth[0].first) / interface.source.length, 178. / 200., 1e-12);
  interface.smooth = smooth;
  const std::vector<bool> zone = zone_rows(interface);
  EXPECT_EQ(std::count(zone.begin(), zone.end(), true), 22);
  EXPECT_EQ(zone_intervals(interface).size(), 2U);
}

TEST(SmoothParts, AreNoneInAContactThatIsSmoothOrBentAllOver) {
  constexpr unsigned int count = 201;
  ContactInterface<2> interface = flat_pair(count - 1);
  interface.status.assign(count, slip);
  ContactState state{std::vector<double>(count, 1.), {}, 0.};
  EXPECT_TRUE(smooth_intervals(interface, state, 1e-3).empty());
  for (std::size_t i = 0; i < count; i += 10) state.pressure[i] = 0.9;
  EXPECT_TRUE(smooth_intervals(interface, state, 1e-3).empty());
}

TEST(UnboundedPressure, GrowsOnThreeMeshesInARow) {
  EXPECT_TRUE(grows_without_bound(history_of({1., 1.2, 1.4, 1.7}, 20)));
  EXPECT_TRUE(grows_without_bound(history_of({9., 1., 1.2, 1.4, 1.7}, 20)));
  EXPECT_FALSE(grows_without_bound(history_of({1.2, 1.4, 1.7}, 20))) << "too few meshes to say so";
  EXPECT_FALSE(grows_without_bound(history_of({1., 1.2, 1.4, 1.45}, 20)));
  EXPECT_FALSE(grows_without_bound(history_of({1., 1.2, 1.1, 1.3}, 20)));
  EXPECT_FALSE(grows_without_bound(history_of({1., 2., 4., 8.}, 3)))
      << "a contact that is not resolved gets narrower with the mesh";
  EXPECT_FALSE(grows_without_bound({}));
}

TEST(UnboundedPressure, IsExpectedAtAnEndOrACornerOnly) {
  constexpr std::size_t count = 41;
  ContactInterface<2> interface = flat_pair(count - 1);
  const auto peaks_at = [&](const std::size_t row) {
    ContactState state{std::vector<double>(count, 0.5), {}, 0.};
    state.pressure[row] = 1.;
    return peaks_at_corner(interface, state);
  };
  for (const std::size_t row : {0U, 3U, 37U, 40U}) EXPECT_TRUE(peaks_at(row)) << row;
  for (const std::size_t row : {6U, 20U, 34U}) EXPECT_FALSE(peaks_at(row)) << row;
  // a kink of the target
  std::vector<dealii::Point<2>> roof{{1.2, 0.}, {0.5, 0.01}, {-0.2, 0.}};
  interface.target = straight_surface(roof);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  ASSERT_EQ(interface.rows.size(), count);
  EXPECT_TRUE(peaks_at(20));
}

TEST(ContactResult, KnowsWhetherTheCurvatureChangesWithinTheContact) {
  ContactInterface<2> interface = flat_pair(20);
  ContactState state = without_slip(std::vector<double>(21, 0.), std::vector<double>(21, 0.), 1.);
  const auto result_of = [&](const std::size_t begin, const std::size_t end) {
    std::fill(interface.status.begin(), interface.status.end(), open);
    std::fill(state.pressure.begin(), state.pressure.end(), 0.);
    for (std::size_t i = begin; i < end; ++i) {
      interface.status[i] = slip;
      state.pressure[i] = 1.;
    }
    return contact_result({"a", "b"}, interface, state, {1., 1.});
  };
  EXPECT_TRUE(result_of(0, 21).has_one_curvature);
  // half of the target belongs to a circle that is all but flat
  interface.target.circles = {{{0.5, -1e9}, 1e9}};
  for (SurfaceFace<2>& face : interface.target.faces)
    if (face_middle(interface.target, face)[0] < 0.5) face.circle = 0;
  EXPECT_FALSE(result_of(0, 21).has_one_curvature);
  EXPECT_FALSE(result_of(6, 13).has_one_curvature);
  EXPECT_TRUE(result_of(2, 7).has_one_curvature);
  EXPECT_TRUE(result_of(14, 19).has_one_curvature);
}

TEST(UnboundedPressure, IsNotTakenFromMeshesThatOnlyRefineTheSurroundings) {
  auto history = history_of({1., 1.2, 1.4, 1.7}, 20);
  history[2].refined = Refined::surroundings;
  EXPECT_FALSE(grows_without_bound(history));
}

TEST(NoProgress, IsSeenWhereNeitherNodesNorPressureChangeOnThreeMeshes) {
  EXPECT_TRUE(stands_still(history_of({4., 1., 1., 1., 1.}, 1)));
  EXPECT_FALSE(stands_still(history_of({1., 1., 1.}, 1))) << "two meshes";
  EXPECT_FALSE(stands_still(history_of({1., 2., 4., 8.}, 1))) << "a load on one node";
  auto growing = history_of({1., 1., 1., 1.}, 5);
  for (std::size_t i = 0; i < growing.size(); ++i) growing[i].active_nodes <<= i;
  EXPECT_FALSE(stands_still(growing)) << "a flat face in contact";
}

constexpr Convergence forces_given{true, false, false};

TEST(Extrapolation, FindsBothPartsOfAnErrorOfSecondOrder) {
  // 1 + 0.08 h^2 + 0.05 s with the cells' size h in the zone and the size measure s around it
  const auto value = [](const double h, const double s) { return 1. + 0.08 * h * h + 0.05 * s; };
  const std::vector<MeshValue> values{{value(1., 1.), Refined::nothing, 0, 1.},
                                      {value(0.5, 1.), Refined::zone, 1, 1.},
                                      {value(0.25, 1.), Refined::zone, 1, 1.},
                                      {value(0.25, 0.25), Refined::surroundings, 0, 0.25}};
  const Extrapolation found = extrapolate(values, 0.2, forces_given);
  EXPECT_NEAR(found.correction, -0.75 * 0.05 * 0.25, 2e-4);
  EXPECT_NEAR(found.surroundings_error, 0.4 * 0.05 * 0.25, 2e-4);
  EXPECT_NEAR(found.zone_error, 0.08 / 16., 2e-4);
}

TEST(Extrapolation, OfFirstOrderLeavesAsMuchAsTheLastChange) {
  const std::vector<MeshValue> values{
      {1.4, Refined::nothing, 0, 1.}, {1.2, Refined::zone, 1, 1.}, {1.1, Refined::zone, 1, 1.}};
  EXPECT_NEAR(extrapolate(values, 0.2, forces_given).zone_error, 0.1 / 1.1, 1e-12);
}

TEST(Extrapolation, DoesNotTrustTwoMeshesThatAgree) {
  const std::vector<MeshValue> values{
      {1.6, Refined::nothing, 0, 1.}, {1.2, Refined::zone, 1, 1.}, {1.2, Refined::zone, 1, 1.}};
  EXPECT_NEAR(extrapolate(values, 0.2, forces_given).zone_error, 0.4 / 1.2 / 3. / 4., 1e-12)
      << "what the change before leaves at second order";
}

TEST(Extrapolation, TakesTheMiddleOfTheFirstOrderWhereTheForceDependsOnTheCellsToo) {
  const std::vector<MeshValue> values{{1.1, Refined::nothing, 0, 1.},
                                      {1.1, Refined::zone, 1, 1.},
                                      {1.02, Refined::surroundings, 0, 0.25}};
  const double change = -0.08 / 1.02;
  const Extrapolation found = extrapolate(values, 0.2, {false, false, false});
  EXPECT_NEAR(found.correction, change / 2., 1e-12) << "an error of stiffness is halved at most";
  EXPECT_NEAR(found.surroundings_error, -change / 2., 1e-12);
  EXPECT_NEAR(extrapolate(values, 0.2, forces_given).correction, 0.75 * change / 3., 1e-12);
}

TEST(ErrorEstimate, AsksForTwoMeshesOfTheZoneWithEnoughNodesInThePlane) {
  std::vector<LevelRecord> history = history_of({1., 1.1, 1.12}, 3);
  for (LevelRecord& level : history) level.refined = Refined::zone;
  const auto with_nodes = [&](const std::vector<unsigned int>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) history[i].nodes_across = nodes[i];
    return history;
  };
  EXPECT_FALSE(shows_zone_error<2>(with_nodes({3, 5, 10})));
  EXPECT_TRUE(shows_zone_error<3>(with_nodes({3, 5, 10})));
  EXPECT_TRUE(shows_zone_error<2>(with_nodes({3, 6, 11})));
  EXPECT_FALSE(shows_zone_error<3>(with_nodes({6, 6, 5})));
  EXPECT_EQ(resolved_values(with_nodes({3, 2, 5}), &LevelRecord::peak_pressure).size(), 1U);
  EXPECT_EQ(resolved_values(with_nodes({3, 5, 10}), &LevelRecord::peak_pressure).size(), 3U);
}

TEST(Extrapolation, TakesNoMoreFromAFallOfTheMeasureThanHalvedCellsCanGive) {
  const auto left_with = [](const double measure) {
    const std::vector<MeshValue> values{{1.1, Refined::nothing, 0, 1.},
                                        {1.1, Refined::zone, 1, 1.},
                                        {1.02, Refined::surroundings, 0, measure}};
    return extrapolate(values, 0.2, forces_given);
  };
  EXPECT_NEAR(left_with(0.01).correction, left_with(0.25).correction, 1e-12);
  EXPECT_NEAR(left_with(0.25).correction, -0.75 * 0.08 / 1.02 / 3., 1e-12);
  EXPECT_EQ(left_with(0.8).correction, 0.) << "hardly any of the error is seen";
  EXPECT_NEAR(left_with(0.8).surroundings_error, 0.35 * 0.04, 1e-12) << "the worst that was seen";
}

TEST(Extrapolation, LeavesAllInDoubtWhereThePressurePeaksBesideAnEnd) {
  const std::vector<MeshValue> values{{1.1, Refined::nothing, 0, 1.},
                                      {1.1, Refined::zone, 1, 1.},
                                      {1.02, Refined::surroundings, 0, 0.25}};
  const Extrapolation found = extrapolate(values, 0.2, {true, false, true});
  EXPECT_NEAR(found.correction, -0.08 / 1.02 / 6., 1e-12);
  EXPECT_NEAR(found.surroundings_error, 0.08 / 1.02 / 3., 1e-12);
}

TEST(ErrorEstimate, TakesItsPartsAsIndependent) {
  EXPECT_DOUBLE_EQ(error_of(0.03, 0.04), 0.05);
  EXPECT_EQ(error_of(1., 0.5), 1.);
}

TEST(Extrapolation, CorrectsTheZoneOnAnAxisOfRevolution) {
  const auto value = [](const double h) { return 1. - 0.08 * h * h; };
  const std::vector<MeshValue> values{{value(1.), Refined::nothing, 0, 1.},
                                      {value(0.5), Refined::zone, 1, 1.},
                                      {value(0.25), Refined::zone, 1, 1.}};
  const Extrapolation found = extrapolate(values, 0.2, {true, true, false});
  EXPECT_NEAR(values.back().value * (1. + found.correction), 1., 1e-12);
  EXPECT_EQ(extrapolate(values, 0.2, forces_given).correction, 0.);
  EXPECT_EQ(extrapolate(values, 0.2, {false, true, false}).correction, 0.)
      << "a force that still changes";
}

TEST(Extrapolation, SaysNothingSmallOfCellsThatWereNeverRefined) {
  EXPECT_EQ(extrapolate({{1., Refined::nothing, 0, 1.}}, 0.5, forces_given).zone_error, 1.);
  EXPECT_GT(
      extrapolate({{1., Refined::nothing, 0, 1.}, {1., Refined::zone, 1, 1.}}, 0.5, forces_given)
          .surroundings_error,
      0.05);
}

TEST(ErrorEstimate, GradingGetsFinerWithTheAccuracyAndStaysInItsRange) {
  EXPECT_LE(first_grading<2>(1.), 0.5);
  EXPECT_LE(first_grading<3>(1.), 0.5);
  EXPECT_GT(first_grading<2>(1e-6), 0.);
  EXPECT_NEAR(first_grading<2>(1e-4) / first_grading<2>(1e-6), 10., 1e-12)
      << "an error of second order";
}

}  // namespace
}  // namespace geneva::fem::test
