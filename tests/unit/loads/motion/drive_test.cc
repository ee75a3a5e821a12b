#include "loads/motion/drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "loads/motion/driven_mechanism.h"
#include "loads/motion/external_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/motion/differences.h"

namespace geneva::loads {
namespace {

using test::expect_consistent;
using test::expect_refused;

constexpr double c = 0.1;
constexpr double motion_time = 0.2;
using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<>(low, high)(random);
}

DrivenMechanism on_carrier(int stations, MotionLaw law) {
  const Mechanism mechanism = external_geneva(stations, c);
  const auto pins = engagements(mechanism, {0.});
  return {mechanism, pins, law_on_carrier(mechanism, pins, law, motion_time)};
}

DrivenMechanism on_cross(PlaneGeneva kind, int stations, MotionLaw law) {
  const Mechanism mechanism =
      kind == PlaneGeneva::external ? external_geneva(stations, c) : internal_geneva(stations, c);
  const auto pins = engagements(mechanism, {0.});
  return {mechanism, pins, law_on_cross(mechanism, kind, c, pins, law, motion_time)};
}

/// Carrier speed over (carrier engagement)/(motion time).
double carrier_speed(const DrivenMechanism& driven, double k) {
  return driven.at_time((k - 0.5) * motion_time).driver_angle.first /
         driven.drive().reference_speed;
}

TEST(KolomietsEq7, HarmonicLawOnTheCrossOfSixStations) {
  const DrivenMechanism driven = on_cross(PlaneGeneva::external, 6, MotionLaw::harmonic);
  EXPECT_NEAR(carrier_speed(driven, 0.), 1.42847, 5e-6);
  EXPECT_NEAR(carrier_speed(driven, 1.), 1.42847, 5e-6);
  EXPECT_NEAR(carrier_speed(driven, 0.5), 0.78540, 5e-6);
  EXPECT_TRUE(driven.unbounded().empty());
}

TEST(KolomietsEq7, CycloidalLawOnTheCrossOfSixStations) {
  const DrivenMechanism driven = on_cross(PlaneGeneva::external, 6, MotionLaw::cycloidal);
  EXPECT_NEAR(carrier_speed(driven, 0.), 0., 1e-12);
  EXPECT_NEAR(carrier_speed(driven, 0.5), 1., 1e-12);
  // k^(-1/2): a quarter of the time, twice the acceleration
  const auto acceleration = [&](double k) {
    return driven.at_time((k - 0.5) * motion_time).driver_angle.second;
  };
  EXPECT_NEAR(acceleration(2.5e-7) / acceleration(1e-6), 2., 1e-5);
  ASSERT_EQ(driven.unbounded().size(), 2U);
  EXPECT_EQ(driven.unbounded()[0].quantity, "driver acceleration");
  EXPECT_NEAR(driven.unbounded()[0].driver_angle, -60. * degree, 1e-12);
  EXPECT_NEAR(driven.unbounded()[1].driver_angle, 60. * degree, 1e-12);
}

TEST(KolomietsEq7, TheCarrierTurnsTheCrossByTheLaw) {
  Random random(1);
  for (int i = 0; i < 1000; ++i)
    for (const PlaneGeneva kind : {PlaneGeneva::external, PlaneGeneva::internal})
      for (const MotionLaw law : {MotionLaw::cycloidal, MotionLaw::harmonic}) {
        const int n = std::uniform_int_distribution<>(3, 24)(random);
        const DrivenMechanism driven = on_cross(kind, n, law);
        const double k = between(random, 0.01, 0.99);
        const MotionState state = driven.at_time((k - 0.5) * motion_time);
        EXPECT_NEAR(state.slot_angle, pi / n * (2. * progress(law, k).value - 1.), 1e-13);
        // the mechanism at the carrier's angle says the same
        const SlotMotion direct = driven.mechanism().motion(state.driver_angle.value);
        EXPECT_NEAR(direct.wheel_angle.value, state.slot_angle, 1e-12);
        EXPECT_NEAR(direct.pin_distance.value, state.pin_distance.value, 1e-13);
        const Jet composed = chain(direct.wheel_angle, state.driver_angle);
        const double size = std::abs(state.wheel_angle.second) + 1. / (motion_time * motion_time);
        EXPECT_NEAR(composed.first, state.wheel_angle.first, 1e-7 * size * motion_time);
        EXPECT_NEAR(composed.second, state.wheel_angle.second, 1e-6 * size);
      }
}

TEST(KolomietsLawOnTheCarrier, IsEq530ComposedWithTheLaw) {
  for (const MotionLaw law : {MotionLaw::cycloidal, MotionLaw::harmonic}) {
    const DrivenMechanism driven = on_carrier(6, law);
    const ExternalGeneva geneva(6);
    for (const double k : {0.1, 0.3, 0.5, 0.8}) {
      const MotionState state = driven.at_time((k - 0.5) * motion_time);
      const Jet a = progress(law, k);
      const double theta = 120. * degree * (a.value - 0.5);
      const double speed = 120. * degree * a.first / motion_time;
      const double acceleration = 120. * degree * a.second / (motion_time * motion_time);
      EXPECT_NEAR(state.wheel_angle.value, geneva.wheel_angle(theta), 1e-13);
      EXPECT_NEAR(state.wheel_angle.second, geneva.wheel_acceleration(theta, speed, acceleration),
                  1e-9);
    }
    EXPECT_NEAR(driven.at_time(-0.5 * motion_time).wheel_angle.second, 0., 1e-9)
        << "no soft impact";
    EXPECT_TRUE(driven.unbounded().empty());
  }
}

TEST(Drives, HaveTheDerivativesOfTheirAngles) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const int n = std::uniform_int_distribution<>(3, 24)(random);
    const double k = between(random, 0.1, 0.9);
    const double time = (k - 0.5) * motion_time;
    for (const MotionLaw law : {MotionLaw::cycloidal, MotionLaw::harmonic}) {
      if (std::abs(k - 0.5) < 0.01) continue;  // the two halves are written apart
      for (const DrivenMechanism& driven :
           {on_carrier(n, law), on_cross(PlaneGeneva::external, n, law),
            on_cross(PlaneGeneva::internal, n, law)}) {
        // the wheel of 3 stations moves 6.5 times as fast as its carrier midway
        const double scale =
            0.1 * motion_time / (1. + driven.mechanism().motion(0.).wheel_angle.first);
        expect_consistent([&](double t) { return driven.at_time(t).driver_angle; }, time, scale,
                          "driver angle");
        expect_consistent([&](double t) { return driven.at_time(t).wheel_angle; }, time, scale,
                          "wheel angle");
        expect_consistent([&](double t) { return driven.at_time(t).pin_distance; }, time, scale,
                          "pin distance");
      }
    }
  }
}

