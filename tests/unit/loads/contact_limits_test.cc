#include "loads/contact_limits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

/// Values by integration of Flamant's solution, mu = 0.3.
TEST(SlidingContact, StressIsThatOfFlamantsForcesUnderPressureAndTraction) {
  const HertzLine contact{1., 1., 0., 0.};
  struct Row {
    double x, z, xx, zz, xz;
  };
  const std::array<Row, 4> table{{{0., 0.5, -0.341641, -0.894427, -0.102492},
                                  {0.5, 0.5, -0.415021, -0.797390, -0.269844},
                                  {-1., 0.25, -0.074841, -0.171350, 0.106383},
                                  {1.2, 0.3, -0.495536, -0.118656, -0.208890}}};
  for (const Row& row : table) {
    const ContactStress stress = sliding_stress(contact, 0.3, row.x, row.z);
    EXPECT_NEAR(stress.xx, row.xx, 1e-6) << row.x;
    EXPECT_NEAR(stress.zz, row.zz, 1e-6) << row.x;
    EXPECT_NEAR(stress.xz, row.xz, 1e-6) << row.x;
  }
}

TEST(SlidingContact, SurfaceIsPulledBy2MuP0AtItsTrailingEdgeAndPressedMostInFrontOfTheMiddle) {
  const HertzLine contact{3., 2., 0., 0.};
  const double mu = 0.25;
  EXPECT_NEAR(sliding_stress(contact, mu, -2., 0.).xx, 2. * mu * 3., 1e-12);
  const double x = 2. * mu / std::sqrt(1. + 4. * mu * mu) * 2.;
  EXPECT_NEAR(sliding_stress(contact, mu, x, 0.).xx, -3. * std::sqrt(1. + 4. * mu * mu), 1e-12);
}

TEST(SlidingContact, StressInsideIsInEquilibrium) {
  const HertzLine contact{1., 1., 0., 0.};
  const double h = 1e-5;
  for (const double x : {-1.3, -0.4, 0.7, 1.6})
    for (const double z : {0.2, 0.9}) {
      const auto at = [&](const double dx, const double dz) {
        return sliding_stress(contact, 0.4, x + dx, z + dz);
      };
      EXPECT_NEAR((at(h, 0).xx - at(-h, 0).xx + at(0, h).xz - at(0, -h).xz) / (2. * h), 0., 1e-8);
      EXPECT_NEAR((at(h, 0).xz - at(-h, 0).xz + at(0, h).zz - at(0, -h).zz) / (2. * h), 0., 1e-8);
    }
}

TEST(ContactLimits, LineYieldsFirstAtThePublishedMultiples) {
  EXPECT_NEAR(line_contact_limits(0.25, 0.).first_yield, 1.72502, 1e-5);
  EXPECT_NEAR(line_contact_limits(0.35, 0.).first_yield, 1.84890, 1e-5);
  const std::array<std::array<double, 2>, 5> by_friction{
      {{0., 1.7937}, {0.1, 1.7685}, {0.2, 1.6949}, {0.3, 1.5001}, {0.5, 1.0260}}};
  for (const auto& [mu, limit] : by_friction)
    EXPECT_NEAR(line_contact_limits(0.3, mu).first_yield, limit, 1e-4) << mu;
}

TEST(ContactLimits, LineShakesDownUpToMelansLimitByVonMises) {
  const std::array<std::array<double, 2>, 7> map{{{0., 4.},
                                                  {0.1, 3.5642},
                                                  {0.2, 3.2024},
                                                  {0.3, 2.8996},
                                                  {0.35, 2.6149},
                                                  {0.4, 2.3162},
                                                  {0.5, 1.8819}}};
  for (const auto& [mu, limit] : map)
    EXPECT_NEAR(std::sqrt(3.) * line_contact_limits(0.3, mu).shakedown, limit, 1e-4) << mu;
}

TEST(ContactLimits, PointYieldsFirstAtThePublishedMultiples) {
  EXPECT_NEAR(point_contact_limits(0.25).first_yield, 1.55435, 1e-5);
  EXPECT_NEAR(point_contact_limits(0.3).first_yield, 1.61280, 1e-5);
  EXPECT_NEAR(point_contact_limits(0.35).first_yield, 1.67411, 1e-5);
  EXPECT_NEAR(point_contact_limits(0.3).shakedown, 4.68 / std::sqrt(3.), 1e-12);
}

/// K. L. Johnson 1985, Table 4.1.
TEST(ContactLimits, GreatestShearBelowAnEllipseIsThePublishedOne) {
  const std::array<std::array<double, 3>, 4> published{
      {{0.2, 0.322, 0.745}, {0.4, 0.325, 0.665}, {0.6, 0.323, 0.590}, {0.8, 0.317, 0.530}}};
  for (const auto& [ratio, shear, depth] : published) {
    const auto shear_at = [ratio = ratio](const double z) {
      const auto [x, y, deep] = axial_stress(ratio, z, 0.3);
      return (std::max({x, y, deep}) - std::min({x, y, deep})) / 2.;
    };
    EXPECT_NEAR(shear_at(depth), shear, 1e-3) << ratio;
    EXPECT_GT(shear_at(depth), shear_at(depth - 0.05));
    EXPECT_GT(shear_at(depth), shear_at(depth + 0.05));
  }
}

