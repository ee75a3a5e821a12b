#include "loads/motion/four_bar_geneva.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "loads/motion/driven_mechanism.h"
#include "loads/motion/external_geneva.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/motion/differences.h"

namespace geneva::loads {
namespace {

using test::expect_consistent;
using test::expect_refused;

/// Symmetric coupler curve: BC = CD = BP.
FourBar symmetric() { return {{0., 0.}, {0.1, 0.}, 0.04, 0.12, 0.12, 0.12, pi / 2.}; }

/// AB = CD and AD = BC: the coupler does not turn, and every point of it goes round a circle.
FourBar parallelogram() { return {{0., 0.}, {0.1, 0.}, 0.04, 0.1, 0.04, 0.03, 0.7}; }

TEST(FourBarGeneva, TurnsTheWheelByAPitchBetweenTangencies) {
  for (const int n : {5, 6, 8, 12})
    for (const double direction : {20., 100., 150., 250.}) {
      const FourBarGeneva found =
          four_bar_geneva(n, symmetric(), Assembly::open, {direction * degree, std::nullopt});
      const Mechanism& mechanism = found.mechanism;
      EXPECT_NEAR(mechanism.motion(mechanism.entry).wheel_angle.value, -pi / n, 1e-9);
      EXPECT_NEAR(mechanism.motion(mechanism.exit).wheel_angle.value, pi / n, 1e-9);
      EXPECT_NEAR(mechanism.motion(0.).wheel_angle.value, 0., 1e-12);
      EXPECT_NEAR(tangency_defect(mechanism, mechanism.entry), 0., 1e-7);
      EXPECT_NEAR(tangency_defect(mechanism, mechanism.exit), 0., 1e-7);
      EXPECT_GT(mechanism.motion(0.).wheel_angle.first, 0.);
    }
}

TEST(FourBarGeneva, HasTheDerivativesOfItsPositions) {
  std::mt19937_64 random(1);
  int tested = 0;
  while (tested < 1000) {
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<>(low, high)(random);
    };
    const FourBar linkage{{0., 0.},          {between(0.9, 1.3), 0.}, between(0.2, 0.4),
                          between(0.9, 1.3), between(0.9, 1.3),       between(0.5, 1.5),
                          between(-3., 3.)};
    if (!crank_turns_fully(linkage)) continue;
    const int n = std::uniform_int_distribution<>(3, 12)(random);
    std::optional<FourBarGeneva> found;
    try {
      found = four_bar_geneva(n, linkage, Assembly::open, {between(-pi, pi), std::nullopt});
    } catch (const std::invalid_argument&) {
      continue;  // no place for such a wheel there
    }
    const Mechanism& mechanism = found->mechanism;
    for (int i = 0; i < 5; ++i) {
      const double angle = between(0.9 * mechanism.entry, 0.9 * mechanism.exit);
      // the pin may pass near to the wheel's axis, where everything is as sharp as that is near
      const SlotMotion at = mechanism.motion(angle);
      const double scale =
          0.3 / (1. + std::abs(at.wheel_angle.first) + std::sqrt(std::abs(at.wheel_angle.second)) +
                 std::cbrt(std::abs(at.wheel_angle.third)));
      expect_consistent([&](double t) { return mechanism.motion(t).wheel_angle; }, angle, scale,
                        "wheel angle");
      expect_consistent([&](double t) { return mechanism.motion(t).pin_distance; }, angle, scale,
                        "pin distance");
      ++tested;
    }
  }
}

TEST(FourBarGeneva, WithAParallelogramIsTheExternalGeneva) {
  for (const auto& [n, direction] :
       std::vector<std::pair<int, double>>{{4, 95.}, {5, 0.}, {6, 180.}, {9, -20.}}) {
    const FourBarGeneva found =
        four_bar_geneva(n, parallelogram(), Assembly::open, {direction * degree, std::nullopt});
    const Mechanism plain = external_geneva(n, 0.04 / std::sin(pi / n));
    EXPECT_NEAR(found.mechanism.exit, plain.exit, 1e-10);
    for (const double part : {-0.95, -0.5, 0., 0.3, 0.8}) {
      const SlotMotion motion = found.mechanism.motion(part * plain.exit);
      const SlotMotion wanted = plain.motion(part * plain.exit);
      EXPECT_NEAR(motion.wheel_angle.value, wanted.wheel_angle.value, 1e-10);
      EXPECT_NEAR(motion.wheel_angle.first, wanted.wheel_angle.first, 1e-10);
      EXPECT_NEAR(motion.wheel_angle.second, wanted.wheel_angle.second, 1e-9);
      EXPECT_NEAR(motion.pin_distance.value, wanted.pin_distance.value, 1e-10);
    }
  }
}

TEST(FourBarGeneva, OffItsTangentPlaceLeavesTheSlotAtAnAngle) {
  const WheelPlace tangent{150. * degree, std::nullopt};
  const double distance = four_bar_geneva(6, symmetric(), Assembly::open, tangent).centre_distance;
  const Mechanism nearer =
      four_bar_geneva(6, symmetric(), Assembly::open, {150. * degree, 0.98 * distance}).mechanism;
  EXPECT_NEAR(tangency_defect(nearer, nearer.entry), 0., 1e-7);
  EXPECT_GT(tangency_defect(nearer, nearer.exit), 1. * degree);
  EXPECT_NEAR(nearer.motion(nearer.exit).wheel_angle.value, 30. * degree, 1e-9);
  const auto pins = engagements(nearer, {0.});
  const DrivenMechanism driven(nearer, pins, constant_speed(nearer, pins, 1.));
  ASSERT_EQ(driven.unbounded().size(), 1U);
  EXPECT_EQ(driven.unbounded()[0].quantity, "wheel acceleration");
  EXPECT_NEAR(driven.unbounded()[0].driver_angle, nearer.exit, 1e-12);
  expect_refused(
      [&] {
        four_bar_geneva(6, symmetric(), Assembly::open, {150. * degree, 1.1 * distance});
      },
      {"centre distance is", "at most", "turns by 60 deg", "leave it out"});
}

TEST(FourBarGeneva, RefusesAnEngagementInWhichTheLinkageCanGoOnInTwoWays) {
  FourBar linkage = parallelogram();
  expect_refused(
      [&] {
        four_bar_geneva(6, linkage, Assembly::crossed, {0., std::nullopt});
      },
      {"AB 40, BC 100, CD 40 and AD 100 mm", "crank angle of 0 deg", "in two ways", "shorter"});
  linkage.crank = 0.039;
  EXPECT_NO_THROW(four_bar_geneva(6, linkage, Assembly::crossed, {0., std::nullopt}));
}

TEST(FourBarGeneva, RefusesALinkageWhoseCrankDoesNotTurn) {
  FourBar linkage = symmetric();
  linkage.crank = 0.2;
  expect_refused(
      [&] {
        four_bar_geneva(6, linkage, Assembly::open, {0., std::nullopt});
      },
      {"crank of 200 mm does not turn fully", "Grashof"});
  linkage.crank = 1.;
  expect_refused(
      [&] {
        four_bar_geneva(6, linkage, Assembly::open, {0., std::nullopt});
      },
      {"cannot be closed"});
  expect_refused(
      [&] {
        four_bar_geneva(2, symmetric(), Assembly::open, {0., std::nullopt});
      },
      {"number of stations is 2"});
}

}  // namespace
}  // namespace geneva::loads