TEST(ConstantAcceleration, IsEq529WithTheDriversTerm) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const int n = std::uniform_int_distribution<>(3, 24)(random);
    const ExternalGeneva geneva(n);
    const Mechanism mechanism = external_geneva(n, c);
    const auto pins = engagements(mechanism, {0.});
    const double speed = between(random, 1., 100.);
    const double acceleration = between(random, -0.2, 0.2) * speed * speed;
    const DrivenMechanism driven(mechanism, pins,
                                 constant_acceleration(mechanism, pins, speed, acceleration));
    const double theta = between(random, -1., 1.) * mechanism.exit;
    const MotionState state = driven.at_engaged_angle(theta);
    const double squared = speed * speed + 2. * acceleration * theta;
    EXPECT_NEAR(state.driver_angle.value, theta, 1e-13);
    EXPECT_NEAR(state.driver_angle.first * state.driver_angle.first, squared, 1e-11 * squared);
    const double wanted = geneva.wheel_acceleration(theta, std::sqrt(squared), acceleration);
    EXPECT_NEAR(state.wheel_angle.second, wanted, 1e-9 * speed * speed);
  }
}

TEST(ConstantAcceleration, RefusesADriverThatWouldStandStill) {
  const Mechanism mechanism = external_geneva(6, c);
  const auto pins = engagements(mechanism, {0.});
  expect_refused([&] { constant_acceleration(mechanism, pins, 10., -1e4); },
                 {"driver acceleration is -10000", "stand still", "must be between -47.7"});
  expect_refused([&] { constant_speed(mechanism, pins, 0.); },
                 {"driver speed is 0 rad/s", "positive"});
}

