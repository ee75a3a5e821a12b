#include "loads/motion/motion_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "loads/motion/cubic_spline.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/motion/differences.h"

namespace geneva::loads {
namespace {

using test::expect_consistent;
using test::expect_refused;

TEST(KolomietsLaws, RunFromZeroToOne) {
  for (const MotionLaw law : {MotionLaw::cycloidal, MotionLaw::harmonic}) {
    EXPECT_EQ(progress(law, 0.).value, 0.);
    EXPECT_NEAR(progress(law, 0.5).value, 0.5, 1e-15);
    EXPECT_NEAR(progress(law, 1.).value, 1., 1e-15);
    EXPECT_NEAR(progress(law, 0.).first, 0., 1e-15);
    EXPECT_NEAR(progress(law, 1.).first, 0., 1e-15);
  }
  EXPECT_NEAR(progress(MotionLaw::cycloidal, 0.5).first, 2., 1e-15);
  EXPECT_NEAR(progress(MotionLaw::cycloidal, 0.25).second, 2. * pi, 1e-14);
  EXPECT_NEAR(progress(MotionLaw::harmonic, 0.5).first, pi / 2., 1e-15);
  EXPECT_NEAR(progress(MotionLaw::harmonic, 0.).second, pi * pi / 2., 1e-14);
}

TEST(KolomietsLaws, HaveTheDerivativesOfTheirProgress) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i)
    for (const MotionLaw law : {MotionLaw::cycloidal, MotionLaw::harmonic}) {
      const double k = std::uniform_real_distribution<>(0.02, 0.98)(random);
      expect_consistent([&](double t) { return progress(law, t); }, k, 0.25, "progress");
      const double half = std::uniform_real_distribution<>(0.05, 0.47)(random);
      expect_consistent([&](double t) { return root_of_progress(law, t); }, half, 0.1, "root");
      const double root = root_of_progress(law, half).value;
      EXPECT_NEAR(root * root, progress(law, half).value, 1e-15);
    }
}

TEST(KolomietsLaws, ProgressOfTheCycloidalLawIsExactAtItsStart) {
  const double k = 1e-5;
  EXPECT_NEAR(progress(MotionLaw::cycloidal, k).value / (2. * pi * pi / 3. * k * k * k), 1., 1e-9);
}

TEST(KolomietsLaws, RefuseTimesOutsideOfTheMotion) {
  expect_refused([] { progress(MotionLaw::harmonic, 1.2); },
                 {"relative time of the motion law is 1.2", "from 0 to 1"});
  expect_refused([] { progress(MotionLaw::cycloidal, -0.1); }, {"-0.1"});
  expect_refused([] { progress(MotionLaw::cycloidal, std::nan("")); }, {"nan"});
}

TEST(CubicSpline, OfACubicIsThatCubic) {
  const auto cubic = [](double x) { return 1. + x * (2. + x * (-3. + 0.5 * x)); };
  const std::vector<double> x{-1., -0.3, 0.4, 0.5, 2., 2.7};
  std::vector<double> y;
  for (const double place : x) y.push_back(cubic(place));
  const CubicSpline spline(x, y);
  for (int step = -20; step <= 54; ++step) {
    const double place = 0.05 * step;
    EXPECT_NEAR(spline(place).value, cubic(place), 1e-13);
    EXPECT_NEAR(spline(place).first, 2. - 6. * place + 1.5 * place * place, 1e-12);
    EXPECT_NEAR(spline(place).second, -6. + 3. * place, 1e-11);
    EXPECT_NEAR(spline(place).third, 3., 1e-10);
  }
}

TEST(CubicSpline, HasAContinuousSecondDerivative) {
  const CubicSpline spline({0., 1., 1.5, 4., 5.}, {0., 2., 1., 3., -1.});
  for (const double knot : {1., 1.5, 4.}) {
    EXPECT_NEAR(spline(knot - 1e-9).second, spline(knot + 1e-9).second, 1e-6);
    EXPECT_NEAR(spline(knot - 1e-9).first, spline(knot + 1e-9).first, 1e-6);
  }
}

TEST(CubicSpline, OfTwoAndThreePointsIsALineAndAParabola) {
  EXPECT_NEAR(CubicSpline({0., 2.}, {1., 5.})(0.5).value, 2., 1e-15);
  const CubicSpline parabola({0., 1., 3.}, {0., 1., 9.});
  EXPECT_NEAR(parabola(2.).value, 4., 1e-14);
  EXPECT_NEAR(parabola(2.).second, 2., 1e-14);
}

}  // namespace
}  // namespace geneva::loads
