#include "loads/motion/four_bar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "loads/pi.h"
#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

using test::expect_refused;

const FourBar crank_rocker{{0., 0.}, {0.1, 0.}, 0.03, 0.09, 0.08, 0.05, 0.4};
const FourBar double_crank{{0.01, 0.02}, {0.04, 0.06}, 0.09, 0.08, 0.1, 0.07, -1.};
const FourBar double_rocker{{0., 0.}, {0.1, 0.}, 0.09, 0.03, 0.08, 0.05, 0.4};
const FourBar triple_rocker{{0., 0.}, {0.1, 0.}, 0.05, 0.06, 0.04, 0.05, 0.4};

struct State {
  FourBar linkage;
  Assembly assembly;
  double crank_angle;
};

double sine_of_transmission(const State& state) {
  const FourBarMotion m = motion(state.linkage, state.assembly, state.crank_angle);
  return std::abs(std::sin(m.coupler_angle[0] - m.rocker_angle[0]));
}

/// Linkages of all kinds, at a crank angle away from the dead points.
State random_state(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> length(0.3, 2.);
  std::uniform_real_distribution<double> angle(-pi, pi);
  std::uniform_real_distribution<double> unit(0., 1.);
  while (true) {
    const FourBar linkage{{angle(engine), angle(engine)},
                          {angle(engine), angle(engine)},
                          length(engine),
                          length(engine),
                          length(engine),
                          length(engine),
                          angle(engine)};
    const double frame = frame_length(linkage);
    const double sum = linkage.crank + linkage.coupler + linkage.rocker;
    if (frame < 0.3 || frame > 0.9 * sum) continue;
    if (std::max({linkage.crank, linkage.coupler, linkage.rocker}) > 0.45 * (sum + frame)) continue;
    const auto ranges = crank_ranges(linkage);
    const auto& range = ranges[unit(engine) < 0.5 ? 0 : ranges.size() - 1];
    const State state{linkage, unit(engine) < 0.5 ? Assembly::open : Assembly::crossed,
                      range.first + (0.02 + 0.96 * unit(engine)) * (range.second - range.first)};
    if (sine_of_transmission(state) > 0.3) return state;
  }
}

/// Residual of the closure A B C D and of A B P, computed anew from the definition.
double closure_error(const State& s) {
  const FourBarMotion m = motion(s.linkage, s.assembly, s.crank_angle);
  const FourBar& l = s.linkage;
  const double bx = l.crank_pivot[0] + l.crank * std::cos(s.crank_angle);
  const double by = l.crank_pivot[1] + l.crank * std::sin(s.crank_angle);
  const double arm = m.coupler_angle[0] + l.point_angle;
  return std::max({std::abs(bx + l.coupler * std::cos(m.coupler_angle[0]) - l.rocker_pivot[0] -
                            l.rocker * std::cos(m.rocker_angle[0])),
                   std::abs(by + l.coupler * std::sin(m.coupler_angle[0]) - l.rocker_pivot[1] -
                            l.rocker * std::sin(m.rocker_angle[0])),
                   std::abs(bx + l.point_distance * std::cos(arm) - m.x[0]),
                   std::abs(by + l.point_distance * std::sin(arm) - m.y[0])});
}

/// Sixth-order central difference of an angle or a length; angles may jump by a turn.
template <typename Function>
double difference(const Function& function, double x, double h, bool is_angle) {
  const auto rise = [&](double step) {
    const double value = function(x + step) - function(x - step);
    return is_angle ? std::remainder(value, 2. * pi) : value;
  };
  return (45. * rise(h) - 9. * rise(2. * h) + rise(3. * h)) / (60. * h);
}

double maximum_derivative_error(const State& s) {
  double maximum = 0.;
  using Quantity = std::array<double, 4> FourBarMotion::*;
  const FourBarMotion here = motion(s.linkage, s.assembly, s.crank_angle);
  // a step that is small against the distance of the nearest singularity, about 1/rate
  double rate = 1.;
  for (const Quantity angle : {&FourBarMotion::coupler_angle, &FourBarMotion::rocker_angle})
    for (std::size_t order = 1; order < 4; ++order)
      rate =
          std::max(rate, std::pow(std::abs((here.*angle)[order]), 1. / static_cast<double>(order)));
  const double h = 1e-2 / rate;
  for (const Quantity quantity : {&FourBarMotion::coupler_angle, &FourBarMotion::rocker_angle,
                                  &FourBarMotion::x, &FourBarMotion::y})
    for (std::size_t order = 1; order < 4; ++order) {
      const auto below = [&](double angle) {
        return (motion(s.linkage, s.assembly, angle).*quantity)[order - 1];
      };
      const bool is_angle = order == 1 && (quantity == &FourBarMotion::coupler_angle ||
                                           quantity == &FourBarMotion::rocker_angle);
      const double expected = difference(below, s.crank_angle, h, is_angle);
      const double magnitude =
          std::max({1., std::abs((here.*quantity)[order - 1]), std::abs((here.*quantity)[order])});
      maximum = std::max(maximum, std::abs((here.*quantity)[order] - expected) / magnitude);
    }
  return maximum;
}

