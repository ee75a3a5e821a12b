#include "loads/motion/kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "loads/motion/external_geneva.h"
#include "loads/motion/four_bar_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/motion/long_dwell_geneva.h"
#include "loads/motion/spherical_geneva.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

using test::expect_refused;

constexpr double c = 0.1;
constexpr WheelTrain inertia_only{2e-3, {1e-3, 0.}, 0., 0., 0.015};
const PinContact contact{1.1e11, 0.02, 0.015};

DrivenMechanism steady(const Mechanism& mechanism, double speed = 10.,
                       const std::vector<double>& pins = {0.}) {
  const auto all = engagements(mechanism, pins);
  return {mechanism, all, constant_speed(mechanism, all, speed)};
}

Characteristics of(const DrivenMechanism& driven) {
  return characteristics(driven, inertia_only, contact);
}

/// ME341 lecture, example: n = 6, 360 rpm, with the right values where it prints others.
TEST(Me341Example, SixStationsAt360Rpm) {
  const double omega = 12. * pi;
  const Characteristics values = of(steady(external_geneva(6, c), omega));
  EXPECT_NEAR(values.motion_time, 1. / 18., 1e-14);
  ASSERT_EQ(values.dwell_times.size(), 1U);
  EXPECT_NEAR(values.dwell_times[0], 1. / 9., 1e-14) << "printed: 0.0555 s";
  EXPECT_NEAR(values.motion_fraction, 1. / 3., 1e-13) << "printed as the dwell fraction";
  EXPECT_NEAR(values.speed_ratio.value * omega, 37.699, 5e-4);
  EXPECT_NEAR(values.acceleration_ratio.value, 1.3496, 5e-5) << "printed: 1.372";
  EXPECT_NEAR(values.acceleration_ratio.value * omega * omega, 1918.14, 5e-3) << "printed: 1950";
  EXPECT_NEAR(values.acceleration_ratio.driver_angle / degree, -22.903, 5e-4);
  EXPECT_NEAR(values.engagement_angle / degree, 120., 1e-12);
}

/// ME341 lecture: jerk at the line of centres; the wheel's acceleration falls there.
TEST(Me341Eq532, JerkAtTheLineOfCentres) {
  const std::vector<std::pair<int, double>> rows{{3, 672.02}, {4, 48.042}, {5, 13.324}, {6, 6.}};
  for (const auto& [n, jerk] : rows)
    EXPECT_NEAR(of(steady(external_geneva(n, c))).jerk_ratio_at_centre, -jerk,
                jerk > 100. ? 5e-3 : 5e-4);
}

TEST(Lecture4, TimesOfExternalAndInternalGenevas) {
  for (int n = 3; n <= 24; ++n) {
    const Characteristics external = of(steady(external_geneva(n, c)));
    const Characteristics internal = of(steady(internal_geneva(n, c)));
    EXPECT_NEAR(external.time_ratio, (n - 2.) / (n + 2.), 1e-12);
    EXPECT_NEAR(internal.time_ratio, (n + 2.) / (n - 2.), 1e-10);
    EXPECT_NEAR(external.engagement_angle, pi * (1. - 2. / n), 1e-12);
    EXPECT_NEAR(internal.engagement_angle, pi * (1. + 2. / n), 1e-12);
    EXPECT_NEAR(internal.acceleration_ratio.value, std::tan(pi / n), 1e-9);
    EXPECT_NEAR(internal.acceleration_ratio.driver_angle, -internal.engagement_angle / 2., 1e-9)
        << "at entry";
    EXPECT_NEAR(internal.entry_acceleration_ratio, std::tan(pi / n), 1e-12);
  }
}

TEST(Lecture4, PlaceOfTheMaximumAccelerationOfTheSphericalGeneva) {
  const std::vector<std::pair<int, double>> rows{{3, 18.28}, {4, 30.36}, {5, 41.31}, {6, 53.26}};
  for (const auto& [n, angle] : rows)
    EXPECT_NEAR(
        of(steady(spherical_geneva(n, pi / 2., c))).acceleration_ratio.driver_angle / degree,
        -angle, 5e-3);
  EXPECT_NEAR(of(steady(spherical_geneva(8, pi / 2., c))).acceleration_ratio.driver_angle / degree,
              -90., 1e-6)
      << "at entry";
}

TEST(Lecture4, LongDwellGrowsWithTheSpacing) {
  const double r = 0.05;
  double last = 0.;
  for (const double spacing : {0., 0.1, 0.3}) {
    const Characteristics values =
        of(steady(long_dwell_geneva(6, r, spacing, SprocketLine::along_line_of_centres)));
    EXPECT_NEAR(values.dwell_times.at(0),
                (2. * pi + 2. * spacing / r - values.engagement_angle) / 10., 1e-12);
    EXPECT_GT(values.dwell_times.at(0), last);
    last = values.dwell_times.at(0);
  }
}

/// Maximum force over that at the maximum acceleration without friction, and its place.
TEST(Johnson1956, Eq1LeavesOutThatTheArmStillShrinks) {
  const std::vector<std::array<double, 3>> rows{{3., 1.0176, 4.12},  {4., 1.0172, 9.94},
                                                {5., 1.0167, 15.27}, {6., 1.0160, 19.965},
                                                {8., 1.0144, 27.76}, {10., 1.0129, 34.01}};
  for (const auto& [n, ratio, angle] : rows) {
    const Characteristics values = of(steady(external_geneva(static_cast<int>(n), c)));
    EXPECT_NEAR(values.force_ratio, ratio, 5e-5);
    EXPECT_NEAR(values.force.driver_angle / degree, -angle, 5.1e-3);
    EXPECT_NEAR(values.braking_force.value / values.force.value, 1., 1e-9) << "mirrored";
    EXPECT_NEAR(values.pressure_ratio, std::sqrt(values.force_ratio), 1e-9);
    EXPECT_GT(values.pressure_times_slip_ratio, 1.);
  }
}

