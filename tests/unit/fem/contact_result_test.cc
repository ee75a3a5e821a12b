#include "fem/contact/result.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/fem/flat_pair.h"

namespace geneva::fem::test {
namespace {

/// Hertz's pressure as a mesh of edges h shows it: the contact begins and ends with a node from
/// 0.31 h beyond the true end to 0.69 h before it, whose pressure is in proportion to what it is
/// before 0.31 h beyond.
ContactState state_of_mesh(ContactInterface<2>& interface, const double centre,
                           const double half_width, const double h) {
  ContactState state = hertz_state(interface, centre, half_width);
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const double place = interface.source.nodes[interface.rows[i].node].position[0];
    const double before_end = (half_width - std::abs(place - centre)) / h;
    interface.status[i] = before_end > -0.31 ? slip : open;
    if (std::abs(before_end - 0.19) < 0.5)
      state.pressure[i] = 0.825 * (before_end + 0.31) * std::sqrt(2. * h / half_width);
  }
  return state;
}

TEST(ContactResult, HalfWidthOfHertzPressureIsExactWhereverTheEndsLieBetweenNodes) {
  for (const double centre : {0.5, 0.503, 0.5077})
    for (const double half_width : {0.2, 0.243, 0.2499}) {
      ContactInterface<2> interface = flat_pair(40);
      const ContactState state = state_of_mesh(interface, centre, half_width, 1. / 40.);
      const ContactResult<2> result = contact_result({"a", "b"}, interface, state, {1., 1.});
      // The squared pressure is a parabola: the fit is exact up to its conditioning.
      EXPECT_NEAR(result.half_width, half_width, 1e-10);
      EXPECT_FALSE(result.symmetric);
    }
}

TEST(ContactResult, HalfWidthOfHalfAModelReachesFromThePlaneOfSymmetry) {
  ContactInterface<2> interface = flat_pair(40);
  const ContactState state = state_of_mesh(interface, 0., 0.333, 1. / 40.);
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

}  // namespace
}  // namespace geneva::fem::test
