#include "loads/hertz.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/random_values.h"

namespace geneva::loads {
namespace {

using test::between;
using test::expect_refused;

const Elastic steel{210e9, 0.3};

/// Closed forms: a few roundings.
constexpr double closed_form = 1e-14;

HertzLine unit_line() { return HertzLine{1., 1., 0., 0.}; }

TEST(ContactModulus, OfTwoEqualBodiesIsHalfTheReducedModulus) {
  EXPECT_NEAR(contact_modulus(steel, steel) / (210e9 / (2. * 0.91)), 1., closed_form);
  EXPECT_NEAR(contact_modulus_plane_stress(steel, steel) / 105e9, 1., closed_form);
}

TEST(ContactModulus, OnARigidBodyIsThatOfTheSoftOne) {
  const Elastic rigid{1e30, 0.};
  EXPECT_NEAR(contact_modulus(rigid, steel) / (210e9 / 0.91), 1., closed_form);
}

TEST(ContactModulus, RefusesModulusThatIsNotPositive) {
  expect_refused([] { contact_modulus(steel, {-1., 0.3}); }, {"Young's modulus is -1 Pa"});
}

TEST(ContactModulus, RefusesPoissonsRatioOutOfRange) {
  expect_refused(
      [] {
        contact_modulus({1e9, 0.5}, steel);
      },
      {"Poisson's ratio is 0.5", "between -1 and 0.5", "give"});
  expect_refused(
      [] {
        contact_modulus_plane_stress({1e9, -1.}, steel);
      },
      {"Poisson's ratio is -1"});
}

TEST(HertzLine, SatisfiesTheTextbookEquations) {
  // p0 = sqrt(F' E*/(pi R)) and b = sqrt(4 F' R/(pi E*)); 1 kN/mm, R = 10 mm, E* = 115.385 GPa
  const HertzLine line = hertz_line(1e6, 0.01, 105e9 / 0.91);
  EXPECT_NEAR(line.peak_pressure / std::sqrt(1e6 * 105e9 / 0.91 / (pi * 0.01)), 1., closed_form);
  EXPECT_NEAR(line.half_width / std::sqrt(4e6 * 0.01 * 0.91 / (pi * 105e9)), 1., closed_form);
  EXPECT_NEAR(line.peak_pressure, 1916.46e6, 5e3);  // six digits
  EXPECT_NEAR(line.half_width, 0.332186e-3, 5e-10);
}

TEST(HertzLine, MaximumShearIsThreeTenthsOfPeakPressureAtFourFifthsOfHalfWidth) {
  const HertzLine line = hertz_line(1e6, 0.01, 1e11);
  EXPECT_NEAR(line.max_shear / line.peak_pressure, 0.300283, 5e-7);  // the digits given
  EXPECT_NEAR(line.max_shear_depth / line.half_width, 0.786151, 5e-7);
}

TEST(HertzLine, MaximumVonMisesIsBelowTheSurfaceOrOnItBelowNuOfAFifth) {
  const HertzLine contact = hertz_line(1e5, 0.01, 1e11);
  const DeepStress of_steel = maximum_von_mises(contact, 0.3);
  EXPECT_NEAR(of_steel.value / contact.peak_pressure, 0.5575, 1e-4);
  EXPECT_NEAR(of_steel.depth / contact.half_width, 0.704, 1e-3);
  EXPECT_NEAR(maximum_von_mises(contact, 0.49).value / contact.peak_pressure, 0.5202, 1e-4);
  const DeepStress of_foam = maximum_von_mises(contact, 0.1);
  EXPECT_NEAR(of_foam.value / contact.peak_pressure, 0.8, 1e-12);
  EXPECT_EQ(of_foam.depth, 0.);
}

TEST(HertzLine, PressureIsEllipticAndCarriesTheForce) {
  const HertzLine line = hertz_line(1e6, 0.01, 1e11);
  EXPECT_DOUBLE_EQ(line.pressure(0.), line.peak_pressure);
  EXPECT_NEAR(line.pressure(0.6 * line.half_width) / line.peak_pressure, 0.8, closed_form);
  EXPECT_EQ(line.pressure(-1.001 * line.half_width), 0.);
  // with x = b sin t the midpoint rule on the periodic integrand is exact to rounding
  double force = 0.;
  const int points = 16;
  for (int i = 0; i < points; ++i) {
    const double t = pi * ((i + 0.5) / points - 0.5);
    force +=
        line.pressure(line.half_width * std::sin(t)) * line.half_width * std::cos(t) * pi / points;
  }
  EXPECT_NEAR(force / 1e6, 1., 1e-13);
}

TEST(HertzLine, RefusesWhatIsNotPositiveAndFinite) {
  expect_refused([] { hertz_line(-2., 0.01, 1e11); }, {"force per length is -2 N/m", "positive"});
  expect_refused([] { hertz_line(1., -0.01, 1e11); }, {"relative radius is -10 mm", "positive"});
  expect_refused([] { hertz_line(1., 0.01, HUGE_VAL); }, {"contact modulus is inf Pa", "finite"});
}

TEST(McEwen, SurfaceStressesInsideTheContactEqualThePressure) {
  const HertzLine line = unit_line();
  for (const double x : {-0.99, -0.5, 0., 0.3, 0.8}) {
    const ContactStress stress = line.stress(x, 0.);
    EXPECT_NEAR(stress.xx, -line.pressure(x), closed_form) << x;
    EXPECT_NEAR(stress.zz, -line.pressure(x), closed_form) << x;
    EXPECT_NEAR(stress.xz, 0., closed_form) << x;
  }
}

TEST(McEwen, SurfaceOutsideTheContactIsFree) {
  for (const double x : {-7., -1.001, -1., 1., 1.5, 20.}) {
    const ContactStress stress = unit_line().stress(x, 0.);
    EXPECT_NEAR(stress.xx, 0., closed_form) << x;
    EXPECT_NEAR(stress.zz, 0., closed_form) << x;
    EXPECT_NEAR(stress.xz, 0., closed_form) << x;
  }
}

TEST(McEwen, IsContinuousDownToTheEdgesOfTheContact) {
  // near the edge the stresses grow as the square root of the distance
  for (const double x : {-1., 1.}) {
    const ContactStress stress = unit_line().stress(x, 1e-12);
    EXPECT_NEAR(stress.xx, 0., 4e-6);
    EXPECT_NEAR(stress.zz, 0., 4e-6);
    EXPECT_NEAR(stress.xz, 0., 4e-6);
  }
}

TEST(McEwen, OnTheAxisAgreesWithTheSimpleForms) {
  for (const double z : {0., 0.2, 0.786, 2., 10.}) {
    const double root = std::sqrt(1. + z * z);
    const ContactStress stress = unit_line().stress(0., z);
    // xx is the difference of terms of size 2 z
    EXPECT_NEAR(stress.xx, -((1. + 2. * z * z) / root - 2. * z), 1e-14 * (1. + 2. * z)) << z;
    EXPECT_NEAR(stress.zz, -1. / root, closed_form) << z;
    EXPECT_EQ(stress.xz, 0.) << z;
  }
}

TEST(McEwen, FarBelowTendsToTheLineLoad) {
  // Flamant: zz = -2 F'/(pi z) on the axis, F' = pi p0 b/2; corrections of order (b/z)^2
  const double z = 100.;
  EXPECT_NEAR(unit_line().stress(0., z).zz, -1. / z, 1. / (z * z * z));
  EXPECT_NEAR(unit_line().stress(z, z).xz, unit_line().stress(z, z).zz, 1. / (z * z * z));
}

TEST(McEwen, EveryLevelCarriesTheForce) {
  // x = z tan t maps the level to (-pi/2, pi/2), where the integrand is smooth and periodic
  const double depth = 0.7;
  double force = 0.;
  const int points = 400;
  for (int i = 0; i < points; ++i) {
    const double t = pi * ((i + 0.5) / points - 0.5);
    const double cosine = std::cos(t);
    force +=
        unit_line().stress(depth * std::tan(t), depth).zz * depth / (cosine * cosine) * pi / points;
  }
  EXPECT_NEAR(force, -pi / 2., 1e-10);
}

double maximum_shear(const ContactStress& stress) {
  return std::hypot((stress.xx - stress.zz) / 2., stress.xz);
}

TEST(McEwen, ReachesTheMaximumShearAtItsDepthOnly) {
  const HertzLine line = hertz_line(1e6, 0.01, 1e11);
  const double shear = maximum_shear(line.stress(0., line.max_shear_depth));
  EXPECT_NEAR(shear / line.max_shear, 1., closed_form);
  for (const double factor : {0.99, 1.01})
    EXPECT_LT(maximum_shear(line.stress(0., factor * line.max_shear_depth)), shear);
}

TEST(McEwen, RefusesPointsAboveTheSurface) {
  expect_refused([] { return unit_line().stress(0., -1e-3); },
                 {"depth below the contact is -1 mm"});
}

RC_GTEST_PROP(McEwenProperty, NoPointExceedsTheMaximumShear, ()) {
  const HertzLine line = hertz_line(1e6, 0.01, 1e11);
  const ContactStress stress =
      line.stress(between(-3., 3.) * line.half_width, between(0., 3.) * line.half_width);
  RC_ASSERT(maximum_shear(stress) <= line.max_shear * (1. + closed_form));
}

RC_GTEST_PROP(McEwenProperty, NormalStressesAreEvenAndShearIsOdd, ()) {
  const double x = between(0., 5.);
  const double z = between(0., 5.);
  const ContactStress right = unit_line().stress(x, z);
  const ContactStress left = unit_line().stress(-x, z);
  RC_ASSERT(right.xx == left.xx);
  RC_ASSERT(right.zz == left.zz);
  RC_ASSERT(right.xz == -left.xz);
}

RC_GTEST_PROP(McEwenProperty, StressesAreInEquilibrium, ()) {
  // singularities only at (+-1, 0), at least 0.2 away: central differences with h = 1e-4 err by
  // h^2/6 f''' with f''' < 3! 1/0.1^3, below 1e-5, and by rounding, 1e-11
  const HertzLine line = unit_line();
  const double x = between(-3., 3.);
  const double z = between(0.2, 3.);
  const double h = 1e-4;
  const ContactStress east = line.stress(x + h, z);
  const ContactStress west = line.stress(x - h, z);
  const ContactStress below = line.stress(x, z + h);
  const ContactStress above = line.stress(x, z - h);
  RC_ASSERT(std::abs(east.xx - west.xx + below.xz - above.xz) / (2. * h) < 1e-5);
  RC_ASSERT(std::abs(east.xz - west.xz + below.zz - above.zz) / (2. * h) < 1e-5);
}

RC_GTEST_PROP(McEwenProperty, StressesDecayWithTheDistance, ()) {
  // a line load makes at most 2 F'/(pi r) = p0 b/r; here r differs from the distance by at most
  // b, a quarter of it: at most 4/3 p0 b/distance
  const double angle = between(-pi / 2., pi / 2.);
  const double distance = between(4., 100.);
  const ContactStress stress =
      unit_line().stress(distance * std::sin(angle), std::max(0., distance * std::cos(angle)));
  RC_ASSERT(std::max({std::abs(stress.xx), std::abs(stress.zz), std::abs(stress.xz)}) <
            2. / distance);
}

TEST(HertzPoint, SatisfiesTheTextbookEquations) {
  const double modulus = 105e9 / 0.91;
  const HertzPoint point = hertz_point(100., 0.01, modulus, 0.3);
  EXPECT_NEAR(point.contact_radius / std::cbrt(3. * 100. * 0.01 / (4. * modulus)), 1., closed_form);
  EXPECT_NEAR(
      point.peak_pressure / std::cbrt(6. * 100. * modulus * modulus / (pi * pi * pi * 0.01 * 0.01)),
      1., closed_form);
  EXPECT_NEAR(point.approach / std::cbrt(9. * 1e4 / (16. * 0.01 * modulus * modulus)), 1.,
              closed_form);
}

TEST(HertzPoint, MaximumShearForPoissonsRatioOfThreeTenths) {
  const HertzPoint point = hertz_point(100., 0.01, 1e11, 0.3);
  EXPECT_NEAR(point.max_shear / point.peak_pressure, 0.310, 5e-4);  // the digits of the textbook
  EXPECT_NEAR(point.max_shear_depth / point.contact_radius, 0.48, 5e-3);
}

/// tau/p0 on the axis at depth zeta a (K. L. Johnson, 1985, Eq. 3.45), from its two stresses.
double axial_shear(double zeta, double nu) {
  const double radial = -(1. + nu) * (1. - zeta * std::atan2(1., zeta)) + 0.5 / (1. + zeta * zeta);
  const double axial = -1. / (1. + zeta * zeta);
  return std::abs(axial - radial) / 2.;
}

RC_GTEST_PROP(HertzPointProperty, NoDepthExceedsTheMaximumShear, ()) {
  const double nu = between(-0.99, 0.49);
  const HertzPoint point = hertz_point(100., 0.01, 1e11, nu);
  const double maximum = point.max_shear / point.peak_pressure;
  RC_ASSERT(axial_shear(between(0., 3.), nu) <= maximum * (1. + closed_form));
  RC_ASSERT(std::abs(axial_shear(point.max_shear_depth / point.contact_radius, nu) - maximum) <
            closed_form);
}

TEST(HertzPoint, PressureIsEllipticAndCarriesTheForce) {
  const HertzPoint point = hertz_point(100., 0.01, 1e11, 0.3);
  EXPECT_EQ(point.pressure(1.001 * point.contact_radius), 0.);
  EXPECT_NEAR(point.pressure(0.6 * point.contact_radius) / point.peak_pressure, 0.8, closed_form);
  // 2/3 p0 pi a^2
  EXPECT_NEAR(2. / 3. * point.peak_pressure * pi * std::pow(point.contact_radius, 2) / 100., 1.,
              closed_form);
}

TEST(HertzPoint, RefusesWhatIsNotPositiveAndFinite) {
  expect_refused([] { hertz_point(0., 0.01, 1e11, 0.3); }, {"force is 0 N", "positive"});
  expect_refused([] { hertz_point(1., 0., 1e11, 0.3); }, {"relative radius is 0 mm"});
  expect_refused([] { hertz_point(1., 0.01, 0., 0.3); }, {"contact modulus is 0 Pa"});
  expect_refused([] { hertz_point(1., 0.01, 1e11, 0.6); }, {"Poisson's ratio is 0.6"});
}

/// Sum of p/(pi E* distance) over the ellipse, in polar coordinates around the point (x, y).
double surface_displacement(const HertzEllipse& contact, const double modulus, const double x,
                            const double y) {
  const double a = contact.semi_axis_long;
  const double b = contact.semi_axis_short;
  const int rays = 400;
  double sum = 0.;
  for (int i = 0; i < rays; ++i) {
    const double angle = 2. * pi * (i + 0.5) / rays;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // p = p0 sqrt(r - 2 q t - w t^2) along the ray; to its end the area is that of a circle's part
    const double w = c * c / (a * a) + s * s / (b * b);
    const double q = x * c / (a * a) + y * s / (b * b);
    const double r = 1. - x * x / (a * a) - y * y / (b * b);
    const double radius = std::sqrt(r + q * q / w);
    const double start = q / std::sqrt(w) / radius;
    sum += radius * radius / std::sqrt(w) *
           (std::acos(start) - start * std::sqrt(1. - start * start)) / 2.;
  }
  return contact.peak_pressure / (pi * modulus) * sum * 2. * pi / rays;
}

TEST(HertzEllipse, PressureDisplacesTheSurfaceIntoContact) {
  const double modulus = 1.1e11;
  for (const double ratio : {1.001, 2., 10., 60.}) {
    const HertzEllipse contact = hertz_ellipse(800., 0.02 * ratio, 0.02, modulus);
    const double a = contact.semi_axis_long;
    const double b = contact.semi_axis_short;
    EXPECT_NEAR(2. / 3. * pi * a * b * contact.peak_pressure, 800., 1e-9);
    for (const auto& [x, y] :
         {std::pair(0., 0.), {0.6 * a, 0.}, {0., 0.7 * b}, {0.3 * a, -0.4 * b}}) {
      const double gap = x * x / (2. * 0.02 * ratio) + y * y / (2. * 0.02);
      EXPECT_NEAR(surface_displacement(contact, modulus, x, y), contact.approach - gap,
                  1e-7 * contact.approach)
          << ratio;
    }
  }
}

TEST(HertzEllipse, OfEqualRadiiIsTheCircle) {
  const HertzPoint point = hertz_point(10., 0.01, 1e11, 0.3);
  for (const double ratio : {1., 1. + 1e-8}) {
    const HertzEllipse contact = hertz_ellipse(10., 0.01 * ratio, 0.01, 1e11);
    EXPECT_NEAR(contact.peak_pressure, point.peak_pressure, 1e-7 * point.peak_pressure);
    EXPECT_NEAR(contact.semi_axis_long, point.contact_radius, 1e-7 * point.contact_radius);
    EXPECT_NEAR(contact.approach, point.approach, 1e-7 * point.approach);
  }
}

TEST(HertzEllipse, RefusesExchangedRadii) {
  test::expect_refused([] { hertz_ellipse(10., 0.01, 0.02, 1e11); }, {"20 mm", "exchange"});
}

}  // namespace
}  // namespace geneva::loads
