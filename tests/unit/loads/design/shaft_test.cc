#include "loads/design/shaft.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "loads/design/johnson.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/design/johnson_units.h"
#include "tests/unit/loads/random_values.h"

namespace geneva::loads {
namespace {

using test::between;
using test::expect_refused;
using namespace test::johnson_units;

constexpr double shear_modulus = 12e6 * psi;

const Shaft thin{{{0.375 * inch, 5. * inch}}, shear_modulus, density};
const Shaft thick{{{1. * inch, 3. * inch}}, shear_modulus, density};

/// Johnson's J_L = 0.0046 lbf s^2 in, four stations (a_v = omega^2) and 600 rpm.
TorsionalVibration example(const Shaft& shaft) {
  const double speed = 600. * 2. * pi / 60.;
  return torsional_vibration(shaft, 0.0046 * inertia_unit,
                             johnson_row(4).exit_acceleration_ratio * speed * speed);
}

// Tolerances are half a unit of the last digit given.

TEST(JohnsonExampleTwo, TheTorqueOfEquationTenIs18Point16PoundInches) {
  EXPECT_NEAR(example(thin).torque / moment_unit, 18.16, 5e-3);  // he prints 18.15
  EXPECT_EQ(example(thin).torque, example(thick).torque);
}

TEST(JohnsonExampleTwo, TheThinShaftSwingsTooFar) {
  const TorsionalVibration vibration = example(thin);
  EXPECT_NEAR(vibration.twist, 0.0038975, 5e-8);
  EXPECT_NEAR(vibration.double_amplitude(2. * inch) / inch, 0.015590, 5e-7);
  EXPECT_NEAR(vibration.frequency, 160.18, 5e-3);
  EXPECT_NEAR(vibration.energy / moment_unit, 0.035389, 5e-7);
}

TEST(JohnsonExampleTwo, TheThickShaftSwings84TimesLess) {
  const TorsionalVibration vibration = example(thick);
  EXPECT_NEAR(vibration.twist, 4.6244e-5, 5e-10);
  EXPECT_NEAR(vibration.double_amplitude(2. * inch) / inch, 0.00018498, 5e-9);
  EXPECT_NEAR(vibration.frequency, 1470.5, 5e-2);
  EXPECT_NEAR(vibration.energy / moment_unit, 0.00041990, 5e-9);
  // length times 5/3 and diameter to the fourth power; he says 85 to 1 from his rounded figures
  EXPECT_NEAR(example(thin).twist / vibration.twist, 5. / 3. * std::pow(8. / 3., 4), 1e-11);
}

TEST(JohnsonExampleTwo, TheThickShaftsOwnInertiaIsLessThanFivePercentOfTheLoads) {
  EXPECT_NEAR(shaft_inertia(thick) / inertia_unit, 0.00021593, 5e-9);
  EXPECT_LT(shaft_inertia(thick) / (0.0046 * inertia_unit), 0.05);  // "less than 5 per cent"
}

TEST(JohnsonExampleTwo, PrintedFiguresFollowFromTheRightOnesButForTwo) {
  EXPECT_NEAR(example(thin).twist, 0.00390, 5e-6);
  EXPECT_NEAR(example(thin).double_amplitude(2. * inch) / inch, 0.0156, 5e-5);
  EXPECT_NEAR(example(thin).energy / moment_unit, 0.0354, 5e-5);
  EXPECT_NEAR(example(thick).twist, 0.0000462, 5e-8);
  EXPECT_NEAR(example(thick).frequency, 1470., 5.);
  EXPECT_NEAR(example(thick).energy / moment_unit, 0.00042, 5e-6);
  // he prints 159 for the thin shaft's 160.2 cps: 0.7 % off, more than his slide rule's third digit
  EXPECT_GT(std::abs(example(thin).frequency - 159.), 1.);
  // and l = 3 in the line whose result is that of l = 5
  const Shaft misprint{{{0.375 * inch, 3. * inch}}, shear_modulus, density};
  EXPECT_NEAR(example(misprint).twist, 0.6 * 0.0038975, 5e-8);
}

TEST(Shaft, AHandBookShaftHasTheStiffnessOfEquationFifteen) {
  // c = pi G d^4/(32 l): G = 80 GPa, d = 20 mm, l = 0.1 m
  const Shaft shaft{{{0.02, 0.1}}, 80e9, 7850.};
  EXPECT_NEAR(torsional_stiffness(shaft), pi * 80e9 * 1.6e-7 / 3.2, 1e-9);
  EXPECT_NEAR(shaft_inertia(shaft), 7850. * pi * 1.6e-7 * 0.1 / 32., 1e-18);
}

TEST(Shaft, SegmentsAddTheirTwistsAsInEquationThirteen) {
  const Shaft stepped{{{0.01, 0.05}, {0.02, 0.08}, {0.015, 0.03}}, 80e9, 7850.};
  double compliance = 0.;
  double inertia = 0.;
  for (const ShaftSegment& segment : stepped.segments) {
    const Shaft one{{segment}, 80e9, 7850.};
    compliance += 1. / torsional_stiffness(one);
    inertia += shaft_inertia(one);
  }
  EXPECT_NEAR(torsional_stiffness(stepped) * compliance, 1., 1e-14);
  EXPECT_NEAR(shaft_inertia(stepped) / inertia, 1., 1e-14);
}

TEST(Shaft, TheEquivalentLengthReplacesTheSteps) {
  const Shaft stepped{{{0.01, 0.05}, {0.02, 0.08}}, 80e9, 7850.};
  EXPECT_NEAR(equivalent_length(stepped, 0.01), 0.05 + 0.08 / 16., 1e-16);
  EXPECT_NEAR(equivalent_length(stepped, 0.02), 0.05 * 16. + 0.08, 1e-15);
}

RC_GTEST_PROP(ShaftProperty, EquationsFourteenToSixteenBelongTogether, ()) {
  const Shaft shaft{
      {{between(1e-3, 0.1), between(1e-3, 1.)}, {between(1e-3, 0.1), between(0.1, 1.)}},
      between(1e9, 1e11),
      between(1000., 20000.)};
  const double inertia = between(1e-6, 1.);
  const double acceleration = between(1., 1e5);
  const TorsionalVibration vibration = torsional_vibration(shaft, inertia, acceleration);
  // W = T^2/(2 c); a vibration of this amplitude and frequency starts with the acceleration a_v
  const double circular = 2. * pi * vibration.frequency;
  RC_ASSERT(std::abs(circular * circular * vibration.twist / acceleration - 1.) < 1e-12);
  RC_ASSERT(
      std::abs(2. * vibration.energy * vibration.stiffness / (vibration.torque * vibration.torque) -
               1.) < 1e-12);
}

TEST(Shaft, RefusesWhatIsNoShaft) {
  expect_refused([] { torsional_stiffness({{}, 80e9, 7850.}); }, {"0 segments", "give"});
  expect_refused(
      [] {
        torsional_stiffness({{{0., 0.1}}, 80e9, 7850.});
      },
      {"shaft diameter is 0 mm"});
  expect_refused([] { shaft_inertia({{{0.01, -0.1}}, 80e9, 7850.}); }, {"shaft length is -100 mm"});
  expect_refused(
      [] {
        torsional_stiffness({{{0.01, 0.1}}, 0., 7850.});
      },
      {"shear modulus is 0 Pa"});
  expect_refused([] { shaft_inertia({{{0.01, 0.1}}, 80e9, -1.}); }, {"density is -1 kg/m^3"});
  expect_refused([] { equivalent_length(thin, 0.); }, {"equivalent shaft is 0 mm"});
}

TEST(Shaft, RefusesALoadThatCannotVibrate) {
  expect_refused([] { torsional_vibration(thin, 0., 1.); }, {"load inertia is 0 kg m^2"});
  expect_refused([] { torsional_vibration(thin, 1., -1.); }, {"exit acceleration is -1 rad/s^2"});
}

}  // namespace
}  // namespace geneva::loads
