#include "loads/partial_slip.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "loads/pi.h"
#include "tests/unit/loads/random_values.h"

namespace geneva::loads {
namespace {

using Shape = PartialSlip::Shape;
constexpr double bound = 18.;

/// Q over mu P by Simpson's rule in the angle sin t = r.
double force_of(const PartialSlip& slip, const Shape shape) {
  constexpr int pieces = 4000;
  double sum = 0.;
  for (int i = 0; i <= pieces; ++i) {
    const double t = pi / 2. * i / pieces;
    const double weight = i == 0 || i == pieces ? 1. : i % 2 == 1 ? 4. : 2.;
    const double r = std::sin(t);
    const double area = shape == Shape::line ? 4. / pi : 3. * r;
    sum += weight * slip.traction(r) * area * std::cos(t);
  }
  return sum * pi / 2. / pieces / 3.;
}

TEST(PartialSlip, SticksOnTheRadiusOfTheBooks) {
  for (const double share : {0.25, 0.5, 0.75}) {
    PartialSlip line(Shape::line, bound);
    PartialSlip circle(Shape::circle, bound);
    line.move_to(share * bound);
    circle.move_to(share * bound);
    EXPECT_NEAR(line.stick_radius(), std::sqrt(1. - share), 1e-15);
    EXPECT_NEAR(circle.stick_radius(), std::cbrt(1. - share), 1e-15);
    EXPECT_NEAR(circle.sticking_share(), std::pow(1. - share, 2. / 3.), 1e-15);
  }
}

TEST(PartialSlip, NothingSlipsBeforeAndEverythingAtTheBound) {
  PartialSlip slip(Shape::circle, bound);
  EXPECT_EQ(slip.stick_radius(), 1.);
  EXPECT_EQ(slip.traction(0.5), 0.);
  slip.move_to(bound);
  EXPECT_EQ(slip.stick_radius(), 0.);
  EXPECT_NEAR(slip.traction(0.6), 0.8, 1e-15);
}

RC_GTEST_PROP(PartialSlip, CarriesTheForceAndNeverMoreThanMuTimesThePressure, ()) {
  const Shape shape = test::uniform(0, 2) == 0 ? Shape::line : Shape::circle;
  PartialSlip slip(shape, bound);
  double force = 0.;
  const int moves = test::uniform(1, 12);
  for (int i = 0; i < moves; ++i) slip.move_to(force = bound * test::between(-0.99, 0.99));
  RC_ASSERT(std::abs(force_of(slip, shape) - force / bound) < 2e-5);
  for (double r = 0.; r < 1.; r += 0.01)
    RC_ASSERT(std::abs(slip.traction(r)) <= std::sqrt(1. - r * r) + 1e-12);
}

TEST(PartialSlip, ForgetsALoopThatIsClosed) {
  PartialSlip straight(Shape::line, bound);
  PartialSlip to_and_fro(Shape::line, bound);
  straight.move_to(15.);
  for (const double force : {10., 4., 7., 5., 9., 15.}) to_and_fro.move_to(force);
  for (const double r : {0., 0.3, 0.6, 0.9})
    EXPECT_NEAR(to_and_fro.traction(r), straight.traction(r), 1e-14);
  for (const double force : {-3., 2., -15., 4., 15.}) to_and_fro.move_to(force);
  straight.move_to(-15.);
  straight.move_to(15.);
  for (const double r : {0., 0.3, 0.6, 0.9})
    EXPECT_NEAR(to_and_fro.traction(r), straight.traction(r), 1e-14);
}

}  // namespace
}  // namespace geneva::loads
