#include "loads/motion/external_geneva.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/random_values.h"

namespace geneva::loads {
namespace {

using test::between;
using test::expect_refused;
using test::random_stations;

/// Closed forms evaluated at doubles: a few roundings, amplified by 1/(1 - s)^4 < 3100 at n = 3.
constexpr double closed_form = 1e-12;

double peak_acceleration(const ExternalGeneva& geneva) {
  return geneva.acceleration_ratio(-geneva.peak_acceleration_angle());
}

TEST(ExternalGeneva, RefusesFewerThanThreeStations) {
  expect_refused([] { ExternalGeneva(2); }, {"number of stations is 2", "3 to 24", "give"});
}

TEST(ExternalGeneva, RefusesMoreThanTwentyFourStations) {
  expect_refused([] { ExternalGeneva(25); }, {"number of stations is 25", "3 to 24", "give"});
}

TEST(ExternalGeneva, CentreDistanceOverCrankRadiusIsOneOverSineOfHalfPitch) {
  EXPECT_NEAR(1. / ExternalGeneva(4).crank_ratio(), std::sqrt(2.), closed_form);
  EXPECT_NEAR(1. / ExternalGeneva(6).crank_ratio(), 2., closed_form);
  EXPECT_NEAR(1. / ExternalGeneva(3).crank_ratio(), 2. / std::sqrt(3.), closed_form);
}

TEST(ExternalGeneva, PeakSpeedIsAtTheLineOfCentres) {
  // s/(1 - s); the listed values have six digits
  const double listed[] = {6.4641, 2.41421, 1.42592, 1.0};
  for (int n = 3; n <= 6; ++n) {
    const ExternalGeneva geneva(n);
    EXPECT_NEAR(geneva.speed_ratio(0.), listed[n - 3], 5e-5) << n;
    EXPECT_GT(geneva.speed_ratio(0.), geneva.speed_ratio(1e-3)) << n;
    EXPECT_GT(geneva.speed_ratio(0.), geneva.speed_ratio(-1e-3)) << n;
  }
  EXPECT_NEAR(ExternalGeneva(8).speed_ratio(0.), 0.61991, 5e-6);
}

TEST(ExternalGeneva, PeakAccelerationOfFourStationsIsFivePointFour) {
  // half a unit of the last digit given
  EXPECT_NEAR(peak_acceleration(ExternalGeneva(4)), 5.4070, 5e-5);
  EXPECT_NEAR(ExternalGeneva(4).peak_acceleration_angle(), 11.464 * degree, 5e-4 * degree);
}

TEST(ExternalGeneva, JerkAtTheLineOfCentresHasTheListedSize) {
  // half a unit of the last digit; acceleration turns from driving to braking, so jerk is negative
  EXPECT_NEAR(ExternalGeneva(3).jerk_ratio(0.), -672.02, 5e-3);
  EXPECT_NEAR(ExternalGeneva(4).jerk_ratio(0.), -48.042, 5e-4);
  EXPECT_NEAR(ExternalGeneva(5).jerk_ratio(0.), -13.324, 5e-4);
  EXPECT_NEAR(ExternalGeneva(6).jerk_ratio(0.), -6.000, closed_form);
}

TEST(ExternalGeneva, AccelerationAtEntryIsTangentOfHalfPitch) {
  for (int n = 3; n <= 24; ++n) {
    const ExternalGeneva geneva(n);
    EXPECT_NEAR(geneva.acceleration_ratio(-geneva.engagement_angle()), std::tan(pi / n),
                closed_form);
    EXPECT_NEAR(geneva.acceleration_ratio(geneva.engagement_angle()), -std::tan(pi / n),
                closed_form);
  }
}

TEST(ExternalGeneva, JerkVanishesAtThePeakOfAcceleration) {
  // the angle is right to 1e-15 and the jerk's slope there is below 2e4 (n = 3)
  for (int n = 3; n <= 24; ++n) {
    const ExternalGeneva geneva(n);
    EXPECT_NEAR(geneva.jerk_ratio(-geneva.peak_acceleration_angle()), 0., 1e-10) << n;
  }
}

TEST(ExternalGeneva, LectureExampleOfSixStationsAt360RevolutionsPerMinute) {
  const ExternalGeneva geneva(6);
  const double speed = 360. * 2. * pi / 60.;
  const double motion_fraction = 2. * geneva.engagement_angle() / (2. * pi);
  EXPECT_NEAR(geneva.half_pitch(), 30. * degree, closed_form);
  EXPECT_NEAR(motion_fraction, 1. / 3., closed_form);
  EXPECT_NEAR((1. - motion_fraction) / 6., 1. / 9., closed_form);  // dwell [s]
  EXPECT_NEAR(geneva.wheel_speed(0., speed), 37.699, 5e-4);
  EXPECT_NEAR(geneva.peak_acceleration_angle(), 22.903 * degree, 5e-4 * degree);
  // 1.349643 (12 pi)^2, half a unit of the last digit
  EXPECT_NEAR(geneva.wheel_acceleration(-geneva.peak_acceleration_angle(), speed, 0.), 1918.14,
              5e-3);
}

TEST(ExternalGeneva, PinIsNearestAtTheLineOfCentresAndAtTheRimAtEntry) {
  for (int n = 3; n <= 24; ++n) {
    const ExternalGeneva geneva(n);
    EXPECT_NEAR(geneva.pin_distance_ratio(0.), 1. - geneva.crank_ratio(), 1e-15) << n;
    EXPECT_NEAR(geneva.pin_distance_ratio(-geneva.engagement_angle()),
                std::cos(geneva.half_pitch()), closed_form)
        << n;
  }
}

TEST(ExternalGeneva, DriverAccelerationAddsSpeedRatioTimesIt) {
  const ExternalGeneva geneva(4);
  EXPECT_NEAR(geneva.wheel_acceleration(0., 7., 3.), 3. * geneva.speed_ratio(0.), closed_form);
  EXPECT_NEAR(geneva.wheel_acceleration(0.2, 7., 3.),
              3. * geneva.speed_ratio(0.2) + 49. * geneva.acceleration_ratio(0.2), 1e-10);
}

/// Fourth-order central difference.
template <typename Function>
double difference(const Function& function, double x, double h) {
  return (8. * (function(x + h) - function(x - h)) -
          (function(x + 2. * h) - function(x - 2. * h))) /
         (12. * h);
}

/// The functions' nearest singularities lie at theta = +- i delta, delta = ln(1/s). By Cauchy's
/// estimate on circles of radius delta/2 their fifth derivative is below 5! M (2/delta)^5 with M
/// at most 4 times the maximum value; with h = 1e-3 delta truncation is below h^4/30 of that,
/// 5e-10 of maximum/delta, and rounding about 1e-12 of it.
double difference_step(const ExternalGeneva& geneva) {
  return 1e-3 * std::log(1. / geneva.crank_ratio());
}

double difference_tolerance(const ExternalGeneva& geneva, double maximum) {
  return 1e-9 * maximum / std::log(1. / geneva.crank_ratio());
}

double random_driver_angle(const ExternalGeneva& geneva) {
  return between(-1., 1.) * geneva.engagement_angle();
}

RC_GTEST_PROP(ExternalGenevaProperty, SpeedIsTheDerivativeOfAngle, ()) {
  const ExternalGeneva geneva(random_stations());
  const double theta = random_driver_angle(geneva);
  const auto angle = [&](double x) { return geneva.wheel_angle(x); };
  RC_ASSERT(std::abs(difference(angle, theta, difference_step(geneva)) -
                     geneva.speed_ratio(theta)) < difference_tolerance(geneva, pi));
}

RC_GTEST_PROP(ExternalGenevaProperty, AccelerationIsTheDerivativeOfSpeed, ()) {
  const ExternalGeneva geneva(random_stations());
  const double theta = random_driver_angle(geneva);
  const auto speed = [&](double x) { return geneva.speed_ratio(x); };
  RC_ASSERT(std::abs(difference(speed, theta, difference_step(geneva)) -
                     geneva.acceleration_ratio(theta)) <
            difference_tolerance(geneva, geneva.speed_ratio(0.)));
}

RC_GTEST_PROP(ExternalGenevaProperty, JerkIsTheDerivativeOfAcceleration, ()) {
  const ExternalGeneva geneva(random_stations());
  const double theta = random_driver_angle(geneva);
  const auto acceleration = [&](double x) { return geneva.acceleration_ratio(x); };
  RC_ASSERT(std::abs(difference(acceleration, theta, difference_step(geneva)) -
                     geneva.jerk_ratio(theta)) <
            difference_tolerance(geneva, peak_acceleration(geneva)));
}

RC_GTEST_PROP(ExternalGenevaProperty, AngleAndAccelerationAreOddSpeedIsEven, ()) {
  // sine and cosine of the library are exactly odd and even, so the values agree to the last bit
  const ExternalGeneva geneva(random_stations());
  const double theta = random_driver_angle(geneva);
  RC_ASSERT(geneva.wheel_angle(-theta) == -geneva.wheel_angle(theta));
  RC_ASSERT(geneva.speed_ratio(-theta) == geneva.speed_ratio(theta));
  RC_ASSERT(geneva.acceleration_ratio(-theta) == -geneva.acceleration_ratio(theta));
  RC_ASSERT(geneva.jerk_ratio(-theta) == geneva.jerk_ratio(theta));
}

RC_GTEST_PROP(ExternalGenevaProperty, WheelEntersAndLeavesAtHalfPitchAtRest, ()) {
  const ExternalGeneva geneva(random_stations());
  const double theta = geneva.engagement_angle();
  RC_ASSERT(std::abs(geneva.wheel_angle(theta) - geneva.half_pitch()) < closed_form);
  RC_ASSERT(std::abs(geneva.wheel_angle(-theta) + geneva.half_pitch()) < closed_form);
  RC_ASSERT(std::abs(geneva.speed_ratio(theta)) < closed_form);
}

RC_GTEST_PROP(ExternalGenevaProperty, WheelNeverTurnsBackWithinTheEngagement, ()) {
  const ExternalGeneva geneva(random_stations());
  RC_ASSERT(geneva.speed_ratio(random_driver_angle(geneva)) > -closed_form);
}

RC_GTEST_PROP(ExternalGenevaProperty, NoAccelerationExceedsThePeak, ()) {
  const ExternalGeneva geneva(random_stations());
  const double acceleration = geneva.acceleration_ratio(random_driver_angle(geneva));
  RC_ASSERT(std::abs(acceleration) <= peak_acceleration(geneva) * (1. + closed_form));
}

}  // namespace
}  // namespace geneva::loads
