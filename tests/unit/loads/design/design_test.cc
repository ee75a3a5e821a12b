#include "loads/design/design.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "loads/motion/external_geneva.h"
#include "loads/pi.h"
#include "loads/wheel/outline.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/design/johnson_units.h"
#include "tests/unit/loads/random_values.h"

namespace geneva::loads {
namespace {

using test::between;
using test::expect_refused;
using namespace test::johnson_units;

/// Johnson's Example 1, exact kinematics.
DesignInput example_one() {
  DesignInput input{};
  input.dimensions.stations = 4;
  input.dimensions.wheel_diameter = 4.53 * inch;
  input.load = {solid_cylinder_inertia(4. * inch, 0.25 * inch, density), 2. * pound * inch};
  input.driver_speed = 20. * pi;
  input.density = density;
  input.pin = {30e6 * psi, 0.3};
  input.wheel = {30e6 * psi, 0.3};
  return input;
}

DesignInput with_stations(DesignInput input, int stations) {
  input.dimensions.stations = stations;
  return input;
}

TEST(Design, ExampleOneGivesTheOptimumWheelThatJohnsonPrints) {
  const auto wheel = johnson_optimum(example_one());
  ASSERT_TRUE(wheel.has_value());
  EXPECT_NEAR(wheel->diameter / inch, 4.53, 5e-3);
  // he takes 0.0046 for the load's 0.004607: 0.14 %, and 0.2384 and 5.409 for 0.2387 and 5.4070
  EXPECT_NEAR(wheel->inertia / inertia_unit / 0.00704, 1., 2.5e-3);
  EXPECT_NEAR(wheel->force / pound / 232., 1., 5e-3);
  EXPECT_NEAR(wheel->peak_pressure / psi / 72600., 1., 5e-3);
  EXPECT_NEAR(wheel->pin_diameter / inch, 0.68, 5e-3);
  EXPECT_NEAR(wheel->thickness / inch, 0.68, 5e-3);
  EXPECT_NEAR(wheel->locking_radius / inch, 1.59, 1e-2);
}

struct PrintedWheel {
  double diameter, unrounded_inertia, inertia_unit, unrounded_force, unrounded_stress;
  double force, stress;
};

TEST(Design, ExampleOneGivesTheThreeWheelsThatJohnsonPrints) {
  // unrounded: with Table 1's k = 0.2384 and 5.409, which change force and stress by 0.21 % and
  // 0.11 % against the recomputed ones
  const PrintedWheel wheels[] = {{4.53, 0.0070769, 1e-7, 232.87, 72750., 232., 72600.},
                                 {2., 0.00011871, 1e-8, 215.82, 158632., 215., 158200.},
                                 {6., 0.028847, 1e-6, 500.82, 80549., 499., 80400.}};
  for (const PrintedWheel& printed : wheels) {
    const DesignedWheel wheel = johnson_wheel(example_one(), printed.diameter * inch);
    EXPECT_NEAR(wheel.inertia / inertia_unit, printed.unrounded_inertia,
                0.51 * printed.inertia_unit);
    EXPECT_NEAR(wheel.force / pound / printed.unrounded_force, 1., 2.1e-3);
    EXPECT_NEAR(wheel.peak_pressure / psi / printed.unrounded_stress, 1., 1.1e-3);
    EXPECT_NEAR(wheel.force / pound / printed.force, 1., 5e-3);
    EXPECT_NEAR(wheel.peak_pressure / psi / printed.stress, 1., 5e-3);
  }
}

TEST(Design, AWheelOfJohnsonsHasTheStressOfEquationEight) {
  const DesignInput input = example_one();
  const double stress = johnson_stress_of_diameter(
      0.1, johnson_row(4), input.load, design_acceleration(input), density, input.pin, input.wheel);
  EXPECT_NEAR(johnson_wheel(input, 0.1).peak_pressure / stress, 1., 1e-14);
}

TEST(Design, TheDrawnWheelOfExampleOneIsHeavierSoThatItsOptimumIsSmaller) {
  const auto johnson = johnson_optimum(example_one());
  const DrawnOptimum drawn = drawn_optimum(example_one());
  ASSERT_TRUE(johnson.has_value());
  EXPECT_NEAR(drawn.inertia_ratio, 1.5, 1e-12);  // Eq. 9: the same inertia from another diameter
  EXPECT_NEAR(drawn.wheel.inertia / johnson->inertia, 1., 1e-12);
  EXPECT_LT(drawn.wheel.diameter, johnson->diameter);
  EXPECT_FALSE(drawn.at_limit);
  // the fifth root of the ratio of the two constants, at the drawn wheel's own diameter
  const double own = drawn_wheel(example_one(), 4.53 * inch).inertia;
  const double ratio = own / johnson_wheel(example_one(), 4.53 * inch).inertia;
  EXPECT_NEAR(johnson->diameter / drawn.wheel.diameter, std::pow(ratio, 0.2), 1e-12);
}

TEST(Design, TheDrawnWheelIsThatOfTheMechanism) {
  DesignInput input = example_one();
  input.dimensions.pin_diameter = 0.5 * inch;
  input.dimensions.thickness = 0.75 * inch;
  const DesignedWheel wheel = drawn_wheel(input, 4.53 * inch);
  EXPECT_EQ(wheel.inertia, wheel_inertia(complete_dimensions(input.dimensions), density));
  EXPECT_NEAR(wheel.pin_diameter / inch, 0.5, 1e-15);
  EXPECT_NEAR(wheel.thickness / inch, 0.75, 1e-15);
}

TEST(Design, GivenLengthsScaleWithTheWheelOrStay) {
  DesignInput input = example_one();
  input.dimensions.pin_diameter = 0.5 * inch;
  const double half = 4.53 * inch / 2.;
  EXPECT_NEAR(drawn_wheel(input, half).pin_diameter / inch, 0.25, 1e-15);
  EXPECT_NEAR(drawn_wheel(input, half).thickness / half, 0.15, 1e-15);
  input.given_lengths = GivenLengths::stay;
  EXPECT_NEAR(drawn_wheel(input, half).pin_diameter / inch, 0.5, 1e-15);
  EXPECT_NEAR(drawn_wheel(input, half).thickness / half, 0.15, 1e-15);
}

TEST(Design, WithoutGivenLengthsStayingMakesNoDifference) {
  // the search stops where the diameter is known to 1e-7
  DesignInput input = example_one();
  const DrawnOptimum by_equation = drawn_optimum(input);
  input.given_lengths = GivenLengths::stay;
  const DrawnOptimum searched = drawn_optimum(input);
  EXPECT_NEAR(searched.wheel.diameter / by_equation.wheel.diameter, 1., 3e-7);
  EXPECT_NEAR(searched.wheel.peak_pressure / by_equation.wheel.peak_pressure, 1., 1e-12);
}

TEST(Design, APinThatStaysAsksForAnotherInertiaThanEquationNine) {
  // s^2 ~ (J + J_L + M_f/a)/(D t d) with t ~ D and d fixed: with J ~ D^p locally, the minimum
  // stress asks for J = 2/(p - 2) (J_L + M_f/a), where p > 5 since the slots do not grow with the
  // wheel
  DesignInput input = example_one();
  input.dimensions.pin_diameter = 0.68 * inch;
  input.given_lengths = GivenLengths::stay;
  const DrawnOptimum optimum = drawn_optimum(input);
  EXPECT_FALSE(optimum.at_limit);
  const double diameter = optimum.wheel.diameter;
  const double power = std::log(drawn_wheel(input, 1.001 * diameter).inertia /
                                drawn_wheel(input, 0.999 * diameter).inertia) /
                       std::log(1.001 / 0.999);
  EXPECT_GT(power, 5.);
  EXPECT_NEAR(optimum.inertia_ratio / (2. / (power - 2.)), 1., 1e-5);
  for (const double factor : {0.98, 0.999, 1.001, 1.02})
    EXPECT_GT(drawn_wheel(input, factor * diameter).peak_pressure, optimum.wheel.peak_pressure)
        << factor;
}

TEST(Design, AnOptimumThatCannotBeDrawnIsAtTheLimit) {
  // a pin so thick that wheels near the optimum have no room for its slots
  DesignInput input = example_one();
  input.dimensions.wheel_diameter = 12. * inch;
  input.dimensions.pin_diameter = 1.8 * inch;
  input.dimensions.locking_radius = 3. * inch;
  input.given_lengths = GivenLengths::stay;
  const DrawnOptimum optimum = drawn_optimum(input);
  EXPECT_TRUE(optimum.at_limit);
  expect_refused([&] { drawn_wheel(input, 0.999 * optimum.wheel.diameter); }, {"mm"});
  EXPECT_GT(drawn_wheel(input, 1.01 * optimum.wheel.diameter).peak_pressure,
            optimum.wheel.peak_pressure);
}

TEST(Design, BeyondTenStationsOnlyTheDrawnWheelHasAnOptimum) {
  const DesignInput input = with_stations(example_one(), 12);
  EXPECT_FALSE(johnson_optimum(input).has_value());
  EXPECT_NEAR(drawn_optimum(input).inertia_ratio, 1.5, 1e-12);
  expect_refused([&] { johnson_wheel(input, 0.1); }, {"number of stations is 12"});
}

TEST(Design, TheCurveRunsInEqualRatiosAndIsLeastAtTheOptima) {
  const DesignInput input = example_one();
  const double diameter = johnson_optimum(input)->diameter;
  const std::vector<DesignPoint> curve = design_curve(input, 0.3 * diameter, 3. * diameter, 100);
  ASSERT_EQ(curve.size(), 101U);
  EXPECT_NEAR(curve.front().diameter / diameter, 0.3, 1e-12);
  EXPECT_NEAR(curve.back().diameter / diameter, 3., 1e-12);
  for (std::size_t i = 1; i < curve.size(); ++i)
    EXPECT_NEAR(curve[i].diameter / curve[i - 1].diameter, std::pow(10., 0.01), 1e-12);
  const double least = johnson_optimum(input)->peak_pressure;
  const double minimum_drawn = drawn_optimum(input).wheel.peak_pressure;
  for (const DesignPoint& point : curve) {
    EXPECT_GE(point.johnson->peak_pressure, least);
    EXPECT_GE(point.drawn->peak_pressure, minimum_drawn);
  }
}

TEST(Design, ThePartOfTheCurveThatCannotBeDrawnIsEmpty) {
  DesignInput input = with_stations(example_one(), 12);
  input.dimensions.pin_diameter = 0.3 * inch;
  input.given_lengths = GivenLengths::stay;
  const std::vector<DesignPoint> curve = design_curve(input, inch, 10. * inch, 10);
  EXPECT_FALSE(curve.front().drawn.has_value());
  EXPECT_TRUE(curve[7].drawn.has_value());
  for (const DesignPoint& point : curve) EXPECT_FALSE(point.johnson.has_value());
}

TEST(Design, RefusesWhatHasNoOptimum) {
  DesignInput input = example_one();
  input.load = {0., 0.};
  expect_refused([&] { johnson_optimum(input); }, {"both 0", "give"});
  expect_refused([&] { drawn_optimum(input); }, {"both 0", "give"});
  input = example_one();
  input.driver_speed = 0.;
  expect_refused([&] { johnson_optimum(input); }, {"driver speed is 0 rad/s"});
  expect_refused([] { design_curve(example_one(), 0.2, 0.1, 5); }, {"last diameter"});
  expect_refused([] { design_curve(example_one(), 0.1, 0.2, 0); }, {"number of steps is 0"});
}

TEST(DesignTable, HasJohnsonsConstantsBesideThoseOfTheDrawnWheel) {
  // k5 of a full disc less slots and locking arcs, by a separate integration; two digits: 1 %
  const double drawn[] = {0.0048, 0.0057, 0.0055, 0.0061, 0.0063, 0.0065, 0.0064, 0.0055};
  const std::vector<DesignTableRow> table = design_table();
  ASSERT_EQ(table.size(), 22U);
  for (int n = 3; n <= 24; ++n) {
    const DesignTableRow& row = table[static_cast<std::size_t>(n - 3)];
    EXPECT_EQ(row.johnson.stations, n);
    EXPECT_EQ(row.johnson.k5.has_value(), n <= 10);
    EXPECT_GT(row.drawn_k5, 0.);
    if (n > 10) continue;
    EXPECT_NEAR(row.drawn_k5 / drawn[n - 3], 1., 0.0105) << n;
  }
}

TEST(WorkingCycle, TheLecturesExampleOfSixStationsAt360Rpm) {
  // ME341, example (n = 6, 360 rpm): a turn of 1/6 s, a third of it motion
  const WorkingCycle cycle = working_cycle(6, 12. * pi);
  EXPECT_NEAR(cycle.motion_fraction, 1. / 3., 1e-15);
  EXPECT_NEAR(cycle.motion_time, 1. / 18., 1e-15);
  EXPECT_NEAR(cycle.dwell_time, 1. / 9., 1e-15);
  EXPECT_NEAR(cycle.time_ratio, 0.5, 1e-15);
}

TEST(WorkingCycle, MotionOverDwellIsTheTimeRatio) {
  for (int n = 3; n <= 24; ++n) {
    const WorkingCycle cycle = working_cycle(n, 10.);
    EXPECT_NEAR(cycle.motion_time / cycle.dwell_time, cycle.time_ratio, 1e-14);
    EXPECT_NEAR(cycle.motion_time + cycle.dwell_time, 2. * pi / 10., 1e-15);
    // the driver turns through the engagement while the wheel moves
    EXPECT_NEAR(cycle.motion_time, 2. * ExternalGeneva(n).engagement_angle() / 10., 1e-15);
    EXPECT_LE(cycle.maximum_pins * cycle.motion_fraction, 1. + 1e-12);
    EXPECT_GT((cycle.maximum_pins + 1) * cycle.motion_fraction, 1.);
  }
}

TEST(WorkingCycle, AtMostSixPinsForThreeStations) {
  const int pins[] = {6, 4, 3, 3, 2, 2};
  for (int n = 3; n <= 8; ++n) EXPECT_EQ(working_cycle(n, 1.).maximum_pins, pins[n - 3]) << n;
  EXPECT_EQ(working_cycle(24, 1.).maximum_pins, 2);
}

TEST(WorkingCycle, RefusesWhatIsNoCycle) {
  expect_refused([] { working_cycle(2, 1.); }, {"number of stations is 2"});
  expect_refused([] { working_cycle(4, 0.); }, {"driver speed is 0 rad/s"});
}

RC_GTEST_PROP(DesignProperty, EquationNineIsTheMinimumForBothWheels, ()) {
  DesignInput input = example_one();
  input.dimensions.stations = test::random_stations();
  input.load = {between(1e-5, 1e-1), between(0., 10.)};
  input.driver_speed = between(1., 100.);
  input.density = between(1000., 20000.);
  // the relative rise is of second order, 1e-6 at the minimum step: far above rounding
  const double step = between(1e-3, 0.9);
  const DesignedWheel drawn = drawn_optimum(input).wheel;
  RC_ASSERT(drawn_wheel(input, drawn.diameter * (1. + step)).peak_pressure > drawn.peak_pressure);
  RC_ASSERT(drawn_wheel(input, drawn.diameter * (1. - step)).peak_pressure > drawn.peak_pressure);
  const auto johnson = johnson_optimum(input);
  RC_ASSERT(johnson.has_value() == (input.dimensions.stations <= 10));
  if (!johnson) return;
  const double least = johnson->peak_pressure;
  RC_ASSERT(johnson_wheel(input, johnson->diameter * (1. + step)).peak_pressure > least);
  RC_ASSERT(johnson_wheel(input, johnson->diameter * (1. - step)).peak_pressure > least);
}

}  // namespace
}  // namespace geneva::loads
