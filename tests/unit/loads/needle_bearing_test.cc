#include "loads/needle_bearing.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

using test::expect_refused;

constexpr Elastic steel{207e9, 0.3};

/// ISO 76: C_0r = 44 (1 - D_w/D_pw) Z L_w D_w [N, mm] is the load at 4000 MPa.
TEST(NeedleBearing, ReachesItsStaticPressureAtTheStaticLoadRating) {
  for (const double bore : {12e-3, 20e-3, 40e-3})
    for (const double diameter : {1.5e-3, 2.5e-3}) {
      const NeedleBearing needles{14, diameter, 10e-3};
      const double pitch = bore - diameter;
      const double rating = 44e6 * (1. - diameter / pitch) * 14 * 10e-3 * diameter;
      EXPECT_NEAR(needle_pressure(needles, bore, rating, steel), static_needle_pressure,
                  0.005 * static_needle_pressure)
          << bore << ' ' << diameter;
    }
}

TEST(NeedleBearing, PressureGoesWithTheRootOfTheForce) {
  const NeedleBearing needles{12, 2e-3, 12e-3};
  const double pressure = needle_pressure(needles, 10e-3, 100., steel);
  EXPECT_NEAR(needle_pressure(needles, 10e-3, 400., steel), 2. * pressure, 1e-9 * pressure);
  EXPECT_EQ(needle_pressure(needles, 10e-3, 0., steel), 0.);
}

TEST(NeedleBearing, ThatDoesNotFitIsRefused) {
  EXPECT_NO_THROW(check({12, 2e-3, 12e-3}, 10e-3));
  expect_refused([] { check({13, 2e-3, 12e-3}, 10e-3); }, {"13 needles", "at most 12 fit"});
  expect_refused([] { check({8, 5e-3, 12e-3}, 10e-3); }, {"leave no stud"});
  expect_refused([] { check({2, 1e-3, 12e-3}, 10e-3); }, {"3 or more"});
  expect_refused([] { check({8, 1e-3, -1.}, 10e-3); }, {"needle length"});
}

}  // namespace
}  // namespace geneva::loads
