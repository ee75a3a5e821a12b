#include "loads/motion/cycle_instants.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "loads/motion/cubic_spline.h"
#include "loads/motion/external_geneva.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/random_values.h"

namespace geneva::loads {
namespace {

using test::between;
using test::expect_refused;
using test::uniform;

constexpr PinContact contact{1e11, 0.02, 0.015};

DrivenMechanism driven(const int stations, const std::vector<double>& pins = {0.}) {
  const Mechanism mechanism = external_geneva(stations, 0.1);
  const auto stays = engagements(mechanism, pins);
  return {mechanism, stays, constant_acceleration(mechanism, stays, 60., 0.)};
}

WheelTrain train(const double friction_moment, const double slot_friction = 0.) {
  return {2e-3, {1e-3, friction_moment}, 0., slot_friction, 0.015};
}

std::size_t count(const CycleInstants& chosen, const InstantRole role) {
  return static_cast<std::size_t>(
      std::count_if(chosen.instants.begin(), chosen.instants.end(),
                    [&](const CycleInstant& instant) { return instant.role == role; }));
}

/// Instants of one wall without a jump between them, with the changes of wall as ends without
/// force.
std::vector<std::vector<std::array<double, 2>>> smooth_runs(const DrivenMechanism& mechanism,
                                                            const CycleInstants& chosen) {
  std::vector<std::vector<std::array<double, 2>>> runs(1);
  std::vector<double> zeros;
  for (const double angle : chosen.wall_changes) zeros.push_back(mechanism.drive().time_at(angle));
  const CycleInstant* last = nullptr;
  for (const CycleInstant& instant : chosen.instants) {
    if (instant.role == InstantRole::greatest_force ||
        instant.role == InstantRole::greatest_braking_force ||
        instant.role == InstantRole::greatest_pressure_times_slip)
      continue;  // beside the spline
    const double time = instant.load.time;
    const auto zero = std::find_if(zeros.begin(), zeros.end(), [&](const double change) {
      return last != nullptr && last->load.time < change && change < time;
    });
    const bool is_jump = last != nullptr && time - last->load.time < 1e-7 * mechanism.drive().end;
    if (zero != zeros.end()) {
      runs.back().push_back({*zero, 0.});
      runs.push_back({{*zero, 0.}});
    } else if (is_jump) {
      runs.emplace_back();
    }
    runs.back().push_back({time, instant.load.force});
    last = &instant;
  }
  return runs;
}

RC_GTEST_PROP(CycleInstants, GiveTheForceByASplineThroughThem, ()) {
  const int stations = uniform(3, 11);
  const DrivenMechanism mechanism = driven(stations);
  const WheelTrain loaded = train(between(0., 5.), between(0., 0.3));
  const double tolerance = std::pow(10., between(-3., -1.5));
  const CycleInstants chosen = cycle_instants(mechanism, loaded, contact, tolerance);
  double greatest = 0.;
  for (const CycleInstant& instant : chosen.instants)
    greatest = std::max(greatest, std::abs(instant.load.force));
  for (const auto& run : smooth_runs(mechanism, chosen)) {
    if (run.size() < 5) continue;
    std::vector<double> times;
    std::vector<double> forces;
    for (const auto& [time, force] : run) {
      times.push_back(time);
      forces.push_back(force);
    }
    const CubicSpline spline(times, forces);
    for (int i = 1; i < 200; ++i) {
      const double time = times.front() + (times.back() - times.front()) * i / 200.;
      const double exact = pin_load(mechanism.at_time(time), loaded).force;
      RC_ASSERT(std::abs(spline(time).value - exact) < 2. * tolerance * greatest);
    }
  }
}

TEST(CycleInstants, AreFewWhereTheForceIsSmooth) {
  const CycleInstants chosen = cycle_instants(driven(4), train(0.), contact, 5e-3);
  EXPECT_LT(chosen.instants.size(), 40U);
  EXPECT_EQ(count(chosen, InstantRole::entry), 1U);
  EXPECT_EQ(count(chosen, InstantRole::exit), 1U);
  EXPECT_EQ(count(chosen, InstantRole::greatest_force), 1U);
  EXPECT_EQ(count(chosen, InstantRole::greatest_braking_force), 1U);
  EXPECT_EQ(count(chosen, InstantRole::greatest_pressure_times_slip), 1U);
  EXPECT_EQ(count(chosen, InstantRole::jump), 0U) << "slip turns round without friction";
  EXPECT_TRUE(std::is_sorted(chosen.instants.begin(), chosen.instants.end(),
                             [](const CycleInstant& one, const CycleInstant& other) {
                               return one.load.time < other.load.time;
                             }));
}

TEST(CycleInstants, StandOnBothSidesOfTheReversalOfSlip) {
  const DrivenMechanism mechanism = driven(4);
  const CycleInstants chosen = cycle_instants(mechanism, train(0., 0.3), contact, 5e-3);
  const double reversal = slip_reversals(mechanism.mechanism(), 0.015).front().driver_angle;
  double inwards = 0.;
  double outwards = 0.;
  for (const CycleInstant& instant : chosen.instants) {
    if (instant.load.wall != Wall::driving || std::abs(instant.load.driver_angle - reversal) > 1e-6)
      continue;
    (instant.load.slip_speed < 0. ? inwards : outwards) = instant.load.force;
  }
  EXPECT_GT(inwards, 0.);
  EXPECT_GT(outwards, inwards) << "friction helps the force up to there, and hinders it then";
}

struct WallChange {
  int stations;
  double ratio;  // friction moment over that of the inertia at the greatest acceleration
  double angle;  // degrees
};

class TheWallChanges : public testing::TestWithParam<WallChange> {};

TEST_P(TheWallChanges, WhereTheForceIsNothing) {
  const DrivenMechanism mechanism = driven(GetParam().stations);
  const double peak =
      mechanism.at_engaged_angle(peak_acceleration_angle(mechanism)).wheel_angle.second;
  const CycleInstants chosen =
      cycle_instants(mechanism, train(GetParam().ratio * 3e-3 * peak), contact, 5e-3);
  ASSERT_FALSE(chosen.wall_changes.empty());
  EXPECT_NEAR(chosen.wall_changes.front() / degree, GetParam().angle, 5.1e-5);
}

INSTANTIATE_TEST_SUITE_P(ByTheFrictionMoment, TheWallChanges,
                         testing::Values(WallChange{3, 0.05, 0.1339}, WallChange{4, 0.05, 0.3226},
                                         WallChange{4, 0.2, 1.3008}, WallChange{4, 0.5, 3.4182},
                                         WallChange{6, 0.2, 2.5998}, WallChange{8, 0.5, 9.4475}));

TEST(CycleInstants, ChangeTheWallTwiceWhereFrictionExceedsTheInertiaAtExit) {
  const DrivenMechanism mechanism = driven(4);
  const double peak =
      mechanism.at_engaged_angle(peak_acceleration_angle(mechanism)).wheel_angle.second;
  EXPECT_EQ(cycle_instants(mechanism, train(0.1 * 3e-3 * peak), contact, 5e-3).wall_changes.size(),
            1U);
  EXPECT_EQ(cycle_instants(mechanism, train(0.3 * 3e-3 * peak), contact, 5e-3).wall_changes.size(),
            2U);
  EXPECT_TRUE(
      cycle_instants(mechanism, train(1.1 * 3e-3 * peak), contact, 5e-3).wall_changes.empty());
}

TEST(CycleInstants, LeaveOutEqualEngagements) {
  const CycleInstants chosen = cycle_instants(driven(4, {0., pi}), train(1.), contact, 5e-3);
  EXPECT_EQ(chosen.left_out, 1U);
  for (const CycleInstant& instant : chosen.instants) EXPECT_EQ(instant.engagement, 0U);
}

TEST(EvenInstants, GoFromEntryToExitWithoutThoseThatPressNothing) {
  const CycleInstants chosen = even_instants(driven(4), train(0.), 41);
  ASSERT_EQ(chosen.instants.size(), 40U) << "nothing presses in the middle";
  EXPECT_NEAR(chosen.instants.front().load.driver_angle / degree, -45., 1e-9);
  EXPECT_NEAR(chosen.instants.back().load.driver_angle / degree, 45., 1e-9);
  expect_refused([] { even_instants(driven(4), train(0.), 2); }, {"instants is 2", "3 or more"});
}

TEST(CycleInstants, AreRefusedWhereNothingEverPresses) {
  const WheelTrain unloaded{0., {0., 0.}};
  expect_refused([&] { cycle_instants(driven(4), unloaded, contact, 5e-3); },
                 {"never presses", "inertia"});
}

}  // namespace
}  // namespace geneva::loads
