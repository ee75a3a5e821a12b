#include "loads/synthesis/crank_rocker.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/random_values.h"

namespace geneva::loads {
namespace {

using test::between;
using test::expect_refused;

CrankRockerInput random_input() {
  const double swing = between(5., 150.) * degree;
  const double rocker = between(0.01, 1.);
  return {swing, rocker, rocker * std::sin(swing / 2.) * between(1.05, 5.)};
}

double rocker_angle(const CrankRocker& c, double crank_angle) {
  return motion(c.linkage, c.assembly, crank_angle).rocker_angle[0];
}

TEST(CrankRocker, LectureExampleOfThirtyDegrees) {
  const CrankRocker c = crank_rocker({30. * degree, 0.1, 0.08});
  EXPECT_NEAR(c.linkage.crank, 0.1 * std::sin(15. * degree), 1e-17);
  EXPECT_EQ(c.linkage.coupler, 0.08);
  EXPECT_NEAR(c.frame, std::hypot(0.08, 0.1 * std::cos(15. * degree)), 1e-16);
  EXPECT_NEAR(rocker_angle(c, c.near_crank) - rocker_angle(c, c.far_crank), 30. * degree, 1e-14);
}

RC_GTEST_PROP(CrankRockerProperty, RockerSwingsByTheGivenAngleInTwoEqualHalfTurns, ()) {
  const CrankRockerInput input = random_input();
  const CrankRocker c = crank_rocker(input);
  RC_ASSERT(crank_turns_fully(c.linkage));
  const FourBarMotion far = motion(c.linkage, c.assembly, c.far_crank);
  const FourBarMotion near = motion(c.linkage, c.assembly, c.near_crank);
  // the rocker rests at both ends, which are half a turn of the crank apart
  RC_ASSERT(std::abs(far.rocker_angle[1]) < 1e-10 && std::abs(near.rocker_angle[1]) < 1e-10);
  RC_ASSERT(std::abs(c.near_crank - c.far_crank - pi) < 1e-15);
  RC_ASSERT(std::abs(near.rocker_angle[0] - far.rocker_angle[0] - input.swing) < 1e-10);
}

RC_GTEST_PROP(CrankRockerProperty, RockerGoesForwardAndBackWithoutTurningBetween, ()) {
  const CrankRocker c = crank_rocker(random_input());
  for (int k = 1; k < 60; ++k) {
    RC_ASSERT(motion(c.linkage, c.assembly, k * pi / 60.).rocker_angle[1] > 0.);
    RC_ASSERT(motion(c.linkage, c.assembly, pi + k * pi / 60.).rocker_angle[1] < 0.);
  }
}

RC_GTEST_PROP(CrankRockerProperty, NoTransmissionAngleIsSmallerThanTheLeast, ()) {
  const CrankRocker c = crank_rocker(random_input());
  const auto transmission = [&](double crank_angle) {
    const FourBarMotion m = motion(c.linkage, c.assembly, crank_angle);
    return std::asin(std::abs(std::sin(m.coupler_angle[0] - m.rocker_angle[0])));
  };
  RC_ASSERT(transmission(between(0., 2. * pi)) > c.minimum_transmission_angle - 1e-7);
  const double along_frame = std::atan2(c.linkage.rocker_pivot[1] - c.linkage.crank_pivot[1],
                                        c.linkage.rocker_pivot[0] - c.linkage.crank_pivot[0]);
  RC_ASSERT(std::abs(transmission(along_frame) - c.minimum_transmission_angle) < 1e-7);
  RC_ASSERT(std::abs(transmission(along_frame + pi) - c.minimum_transmission_angle) < 1e-7);
  const double cosine = c.linkage.crank * c.frame / (c.linkage.coupler * c.linkage.rocker);
  RC_ASSERT(std::abs(std::cos(c.minimum_transmission_angle) - cosine) < 1e-14);
  RC_ASSERT(c.minimum_transmission_angle < pi / 2. - c.swing / 2.);
}

TEST(CrankRocker, RefusesSwingsBeyondThoseOfACrankRocker) {
  expect_refused([] { crank_rocker({0., 0.1, 0.1}); }, {"swing of the rocker is 0 deg", "180"});
  expect_refused([] { crank_rocker({pi, 0.1, 0.1}); }, {"swing of the rocker is 180 deg"});
  expect_refused([] { crank_rocker({std::nan(""), 0.1, 0.1}); }, {"nan deg", "give a swing"});
}

TEST(CrankRocker, RefusesARockerWithoutLength) {
  expect_refused([] { crank_rocker({1., 0., 0.1}); }, {"rocker CD is 0 mm", "positive"});
}

TEST(CrankRocker, RefusesACranksPivotOnTheChord) {
  expect_refused(
      [] {
        crank_rocker({60. * degree, 0.1, 0.05});
      },
      {"is 50 mm", "greater than half the chord, 50 mm", "Grashof", "move"});
  expect_refused([] { crank_rocker({60. * degree, 0.1, -0.2}); }, {"is -200 mm"});
}

}  // namespace
}  // namespace geneva::loads
