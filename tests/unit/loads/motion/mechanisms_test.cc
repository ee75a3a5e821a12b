#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "loads/motion/external_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/motion/long_dwell_geneva.h"
#include "loads/motion/spherical_geneva.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/motion/differences.h"

namespace geneva::loads {
namespace {

using test::expect_consistent;
using test::expect_refused;

constexpr double c = 0.1;
using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<>(low, high)(random);
}
int stations(Random& random) { return std::uniform_int_distribution<>(3, 24)(random); }

/// Maximum |f| over the engagement, on a fine grid; the ends are on it.
double maximum(const Mechanism& mechanism, double Jet::*derivative) {
  double result = 0.;
  for (int i = 0; i <= 20000; ++i) {
    const double angle = mechanism.entry + (mechanism.exit - mechanism.entry) * i / 20000.;
    result = std::max(result, std::abs(mechanism.motion(angle).wheel_angle.*derivative));
  }
  return result;
}

struct Row {
  int stations;
  double external_speed, external_acceleration;
  double internal_speed, internal_acceleration;
  double spherical_speed, spherical_acceleration;
};

class Lecture4Table : public testing::TestWithParam<Row> {};

/// Half a unit of the last digit given.
void expect_digits(double found, double given) {
  EXPECT_NEAR(found, given, given > 10. ? 5.1e-4 : given > 1. ? 5.1e-5 : 5.1e-6);
}

TEST_P(Lecture4Table, MaximumSpeedAndAcceleration) {
  const Row row = GetParam();
  const Mechanism external = external_geneva(row.stations, c);
  const Mechanism internal = internal_geneva(row.stations, c);
  const Mechanism spherical = spherical_geneva(row.stations, pi / 2., c);
  expect_digits(maximum(external, &Jet::first), row.external_speed);
  expect_digits(maximum(external, &Jet::second), row.external_acceleration);
  expect_digits(maximum(internal, &Jet::first), row.internal_speed);
  expect_digits(maximum(internal, &Jet::second), row.internal_acceleration);
  expect_digits(maximum(spherical, &Jet::first), row.spherical_speed);
  expect_digits(maximum(spherical, &Jet::second), row.spherical_acceleration);
}

INSTANTIATE_TEST_SUITE_P(
    UnitDriverSpeed, Lecture4Table,
    testing::Values(Row{3, 6.4641, 31.392, 0.46410, 1.73205, 1.73205, 2.1716},
                    Row{4, 2.41421, 5.4070, 0.41421, 1.0, 1.0, 0.88009},
                    Row{5, 1.42592, 2.2988, 0.37019, 0.72654, 0.72654, 0.57875},
                    Row{6, 1.0, 1.3496, 0.33333, 0.57735, 0.57735, 0.45597},
                    Row{8, 0.61991, 0.69976, 0.27677, 0.41421, 0.41421, 0.35355}),
    [](const testing::TestParamInfo<Row>& row) {
      return std::to_string(row.param.stations) + "stations";
    });

/// Lecture 4: engagement of the driver, and phi from -pi/n to pi/n, without a jump of the speed.
void expect_one_pitch(const Mechanism& mechanism) {
  const double alpha = half_pitch(mechanism);
  EXPECT_NEAR(mechanism.motion(mechanism.entry).wheel_angle.value, -alpha, 1e-12) << mechanism.name;
  EXPECT_NEAR(mechanism.motion(mechanism.exit).wheel_angle.value, alpha, 1e-12) << mechanism.name;
  EXPECT_NEAR(mechanism.motion(mechanism.entry).wheel_angle.first, 0., 1e-12) << mechanism.name;
  EXPECT_NEAR(mechanism.motion(0.).wheel_angle.value, 0., 1e-12) << mechanism.name;
  EXPECT_NEAR(tangency_defect(mechanism, mechanism.exit), 0., 1e-7) << mechanism.name;
}

/// phi(-theta) = -phi(theta), x(-theta) = x(theta).
void expect_symmetric(const Mechanism& mechanism, double part) {
  const SlotMotion before = mechanism.motion(part * mechanism.entry);
  const SlotMotion after = mechanism.motion(part * mechanism.exit);
  EXPECT_NEAR(before.wheel_angle.value, -after.wheel_angle.value, 1e-13);
  EXPECT_NEAR(before.pin_distance.value, after.pin_distance.value, 1e-14);
}

std::vector<Mechanism> random_mechanisms(Random& random) {
  const double size = between(random, 0.01, 1.);
  const double spacing = between(random, 0., 4. * size);
  return {external_geneva(stations(random), size), internal_geneva(stations(random), size),
          spherical_geneva(stations(random), between(random, 2., 178.) * degree, size),
          long_dwell_geneva(stations(random), size, spacing, SprocketLine::along_line_of_centres),
          long_dwell_geneva(stations(random), size, spacing, SprocketLine::across_line_of_centres)};
}

TEST(Mechanisms, TurnTheWheelByOnePitchWithoutAJumpOfSpeed) {
  Random random(1);
  for (int i = 0; i < 200; ++i)
    for (const Mechanism& mechanism : random_mechanisms(random)) {
      expect_one_pitch(mechanism);
      expect_symmetric(mechanism, between(random, 0., 1.));
    }
}

TEST(Mechanisms, HaveTheDerivativesOfTheirPositions) {
  Random random(2);
  for (int i = 0; i < 1000; ++i)
    for (const Mechanism& mechanism : random_mechanisms(random)) {
      const double angle = between(random, 0.9 * mechanism.entry, 0.9 * mechanism.exit);
      // The motion is as sharp as the line of centres is near, and joints must not lie between.
      double scale = std::min(0.3, mechanism.exit / 4.);
      const double ratio = mechanism.motion(0.).wheel_angle.first;
      scale = std::min(scale, 1. / (1. + ratio));
      bool is_smooth = true;
      for (const double joint : mechanism.joints)
        is_smooth = is_smooth && std::abs(angle - joint) > 4. * 4e-3 * scale;
      if (!is_smooth) continue;
      expect_consistent([&](double t) { return mechanism.motion(t).wheel_angle; }, angle, scale,
                        mechanism.name + ", wheel angle");
      expect_consistent([&](double t) { return mechanism.motion(t).pin_distance; }, angle, scale,
                        mechanism.name + ", pin distance");
      expect_consistent([&](double t) { return mechanism.motion(t).slot_position; }, angle, scale,
                        mechanism.name + ", slot position");
    }
}

TEST(ExternalMechanism, IsEq530To532) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const ExternalGeneva geneva(stations(random));
    const Mechanism mechanism = external_geneva(geneva.stations(), c);
    const double angle = between(random, mechanism.entry, mechanism.exit);
    const SlotMotion motion = mechanism.motion(angle);
    EXPECT_NEAR(motion.wheel_angle.value, geneva.wheel_angle(angle), 1e-14);
    EXPECT_NEAR(motion.wheel_angle.first, geneva.speed_ratio(angle), 1e-12);
    EXPECT_NEAR(motion.wheel_angle.second, geneva.acceleration_ratio(angle), 1e-11);
    EXPECT_NEAR(motion.wheel_angle.third, geneva.jerk_ratio(angle), 1e-9);
    EXPECT_NEAR(motion.pin_distance.value, c * geneva.pin_distance_ratio(angle), 1e-15);
  }
}