TEST(FourBar, DerivativesAreThoseOfFiniteDifferencesAtAThousandStates) {
  std::mt19937_64 engine(4);
  double maximum = 0.;
  for (int k = 0; k < 1000; ++k)
    maximum = std::max(maximum, maximum_derivative_error(random_state(engine)));
  EXPECT_LT(maximum, 1e-7);
}

TEST(FourBar, ClosesAtAThousandStates) {
  std::mt19937_64 engine(5);
  double maximum = 0.;
  for (int k = 0; k < 1000; ++k) maximum = std::max(maximum, closure_error(random_state(engine)));
  EXPECT_LT(maximum, 1e-13);  // lengths up to 9
}

TEST(FourBar, OpenLinkageHasItsJointLeftOfTheLineFromPinToRockerPivot) {
  std::mt19937_64 engine(6);
  for (int k = 0; k < 200; ++k) {
    const State s = random_state(engine);
    const FourBarMotion m = motion(s.linkage, s.assembly, s.crank_angle);
    const double x = s.linkage.rocker_pivot[0] - s.linkage.crank_pivot[0] -
                     s.linkage.crank * std::cos(s.crank_angle);
    const double y = s.linkage.rocker_pivot[1] - s.linkage.crank_pivot[1] -
                     s.linkage.crank * std::sin(s.crank_angle);
    const double cross = x * std::sin(m.coupler_angle[0]) - y * std::cos(m.coupler_angle[0]);
    EXPECT_EQ(cross > 0., s.assembly == Assembly::open);
  }
}

TEST(FourBar, BothAssembliesAreMirrorImagesOfEachOtherInTheLineFromPinToRockerPivot) {
  const double angle = 70. * degree;
  const auto both = all_assemblies(crank_rocker, angle);
  const double line = std::atan2(-0.03 * std::sin(angle), 0.1 - 0.03 * std::cos(angle));
  EXPECT_NEAR(both[0].coupler_angle[0] + both[1].coupler_angle[0], 2. * line, 1e-14);
  EXPECT_EQ(both[1].x[0], motion(crank_rocker, Assembly::crossed, angle).x[0]);
}

TEST(FourBar, CouplerOfAParallelogramDoesNotTurn) {
  const FourBar parallelogram{{0., 0.}, {0.1, 0.}, 0.04, 0.1, 0.04, 0.06, 0.7};
  for (int k = -20; k < 40; ++k) {  // through the change points
    const double angle = 10. * k * degree;
    const FourBarMotion m = motion(parallelogram, Assembly::open, angle);
    EXPECT_NEAR(m.coupler_angle[0], 0., 1e-14) << k;
    for (const std::size_t order : {1U, 2U, 3U}) EXPECT_NEAR(m.coupler_angle[order], 0., 1e-12);
    const double x = 0.06 * std::cos(0.7);
    const double y = 0.06 * std::sin(0.7);
    EXPECT_NEAR(std::hypot(m.x[0] - x, m.y[0] - y), 0.04, 1e-15) << k;
    EXPECT_NEAR(std::remainder(m.rocker_angle[0] - angle, 2. * pi), 0., 1e-14) << k;
  }
}

TEST(FourBar, CouplerCurveIsSymmetricWhenCouplerRockerAndPointArmAreEqual) {
  // BC = CD = CP: the curve is symmetric about a line through D (Roberts, Chebyshev); crank angles
  // +-theta give mirrored points. CP = CB makes P's arm BP = 2 BC cos(alpha).
  const double alpha = 0.5;
  const FourBar linkage{{0., 0.}, {0.1, 0.}, 0.03, 0.09, 0.09, 0.18 * std::cos(alpha), alpha};
  // the axis: from D through the middle of the two mirrored points of any angle
  const auto point = [&](double angle) {
    const FourBarMotion m = motion(linkage, Assembly::open, angle);
    return std::array<double, 2>{m.x[0] - 0.1, m.y[0]};
  };
  const auto one = point(0.3);
  const auto two = point(-0.3);
  const double axis = std::atan2(one[1] + two[1], one[0] + two[0]);
  for (int k = 0; k < 18; ++k) {
    const auto p = point(10. * k * degree);
    const auto q = point(-10. * k * degree);
    EXPECT_NEAR(std::hypot(p[0], p[1]), std::hypot(q[0], q[1]), 1e-14) << k;
    const double turn = std::atan2(p[1], p[0]) + std::atan2(q[1], q[0]) - 2. * axis;
    EXPECT_NEAR(std::remainder(turn, 2. * pi), 0., 1e-12) << k;
  }
}

TEST(FourBar, GrashofConditionsSayWhetherTheCrankTurnsFully) {
  EXPECT_TRUE(crank_turns_fully(crank_rocker));
  EXPECT_TRUE(crank_turns_fully(double_crank));
  EXPECT_FALSE(crank_turns_fully(double_rocker));
  EXPECT_FALSE(crank_turns_fully(triple_rocker));
}

