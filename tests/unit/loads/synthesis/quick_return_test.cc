#include "loads/synthesis/quick_return.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loads/motion/external_geneva.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

using test::expect_refused;

QuickReturn of_stations(int z) { return quick_return({z, 12., {}, 0.1}); }

TEST(QuickReturn, MovesLikeTheGenevaAllThroughTheEngagement) {
  for (int z = 3; z <= 24; ++z) {
    const QuickReturn mechanism = of_stations(z);
    const ExternalGeneva geneva(z);
    for (int k = -100; k <= 100; ++k) {
      const double angle = k / 100. * geneva.engagement_angle();
      const QuickReturnPosition p = position(mechanism, angle);
      EXPECT_NEAR(p.rocker_speed, geneva.wheel_speed(angle, mechanism.crank_speed), 12. * 1e-12);
      EXPECT_NEAR(p.rocker_angle, geneva.wheel_angle(angle), 1e-13);
      EXPECT_NEAR(p.slider_distance, 0.1 * geneva.pin_distance_ratio(angle), 1e-15);
    }
  }
}

TEST(QuickReturn, ReachesTheGivenWheelSpeedWhereTheSliderIsNearest) {
  for (int z = 3; z <= 24; ++z)
    EXPECT_NEAR(extreme_positions(of_stations(z)).slider_nearest.rocker_speed, 12., 1e-12) << z;
}

TEST(QuickReturn, HasTheLecturesProportions) {
  const QuickReturn mechanism = quick_return({6, 12., 0.04, {}});
  EXPECT_NEAR(mechanism.centre_distance, 0.08, 1e-16);
  EXPECT_NEAR(mechanism.crank_speed, 12., 1e-13);  // AD - AB = AB
  EXPECT_EQ(mechanism.motion_ratio, 0.5);          // (6 - 2)/(6 + 2)
}

TEST(QuickReturn, PutsThePinWhereTheLoopEquationSays) {
  const QuickReturn mechanism = of_stations(5);
  for (int k = 0; k < 36; ++k) {
    const QuickReturnPosition p = position(mechanism, k * pi / 18.);
    const double phi2 = pi / 2. + p.crank_angle;
    const double phi4 = -pi / 2. - p.rocker_angle;
    EXPECT_NEAR(mechanism.crank * std::cos(phi2) - p.slider_distance * std::cos(phi4), 0., 1e-16);
    EXPECT_NEAR(mechanism.crank * std::sin(phi2) - p.slider_distance * std::sin(phi4), 0.1, 1e-15);
  }
}

TEST(QuickReturn, SpeedsAreTheDerivativesOfThePosition) {
  constexpr double h = 1e-4;  // truncation h^2/6 times third derivatives below 700 (z = 3)
  for (int z = 3; z <= 24; ++z) {
    const QuickReturn mechanism = of_stations(z);
    for (int k = 0; k < 36; ++k) {
      const double angle = k * pi / 18.;
      const QuickReturnPosition before = position(mechanism, angle - h);
      const QuickReturnPosition after = position(mechanism, angle + h);
      const QuickReturnPosition p = position(mechanism, angle);
      const double rate = mechanism.crank_speed / (2. * h);
      EXPECT_NEAR((after.rocker_angle - before.rocker_angle) * rate, p.rocker_speed,
                  2e-6 * mechanism.crank_speed);
      EXPECT_NEAR((after.slider_distance - before.slider_distance) * rate, p.slider_speed,
                  2e-7 * mechanism.crank_speed);
    }
  }
}

TEST(QuickReturn, ExtremesOfTheSliderAreExtremes) {
  for (int z = 3; z <= 24; ++z) {
    const QuickReturn mechanism = of_stations(z);
    const QuickReturnExtremes e = extreme_positions(mechanism);
    EXPECT_NEAR(e.slider_nearest.slider_distance, 0.1 - mechanism.crank, 1e-16);
    EXPECT_NEAR(e.slider_farthest.slider_distance, 0.1 + mechanism.crank, 1e-15);
    for (const double step : {-1e-3, 1e-3}) {
      EXPECT_GT(position(mechanism, step).slider_distance, e.slider_nearest.slider_distance);
      EXPECT_LT(position(mechanism, pi + step).slider_distance, e.slider_farthest.slider_distance);
    }
  }
}

TEST(QuickReturn, ExtremesOfTheRockerAreExtremesAtHalfThePitch) {
  for (int z = 3; z <= 24; ++z) {
    const QuickReturn mechanism = of_stations(z);
    const QuickReturnExtremes e = extreme_positions(mechanism);
    EXPECT_NEAR(e.rocker_first.rocker_angle, -pi / z, 1e-14);
    EXPECT_NEAR(e.rocker_last.rocker_angle, pi / z, 1e-14);
    EXPECT_NEAR(e.rocker_last.rocker_speed, 0., 1e-12);
    // crank perpendicular to the rocker: Pythagoras with AD as the hypotenuse
    EXPECT_NEAR(std::hypot(e.rocker_last.slider_distance, mechanism.crank), 0.1, 1e-15);
    for (const double step : {-1e-3, 1e-3}) {
      EXPECT_LT(position(mechanism, e.rocker_last.crank_angle + step).rocker_angle,
                e.rocker_last.rocker_angle);
      EXPECT_GT(position(mechanism, e.rocker_first.crank_angle + step).rocker_angle,
                e.rocker_first.rocker_angle);
    }
  }
}

TEST(QuickReturn, RefusesWhatItCannotReplace) {
  expect_refused([] { quick_return({2, 12., 0.1, {}}); }, {"number of stations is 2", "3 to 24"});
  expect_refused([] { quick_return({4, 0., 0.1, {}}); }, {"maximum wheel speed is 0 rad/s"});
  expect_refused([] { quick_return({4, 12., {}, {}}); }, {"neither crank AB nor", "give one"});
  expect_refused([] { quick_return({4, 12., 0.1, 0.2}); }, {"both given", "only one"});
  expect_refused([] { quick_return({4, 12., -0.1, {}}); }, {"crank AB is -100 mm", "positive"});
  expect_refused([] { position(of_stations(4), std::nan("")); }, {"crank angle is nan"});
}

}  // namespace
}  // namespace geneva::loads