TEST(InternalMechanism, IsLecture4) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const int n = stations(random);
    const double s = std::sin(pi / n);
    const Mechanism mechanism = internal_geneva(n, c);
    const double angle = between(random, mechanism.entry, mechanism.exit);
    EXPECT_NEAR(mechanism.motion(angle).wheel_angle.first,
                s * (std::cos(angle) + s) / (1. + s * s + 2. * s * std::cos(angle)), 1e-13);
    EXPECT_NEAR(std::abs(mechanism.motion(mechanism.entry).wheel_angle.second), std::tan(pi / n),
                1e-12)
        << "maximum at entry";
  }
}

TEST(SphericalMechanism, Lecture4RightAngleIsTangentOfSine) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const int n = stations(random);
    const Mechanism mechanism = spherical_geneva(n, pi / 2., c);
    EXPECT_NEAR(mechanism.exit, pi / 2., 1e-12) << "engaged over half a turn exactly";
    const double angle = between(random, mechanism.entry, mechanism.exit);
    EXPECT_NEAR(std::tan(mechanism.motion(angle).wheel_angle.value),
                std::tan(pi / n) * std::sin(angle), 1e-12);
  }
}

/// The sphere's radius grows so that the distance of the axes at the pin stays: the difference to
/// the plane mechanism is of the order of the square of the shaft angle.
TEST(SphericalMechanism, TendsToTheExternalAndTheInternalGeneva) {
  const double small = 1e-4;
  for (int n = 3; n <= 24; ++n) {
    const Mechanism external = external_geneva(n, c);
    const Mechanism internal = internal_geneva(n, c);
    const Mechanism at_zero = spherical_geneva(n, small, c / small);
    const Mechanism at_half_turn = spherical_geneva(n, pi - small, c / small);
    EXPECT_NEAR(at_zero.exit, external.exit, 1e-7);
    EXPECT_NEAR(at_half_turn.exit, internal.exit, 1e-7);
    for (const double part : {-0.9, -0.4, 0., 0.3, 1.}) {
      const auto expect = [&](const Mechanism& sphere, const Mechanism& plane) {
        const SlotMotion found = sphere.motion(part * plane.exit);
        const SlotMotion wanted = plane.motion(part * plane.exit);
        const double size = 1. + std::abs(wanted.wheel_angle.second);
        EXPECT_NEAR(found.wheel_angle.value, wanted.wheel_angle.value, 1e-6);
        EXPECT_NEAR(found.wheel_angle.second, wanted.wheel_angle.second, 1e-6 * size * size);
        EXPECT_NEAR(found.pin_distance.value, wanted.pin_distance.value, 1e-6 * c);
        EXPECT_NEAR(std::abs(found.slot_position.first), std::abs(wanted.slot_position.first),
                    1e-6 * c);
        EXPECT_NEAR(std::abs(found.friction_lever), 1., 1e-6);
      };
      expect(at_zero, external);
      expect(at_half_turn, internal);
    }
  }
}