TEST(FourBar, EqualityInGrashofsConditionStillTurnsFully) {
  // sums of such decimals differ by a rounding: 0.1 + 0.6 against 0.3 + 0.4
  EXPECT_TRUE(crank_turns_fully({{0., 0.}, {0.6, 0.}, 0.1, 0.3, 0.4, 0.1, 0.}));
  EXPECT_TRUE(crank_turns_fully({{0., 0.}, {0.3, 0.}, 0.1, 0.4, 0.6, 0.1, 0.}));
  EXPECT_TRUE(crank_turns_fully({{0., 0.}, {0.3, 0.}, 0.1, 0.3, 0.1, 0.1, 0.}));
  EXPECT_FALSE(crank_turns_fully({{0., 0.}, {0.601, 0.}, 0.1, 0.3, 0.4, 0.1, 0.}));
}

TEST(FourBar, RangesOfTheCrankEndWhereCouplerAndRockerAreInLine) {
  EXPECT_EQ(crank_ranges(crank_rocker).size(), 1U);
  EXPECT_EQ(crank_ranges(double_rocker).size(), 2U);
  EXPECT_EQ(crank_ranges(triple_rocker).size(), 1U);
  for (const FourBar& linkage : {double_rocker, triple_rocker})
    for (const auto& [first, last] : crank_ranges(linkage))
      for (const auto& [end, inwards] : {std::pair(first, 1e-6), std::pair(last, -1e-6)}) {
        const State inside{linkage, Assembly::open, end + inwards};
        EXPECT_LT(sine_of_transmission(inside), 1e-2);
        expect_refused([&, at = end] { motion(linkage, Assembly::open, at); },
                       {"crank angle is", "dead point", "choose crank angles from"});
        expect_refused([&, at = end - inwards] { motion(linkage, Assembly::open, at); },
                       {"cannot meet", "mm from D", "choose crank angles from"});
      }
}

TEST(FourBar, FullTurnIsOneRangeFromTheLineOfPivots) {
  const auto ranges = crank_ranges(double_crank);
  ASSERT_EQ(ranges.size(), 1U);
  EXPECT_NEAR(ranges[0].first, std::atan2(4., 3.), 1e-15);
  EXPECT_NEAR(ranges[0].second - ranges[0].first, 2. * pi, 1e-15);
}

TEST(FourBar, RefusesLengthsThatAreNone) {
  FourBar linkage = crank_rocker;
  linkage.coupler = -0.01;
  expect_refused([&] { check(linkage); }, {"coupler BC is -10 mm", "positive"});
  linkage = crank_rocker;
  linkage.point_distance = std::numeric_limits<double>::infinity();
  expect_refused([&] { check(linkage); }, {"distance BP", "finite"});
  linkage = crank_rocker;
  linkage.rocker_pivot = linkage.crank_pivot;
  expect_refused([&] { check(linkage); }, {"distance of the pivots AD is 0 mm"});
}

TEST(FourBar, RefusesLengthsThatCannotBeClosed) {
  FourBar linkage = crank_rocker;
  linkage.coupler = 0.22;
  expect_refused([&] { check(linkage); },
                 {"AB 30, BC 220, CD 80 and AD 100 mm", "shorter than the other three", "210 mm"});
}

TEST(FourBar, CrossedParallelogramIsTheAntiparallelogramThroughItsChangePoints) {
  const FourBar linkage{{0., 0.}, {0.1, 0.}, 0.04, 0.1, 0.04, 0.06, 0.7};
  EXPECT_EQ(change_points(linkage), (std::vector<double>{0., pi}));
  for (const double angle : {0., pi}) {
    const FourBarMotion before = motion(linkage, Assembly::crossed, angle - 1e-3);
    const FourBarMotion after = motion(linkage, Assembly::crossed, angle + 1e-3);
    EXPECT_LT(before.rocker_angle[1], 0.);
    for (const std::size_t order : {1U, 2U})
      EXPECT_NEAR(before.rocker_angle[order], after.rocker_angle[order], 0.025) << angle;
    expect_refused([&] { motion(linkage, Assembly::crossed, angle); },
                   {"dead point", "any crank angle"});
  }
}

TEST(FourBar, HasAChangePointWhereGrashofsConditionIsAnEquality) {
  EXPECT_TRUE(change_points(crank_rocker).empty());
  const FourBar stretched{{0., 0.}, {0., 0.1}, 0.03, 0.06, 0.07, 0., 0.};
  EXPECT_EQ(change_points(stretched), (std::vector<double>{pi / 2. + pi}));
  const FourBar folded{{0., 0.}, {0., 0.1}, 0.03, 0.13, 0.06, 0., 0.};
  EXPECT_EQ(change_points(folded), (std::vector<double>{pi / 2.}));
}

}  // namespace
}  // namespace geneva::loads