/// Friction jumps where slip reverses, and slip where a chain link stops turning: the maximum
/// values are those of the side on which they are greater.
TEST(Characteristics, AreExceededAtNoInstant) {
  WheelTrain train{2e-3, {1e-3, 0.2}, 0., 0.3, 0.015};
  const std::vector<Mechanism> mechanisms{
      external_geneva(4, c),
      internal_geneva(6, c),
      spherical_geneva(5, 1.2, c),
      long_dwell_geneva(6, 0.04, 0.012, SprocketLine::across_line_of_centres),
      long_dwell_geneva(5, 0.04, 0.06, SprocketLine::along_line_of_centres),
      four_bar_geneva(6, {{0., 0.}, {0.1, 0.}, 0.04, 0.12, 0.12, 0.12, pi / 2.}, Assembly::open,
                      {150. * degree, std::nullopt})
          .mechanism};
  for (const bool is_roller : {false, true})
    for (const Mechanism& mechanism : mechanisms) {
      if (is_roller) train.roller = RollerBore{0.008, 0.4};
      const DrivenMechanism driven = steady(mechanism, 20.);
      const Characteristics values = characteristics(driven, train, contact);
      PlacedPeak force{}, braking{}, slip{}, bore{}, speed{}, jerk{};
      const auto raise = [](PlacedPeak& peak, double value) {
        peak.value = std::max(peak.value, value);
      };
      for (const KinematicsRow& row : kinematics_rows(driven, train, contact, 40000)) {
        raise(force, row.load.force);
        raise(braking, -row.load.force);
        raise(slip, row.pressure * std::abs(row.load.slip_speed));
        if (row.load.wall != Wall::none) raise(speed, std::abs(row.load.slip_speed));
        if (row.motion.pin) raise(jerk, std::abs(row.motion.wheel_angle.third));
        raise(bore, bore_pressure(contact, train, row.load.force) * row.load.bore_speed);
      }
      const auto expect_peak = [&](const PlacedPeak& found, const PlacedPeak& sampled) {
        EXPECT_GE(found.value, sampled.value * (1. - 1e-12)) << mechanism.name;
        EXPECT_LE(found.value, sampled.value * (1. + 1e-3)) << mechanism.name << ": not attained";
      };
      expect_peak(values.force, force);
      expect_peak(values.braking_force, braking);
      expect_peak(values.pressure_times_slip, slip);
      expect_peak(values.bore_pressure_times_speed, bore);
      expect_peak(values.slip_speed, speed);
      jerk.value /= std::pow(driven.drive().reference_speed, 3);
      expect_peak(values.jerk_ratio, jerk);
      EXPECT_EQ(values.pressure_times_slip.value > 0., !is_roller);
      EXPECT_EQ(values.bore_pressure_times_speed.value > 0., is_roller);
      // the place is on the side of the greater value
      const PinLoad there = pin_load(driven.at_engaged_angle(values.force.driver_angle), train);
      EXPECT_NEAR(there.force, values.force.value, 1e-8 * values.force.value) << mechanism.name;
    }
}

TEST(Characteristics, OfUnequalPinsHaveEachDwell) {
  const Characteristics values = of(steady(external_geneva(6, c), 1., {0., 150. * degree}));
  ASSERT_EQ(values.dwell_times.size(), 2U);
  EXPECT_NEAR(values.dwell_times[0], 30. * degree, 1e-12);
  EXPECT_NEAR(values.dwell_times[1], 90. * degree, 1e-12);
  EXPECT_NEAR(values.motion_fraction, 2. / 3., 1e-12);
}

TEST(Rows, CoverTheCycleAndTheEndsOfTheEngagements) {
  const DrivenMechanism driven = steady(external_geneva(5, c));
  const auto rows = kinematics_rows(driven, inertia_only, contact, 100);
  EXPECT_EQ(rows.size(), 101U) << "the ends are 15 steps from the middle";
  EXPECT_NEAR(rows.front().load.driver_angle, -pi, 1e-12);
  EXPECT_NEAR(rows.back().load.driver_angle, pi, 1e-12);
  int engaged = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0) {
      EXPECT_GT(rows[i].load.time, rows[i - 1].load.time);
    }
    const bool is_in_slot = std::abs(rows[i].load.driver_angle) < 54.000001 * degree;
    EXPECT_EQ(rows[i].motion.pin.has_value(), is_in_slot);
    EXPECT_EQ(rows[i].pressure > 0., rows[i].load.force != 0.);
    engaged += is_in_slot ? 1 : 0;
  }
  EXPECT_EQ(engaged, 31);
  expect_refused([&] { kinematics_rows(driven, inertia_only, contact, 0); },
                 {"number of steps is 0"});
}

TEST(Rows, HaveHertzsPressure) {
  const auto rows = kinematics_rows(steady(external_geneva(5, c)), inertia_only, contact, 100);
  for (const KinematicsRow& row : rows) {
    // p0^2 = F E*/(pi R t)
    EXPECT_NEAR(row.pressure * row.pressure,
                std::abs(row.load.force) * 1.1e11 / (pi * 0.0075 * 0.02),
                1e-12 * row.pressure * row.pressure);
  }
}

}  // namespace
}  // namespace geneva::loads
