#include "loads/held_cylinder.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "loads/pi.h"

namespace geneva::loads::test {
namespace {

constexpr double radius = 0.01;
constexpr double pi_quarter = pi / 4.;

HertzLine contact_of(const double half_width) {
  constexpr double modulus = 115e9;
  return hertz_line(pi_quarter * half_width * half_width * modulus / radius, radius, modulus);
}

/// What the cylinder's size adds to the shear in a half-plane, over b/R.
double added(const double width_over_radius, const double core_over_radius,
             const double poissons_ratio) {
  const HertzLine hertz = contact_of(width_over_radius * radius);
  const DeepStress found =
      maximum_shear_in_held_cylinder(hertz, radius, core_over_radius * radius, poissons_ratio);
  return (found.value / hertz.max_shear - 1.) / width_over_radius;
}

TEST(HeldCylinder, HasHertzsShearWhereTheContactIsNarrow) {
  const HertzLine hertz = contact_of(1e-6 * radius);
  const DeepStress found = maximum_shear_in_held_cylinder(hertz, radius, radius / 2., 0.3);
  EXPECT_NEAR(found.value / hertz.max_shear, 1., 1e-5);
  EXPECT_NEAR(found.depth / hertz.max_shear_depth, 1., 1e-5);
}

TEST(HeldCylinder, AddsAShareInProportionToTheWidth) {
  EXPECT_NEAR(added(0.02, 0.5, 0.3) / added(0.01, 0.5, 0.3), 1., 0.02);
  EXPECT_NEAR(added(0.04, 0.5, 0.3) / added(0.01, 0.5, 0.3), 1., 0.05);
  EXPECT_NEAR(added(1e-4, 0.5, 0.3) / added(0.01, 0.5, 0.3), 1., 1e-5);
}

TEST(HeldCylinder, AddsMoreWithALargerCore) {
  EXPECT_NEAR(added(0.01, 0.25, 0.3), 1.542, 0.01);
  EXPECT_NEAR(added(0.01, 0.5, 0.3), 2.058, 0.01);
  EXPECT_NEAR(added(0.01, 0.7, 0.3), 3.272, 0.01);
}

TEST(HeldCylinder, WithASmallCoreIsFlamantsAndKelvinsFieldInACircle) {
  // A force at the middle, a uniform tension and r^3 cos(theta) free the circle of traction; the
  // arc takes away 0.14 b/R (doc/theory.md, 7), and forces normal to it instead of parallel ones
  // add 0.093 b/R, by Flamant's field of their parts along the surface.
  for (const double nu : {0., 0.3, 0.45}) {
    const double tension = (3. - 2. * nu) / (1. - nu) / (8. * 0.3003);
    EXPECT_NEAR(added(0.01, 0.01, nu), tension - 0.14 + 0.093, 0.01) << nu;
  }
}

TEST(HeldCylinder, IsContinuousWhereWavesNoLongerReachTheCore) {
  EXPECT_NEAR(added(0.01, 0.5 + 1e-6, 0.3), added(0.01, 0.5, 0.3), 1e-3);
  EXPECT_NEAR(added(0.01, 0.9 + 1e-6, 0.3), added(0.01, 0.9, 0.3), 1e-2);
}

TEST(HeldCylinder, RefusesWhatItIsNotKnownFor) {
  const HertzLine hertz = contact_of(0.01 * radius);
  EXPECT_THROW(maximum_shear_in_held_cylinder(hertz, radius, radius, 0.3), base::InputError);
  EXPECT_THROW(maximum_shear_in_held_cylinder(hertz, radius, 0., 0.3), base::InputError);
  EXPECT_THROW(maximum_shear_in_held_cylinder(hertz, radius, radius / 2., 0.5), base::InputError);
  EXPECT_THROW(maximum_shear_in_held_cylinder(contact_of(0.3 * radius), radius, radius / 2., 0.3),
               base::InputError);
}

}  // namespace
}  // namespace geneva::loads::test
