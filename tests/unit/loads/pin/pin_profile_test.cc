#include "loads/pin/pin_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "loads/pi.h"
#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

PinClearance of(const PinProfile& profile) {
  PinClearance clearance;
  clearance.profile = profile;
  clearance.wall_half = 5e-3;
  clearance.lower_end = -6e-3;
  clearance.upper_end = 7e-3;
  return clearance;
}

TEST(PinProfile, OfACylinderIsNoClearance) {
  for (const double z : {-6e-3, -5e-3, 0., 1e-3, 5e-3, 7e-3}) EXPECT_EQ(of(Cylinder{}).at(z), 0.);
}

TEST(PinProfile, OfACrownIsACircularArc) {
  const PinClearance crowned = of(Crown{0.5});
  for (const double z : {-6e-3, -1e-4, 0., 3e-3}) {
    const double below = 0.5 - crowned.at(z);
    EXPECT_NEAR(std::hypot(below, z), 0.5, 1e-15) << z;
  }
}

TEST(PinProfile, LogarithmicIsLundbergsInTheMiddleAndFiniteAtTheEnds) {
  // A = F/(pi L E*) = 10 000/(pi 0.01 1e11)
  const LogarithmicProfile profile = logarithmic_profile(1e4, 1e-2, 1e11, 1e-5);
  EXPECT_NEAR(profile.amplitude, 1e-5 / pi, 1e-20);
  const PinClearance pin = of(profile);
  const double relief = 0.3033 * 1e-5 / 5e-3;
  for (const double z : {-4e-3, -1e-3, 0., 2e-3, 4.9e-3}) {
    const double share = z / 5e-3;
    EXPECT_NEAR(pin.at(z), -profile.amplitude * std::log(1. - (1. - relief) * share * share),
                1e-15 * std::abs(pin.at(z)) + 1e-21);
  }
  EXPECT_NEAR(pin.at(5e-3), profile.amplitude * std::log(1. / relief), 1e-17);
  const double h = 1e-9;
  EXPECT_NEAR(pin.at(5e-3 + h) - pin.at(5e-3), pin.at(5e-3) - pin.at(5e-3 - h),
              1e-3 * (pin.at(5e-3) - pin.at(5e-3 - h)))
      << "goes on along its tangent";
}

TEST(PinProfile, TableIsJoinedByStraightLinesAndEndsLevel) {
  const PinClearance pin = of(ProfileTable{{-4e-3, 0., 1e-3, 4e-3}, {8e-6, 0., 0., 6e-6}});
  EXPECT_DOUBLE_EQ(pin.at(-2e-3), 4e-6);
  EXPECT_DOUBLE_EQ(pin.at(0.5e-3), 0.);
  EXPECT_DOUBLE_EQ(pin.at(2.5e-3), 3e-6);
  EXPECT_DOUBLE_EQ(pin.at(-6e-3), 8e-6);
  EXPECT_DOUBLE_EQ(pin.at(6e-3), 6e-6);
}

TEST(PinProfile, TiltLowersTheFreeEnd) {
  PinClearance pin = of(Cylinder{});
  pin.tilt = 1e-3;
  EXPECT_DOUBLE_EQ(pin.at(-6e-3), -6e-3 * std::tan(1e-3));
  EXPECT_DOUBLE_EQ(pin.at(2e-3), 2e-3 * std::tan(1e-3));
}

TEST(PinProfile, EdgeBreaksOpenTheGapTowardsTheEdgesOfTheWall) {
  PinClearance pin = of(Cylinder{});
  pin.wall_edge = {EdgeBreak::Kind::rounded, 4e-4};
  for (const double side : {-1., 1.}) {
    EXPECT_EQ(pin.at(side * 4.6e-3), 0.);
    EXPECT_NEAR(pin.at(side * 5e-3), 4e-4, 1e-18) << "a quarter of a circle";
    EXPECT_NEAR(pin.at(side * 4.8e-3), 4e-4 * (1. - std::sqrt(0.75)), 1e-18);
  }
  pin.wall_edge.kind = EdgeBreak::Kind::chamfered;
  EXPECT_NEAR(pin.at(4.7e-3), 1e-4, 1e-18);
  pin.wall_edge = {};
  pin.pin_chamfer = 1.5e-3;
  EXPECT_NEAR(pin.at(-5e-3), 5e-4, 1e-18) << "the free end reaches into the slot";
  EXPECT_EQ(pin.at(6.9e-3), 0.) << "the other one is held";
  pin.upper_is_free = true;
  EXPECT_NEAR(pin.at(6.9e-3), 1.4e-3, 1e-17);
}

TEST(PinProfile, RefusesWhatIsNone) {
  using test::expect_refused;
  expect_refused([] { check(Crown{4e-3}, 5e-3); }, {"crown radius", "4 mm", "5 mm"});
  expect_refused([] { check(ProfileTable{{0.}, {0.}}, 5e-3); }, {"two or more points"});
  expect_refused([] { check(ProfileTable{{0., 0.}, {0., 1e-6}}, 5e-3); }, {"must increase"});
  expect_refused([] { logarithmic_profile(0., 1e-2, 1e11, 1e-5); }, {"profile load"});
  expect_refused([] { logarithmic_profile(1., 1e-2, 1e11, 2e-2); }, {"half-width", "20 mm"});
  EXPECT_NO_THROW(check(Crown{6e-3}, 5e-3));
}

}  // namespace
}  // namespace geneva::loads