TEST(Table, OfUniformRotationIsConstantSpeed) {
  const Mechanism mechanism = external_geneva(6, c);
  const auto pins = engagements(mechanism, {0.});
  std::vector<double> times;
  std::vector<double> angles;
  for (int i = 0; i <= 36; ++i) {
    times.push_back(0.01 * i);
    angles.push_back((10. * i - 180.) * degree);
  }
  const DrivenMechanism tabulated(mechanism, pins, table(pins, times, angles));
  const double speed = 10. * degree / 0.01;
  const DrivenMechanism steady(mechanism, pins, constant_speed(mechanism, pins, speed));
  EXPECT_NEAR(tabulated.drive().reference_speed, speed, 1e-10);
  EXPECT_NEAR(tabulated.dwells().at(0), steady.dwells().at(0), 1e-12);
  for (const double angle : {-55., -20., 0., 33., 60.}) {
    const MotionState found = tabulated.at_engaged_angle(angle * degree);
    const MotionState wanted = steady.at_engaged_angle(angle * degree);
    EXPECT_NEAR(found.wheel_angle.value, wanted.wheel_angle.value, 1e-12);
    EXPECT_NEAR(found.wheel_angle.second, wanted.wheel_angle.second, 1e-7);
  }
}

TEST(Table, RefusesWhatIsNoMotion) {
  const Mechanism mechanism = external_geneva(6, c);
  const auto pins = engagements(mechanism, {0.});
  expect_refused([&] { table(pins, {}, {}); }, {"0 rows", "four or more"});
  expect_refused(
      [&] {
        table(pins, {0., 2., 1., 3.}, {-2., -1., 1., 2.});
      },
      {"row 3", "1 s", "after 2 s", "sort the table"});
  expect_refused([&] { table(pins, {0., 1., 2., 3.}, {-2., 1., 0., 2.}); }, {"row 3", "grow"});
  expect_refused(
      [&] {
        table(pins, {0., 1., 2., 3.}, {0., 0.1, 0.2, 0.3});
      },
      {"covers no engagement", "from -60 to 60 deg"});
  expect_refused(
      [&] {
        table(pins, {0., 1., 2., 3., 4.}, {-4., -3.99, -3.98, 3.98, 4.});
      },
      {"stand still or turn back"});
}

TEST(Cycle, OfOnePinHasOneMotionAndOneDwell) {
  for (int n = 3; n <= 24; ++n) {
    const Mechanism mechanism = external_geneva(n, c);
    const auto pins = engagements(mechanism, {0.});
    const DrivenMechanism driven(mechanism, pins, constant_speed(mechanism, pins, 2. * pi));
    ASSERT_EQ(driven.engagements().size(), 1U);
    const double motion = driven.engagements()[0].end - driven.engagements()[0].begin;
    EXPECT_NEAR(motion, (n - 2.) / (2. * n), 1e-12);
    ASSERT_EQ(driven.dwells().size(), 1U);
    EXPECT_NEAR(motion / driven.dwells()[0], (n - 2.) / (n + 2.), 1e-12) << "k_t of Lecture 4";
  }
}

TEST(Cycle, OfSeveralPinsStepsTheWheelOnByAPitchEach) {
  const Mechanism mechanism = external_geneva(6, c);
  const auto pins = engagements(mechanism, {0., 150. * degree});
  const DrivenMechanism driven(mechanism, pins, constant_speed(mechanism, pins, 1.));
  EXPECT_NEAR(driven.dwells().at(0), 30. * degree, 1e-12);
  EXPECT_NEAR(driven.dwells().at(1), 90. * degree, 1e-12);
  EXPECT_NEAR(driven.at_time(-80. * degree).wheel_angle.value, -30. * degree, 1e-12);
  EXPECT_NEAR(driven.at_time(0.).wheel_angle.value, 0., 1e-12);
  EXPECT_NEAR(driven.at_time(75. * degree).wheel_angle.value, 30. * degree, 1e-12);
  EXPECT_FALSE(driven.at_time(75. * degree).pin);
  EXPECT_NEAR(driven.at_time(150. * degree).wheel_angle.value, 60. * degree, 1e-12);
  EXPECT_EQ(*driven.at_time(150. * degree).pin, 1U);
  EXPECT_NEAR(driven.at_time(230. * degree).wheel_angle.value, 90. * degree, 1e-12);
  expect_refused([&] { static_cast<void>(driven.at_engaged_angle(75. * degree)); },
                 {"driver angle is 75 deg", "from -60 deg to 60 deg, from 90 deg to 210 deg"});
}

}  // namespace
}  // namespace geneva::loads
