#include "loads/pin/bending_width.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geneva::loads {
namespace {

TEST(BendingShare, IsOddAndEndsAtOne) {
  EXPECT_EQ(bending_share(0.), 0.);
  for (const double s : {0.01, 0.3, 1., 5.}) EXPECT_EQ(bending_share(-s), -bending_share(s));
  EXPECT_NEAR(bending_share(100.), 1., 1e-4);
  EXPECT_EQ(bending_share(1e9), 1.);
}

/// Far away D(s) is 1/(2 s^3): the load's second moment about the middle is 1/4 of b^2, about the
/// end 5/4.
TEST(BendingShare, FallsOffWithTheSquareOfTheDistance) {
  const double from = 10.;
  const double to = 20.;
  EXPECT_NEAR(bending_share(to) - bending_share(from), 0.25 * (1. / (from * from) - 1. / (to * to)),
              2e-4);
}

/// Hertz's line contact: b^2 = 4 R q/(pi E*) of an even load, wherever it is far from its ends.
TEST(BendingWidths, OfAnEvenLoadAreHertzs) {
  constexpr int n = 200;
  const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(n, -10., 10.);
  const Eigen::VectorXd widths = Eigen::VectorXd::Constant(n, 20. / (n - 1));
  BendingWidths bending(places, widths, 4e-2);
  const Eigen::VectorXd loads = Eigen::VectorXd::Constant(n, 25.);
  for (int i = 0; i < 60; ++i) bending.follow(loads);
  EXPECT_NEAR(bending.half_widths()[n / 2], 1., 5e-3);
  const double end = bending.half_widths()[0];  // from half a section on
  EXPECT_NEAR(end * end, 0.5 * (1. + bending_share(widths[0] / 2. / end)), 5e-3);
}

TEST(BendingWidths, HardlyFollowANarrowPeakOfTheLoad) {
  constexpr int n = 401;
  const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(n, -10., 10.);
  const Eigen::VectorXd widths = Eigen::VectorXd::Constant(n, 20. / (n - 1));
  BendingWidths bending(places, widths, 4e-2);
  Eigen::VectorXd loads = Eigen::VectorXd::Constant(n, 25.);
  loads[n / 2] *= 16.;  // on a twentieth of the width
  for (int i = 0; i < 60; ++i) bending.follow(loads);
  EXPECT_GT(bending.half_widths()[n / 2], 1.);
  EXPECT_LT(bending.half_widths()[n / 2], 1.6) << "its own load would make it 4";
}

}  // namespace
}  // namespace geneva::loads