TEST(LongDwellMechanism, IsTheExternalGenevaWithoutSpacing) {
  Random random(6);
  for (const auto line :
       {SprocketLine::along_line_of_centres, SprocketLine::across_line_of_centres})
    for (int i = 0; i < 1000; ++i) {
      const int n = stations(random);
      const Mechanism plain = external_geneva(n, c);
      const Mechanism chain = long_dwell_geneva(n, c * std::sin(pi / n), 0., line);
      EXPECT_NEAR(chain.period, 2. * pi, 1e-12);
      EXPECT_NEAR(chain.exit, plain.exit, 1e-12);
      EXPECT_TRUE(chain.joints.empty());
      const double angle = between(random, -pi, pi);
      const SlotMotion found = chain.motion(angle);
      const SlotMotion wanted = plain.motion(angle);
      EXPECT_NEAR(found.wheel_angle.value, wanted.wheel_angle.value, 1e-10);
      EXPECT_NEAR(found.wheel_angle.first, wanted.wheel_angle.first, 1e-10);
      EXPECT_NEAR(found.wheel_angle.second, wanted.wheel_angle.second, 1e-10);
      EXPECT_NEAR(found.pin_distance.value, wanted.pin_distance.value, 1e-10);
    }
}

TEST(LongDwellMechanism, RunsAClosedPathOfTwoCirclesAndTwoStraightStretches) {
  const double r = 0.03;
  const double a = 0.11;
  for (const auto line :
       {SprocketLine::along_line_of_centres, SprocketLine::across_line_of_centres}) {
    const Mechanism chain = long_dwell_geneva(5, r, a, line);
    EXPECT_NEAR(chain.period * r, 2. * pi * r + 2. * a, 1e-14);
    double length = 0.;
    const auto place = [&](double angle) {
      const SlotMotion motion = chain.motion(angle);
      return std::pair{motion.pin_distance.value * std::cos(motion.wheel_angle.value),
                       motion.pin_distance.value * std::sin(motion.wheel_angle.value)};
    };
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      const auto [x0, y0] = place((i - 0.5 * steps) * chain.period / steps);
      const auto [x1, y1] = place((i + 1 - 0.5 * steps) * chain.period / steps);
      length += std::hypot(x1 - x0, y1 - y0);
    }
    EXPECT_NEAR(length, chain.period * r, 1e-8);
  }
}

TEST(Pins, OfWhichAtMostSoManyAreEquallySpaced) {
  // seed values: 2 n/(n - 2) rounded down
  const std::vector<std::pair<int, int>> most{{3, 6}, {4, 4}, {5, 3}, {6, 3}, {7, 2}, {12, 2}};
  for (const auto& [n, pins] : most) {
    const Mechanism mechanism = external_geneva(n, c);
    EXPECT_EQ(most_pins(mechanism), pins) << n;
    EXPECT_EQ(engagements(mechanism, equally_spaced_pins(mechanism, pins)).size(),
              static_cast<std::size_t>(pins));
    const int too_many = pins + 1;
    expect_refused([&] { engagements(mechanism, equally_spaced_pins(mechanism, too_many)); },
                   {"pins", "together", "equally spaced pins at most"});
  }
  EXPECT_EQ(most_pins(internal_geneva(4, c)), 1);
}

TEST(Pins, AtUnequalAnglesHaveEqualMotionsAndUnequalDwells) {
  const Mechanism mechanism = external_geneva(6, c);
  const auto found = engagements(mechanism, {0., 150. * degree});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].pin, 1U);
  EXPECT_NEAR(found[1].begin - found[0].end, 30. * degree, 1e-12);
  EXPECT_NEAR(found[1].end - found[1].begin, found[0].end - found[0].begin, 1e-12);
}

TEST(Refusals, OfMechanismsThatCannotBe) {
  expect_refused([] { external_geneva(2, c); }, {"number of stations is 2", "3 to 24"});
  expect_refused([] { internal_geneva(6, -1.); }, {"centre distance", "positive"});
  expect_refused([] { spherical_geneva(6, 0., c); }, {"shaft angle is 0 deg", "0 to 180 deg"});
  expect_refused([] { spherical_geneva(6, pi, c); }, {"shaft angle is 180 deg"});
  expect_refused([] { long_dwell_geneva(6, c, -0.1, SprocketLine::along_line_of_centres); },
                 {"sprocket spacing is -100 mm"});
  expect_refused(
      [] {
        engagements(external_geneva(6, c), {0., 100. * degree});
      },
      {"pins 1 and 2 are 100 deg", "stays 120 deg", "3 equally spaced pins at most"});
}

}  // namespace
}  // namespace geneva::loads