TEST(ContactLimits, EllipseLiesBetweenALineAndACircle) {
  for (const double nu : {0.2, 0.3, 0.45}) {
    EXPECT_NEAR(ellipse_contact_limits(2e-3, nu).first_yield,
                line_contact_limits(nu, 0.).first_yield, 5e-3);
    EXPECT_NEAR(ellipse_contact_limits(0.998, nu).first_yield, point_contact_limits(nu).first_yield,
                5e-3);
    EXPECT_EQ(ellipse_contact_limits(0.5, nu).shakedown, line_contact_limits(nu, 0.).shakedown);
  }
  test::expect_refused([] { ellipse_contact_limits(1.5, 0.3); }, {"axes"});
}

TEST(ContactLimits, RefusesANegativeFriction) {
  test::expect_refused([] { line_contact_limits(0.3, -0.1); }, {"friction"});
}

constexpr double layer_yield = 2000e6;
constexpr double core_yield = 600e6;

TEST(HardenedLayer, ThatIsDeepBearsWhatItsOwnStrengthDoes) {
  const double width = 0.1e-3 / 1e9;
  for (const double mu : {0., 0.2}) {
    const ContactLimits own = line_contact_limits(0.3, mu);
    const ContactLimits deep = layered_line_limits(0.3, mu, {1., layer_yield}, core_yield, width);
    EXPECT_NEAR(deep.first_yield, own.first_yield * layer_yield, 1e-6 * layer_yield);
    EXPECT_NEAR(deep.shakedown, own.shakedown * layer_yield, 1e-6 * layer_yield);
  }
}

TEST(HardenedLayer, ThatIsThinBearsWhatTheCoreDoes) {
  const double width = 0.1e-3 / 1e9;
  const ContactLimits core = line_contact_limits(0.3, 0.);
  const ContactLimits thin = layered_line_limits(0.3, 0., {1e-9, layer_yield}, core_yield, width);
  EXPECT_NEAR(thin.first_yield, core.first_yield * core_yield, 1e-4 * core_yield);
  EXPECT_NEAR(thin.shakedown, core.shakedown * core_yield, 1e-4 * core_yield);
  const ContactLimits point = point_contact_limits(0.3);
  EXPECT_NEAR(layered_point_limits(0.3, {1e-9, layer_yield}, core_yield, width).first_yield,
              point.first_yield * core_yield, 1e-4 * core_yield);
}

/// On the axis sxx = -p0 ((1 + 2 z^2)/s - 2 z), szz = -p0/s, s = sqrt(1 + z^2), lengths over b.
TEST(HardenedLayer, CoreYieldsOnTheAxisRightBelowIt) {
  const double depth = 0.3e-3;
  const double width = 0.2e-3 / 1e9;
  const double nu = 0.3;
  const double limit =
      layered_line_limits(nu, 0., {depth, layer_yield}, core_yield, width).first_yield;
  EXPECT_LT(limit, line_contact_limits(nu, 0.).first_yield * layer_yield);
  const double z = depth / (width * limit);
  ASSERT_GT(z, 0.8);  // below the greatest stress
  const double s = std::hypot(1., z);
  const double xx = -limit * ((1. + 2. * z * z) / s - 2. * z);
  const double zz = -limit / s;
  const double yy = nu * (xx + zz);
  const double mises =
      std::sqrt(((xx - zz) * (xx - zz) + (zz - yy) * (zz - yy) + (yy - xx) * (yy - xx)) / 2.);
  EXPECT_NEAR(mises, core_yield, 1e-3 * core_yield);
}

TEST(HardenedLayer, BearsMoreTheDeeperItIs) {
  const double width = 0.2e-3 / 1e9;
  ContactLimits before{0., 0.};
  for (const double depth : {1e-5, 1e-4, 2e-4, 4e-4, 8e-4}) {
    const ContactLimits limits =
        layered_line_limits(0.3, 0.1, {depth, layer_yield}, core_yield, width);
    EXPECT_GE(limits.first_yield, before.first_yield * (1. - 1e-5)) << depth;
    EXPECT_GE(limits.shakedown, before.shakedown * (1. - 1e-5)) << depth;
    before = limits;
  }
}

TEST(HardenedLayer, YieldsAtAThirdOfItsHardness) {
  EXPECT_NEAR(yield_strength_by_hardness(700.), 2288.2e6, 0.1e6);
  test::expect_refused([] { yield_strength_by_hardness(0.); }, {"hardness"});
}

}  // namespace
}  // namespace geneva::loads
