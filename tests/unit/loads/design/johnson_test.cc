#include "loads/design/johnson.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "loads/hertz.h"
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

struct TableRow {
  int stations;
  double beta;  // degrees
  double peak_acceleration;
  double peak_tolerance;  // half a unit of the last digit given
  double exit_acceleration;
  double k, k2, k4, k5, drawn_k5;
};

/// Table 1: kinematic columns recomputed, k2..k5 Johnson's, k5 of the drawn wheel without bore.
const TableRow table[] = {
    {3, 4.758, 31.392, 5e-4, 1.73205, 0.1547, 0.16, 0.70, 0.00353, 0.0048},
    {4, 11.464, 5.4070, 5e-5, 1.0, 0.2387, 0.15, 0.35, 0.00506, 0.0057},
    {5, 17.571, 2.2988, 5e-5, 0.72654, 0.2930, 0.14, 0.24, 0.00516, 0.0055},
    {6, 22.903, 1.3496, 5e-5, 0.57735, 0.3311, 0.14, 0.17, 0.00588, 0.0061},
    {7, 27.555, 0.92840, 5e-6, 0.48157, 0.3592, 0.14, 0.13, 0.00573, 0.0063},
    {8, 31.642, 0.69976, 5e-6, 0.41421, 0.3807, 0.13, 0.10, 0.00575, 0.0065},
    {9, 35.262, 0.55908, 5e-6, 0.36397, 0.3976, 0.12, 0.08, 0.00584, 0.0064},
    {10, 38.491, 0.46484, 5e-6, 0.32492, 0.4112, 0.10, 0.08, 0.00540, 0.0055}};

class JohnsonTable : public testing::TestWithParam<TableRow> {};

TEST_P(JohnsonTable, KinematicColumnsAreComputed) {
  const TableRow& expected = GetParam();
  const JohnsonRow row = johnson_row(expected.stations);
  EXPECT_EQ(row.stations, expected.stations);
  EXPECT_NEAR(row.peak_acceleration_angle / degree, expected.beta, 5e-4);
  EXPECT_NEAR(row.peak_acceleration_ratio, expected.peak_acceleration, expected.peak_tolerance);
  EXPECT_NEAR(row.exit_acceleration_ratio, expected.exit_acceleration, 5e-6);
  EXPECT_NEAR(row.k, expected.k, 5e-5);
}

TEST_P(JohnsonTable, ProportionsAreJohnsons) {
  const TableRow& expected = GetParam();
  const JohnsonRow row = johnson_row(expected.stations);
  EXPECT_EQ(row.k2, expected.k2);
  EXPECT_EQ(row.k3, expected.k2);
  EXPECT_EQ(row.k4, expected.k4);
  ASSERT_TRUE(row.k5.has_value());
  EXPECT_EQ(*row.k5, expected.k5);
  EXPECT_TRUE(row.from_table);
}

TEST_P(JohnsonTable, InertiaConstantOfTheDrawnWheelWithoutBore) {
  const TableRow& expected = GetParam();
  GenevaDimensionsInput input{};
  input.stations = expected.stations;
  input.wheel_diameter = 1.;
  const GenevaDimensions wheel = complete_dimensions(input);
  Outline outline = wheel_outline(wheel);
  outline.loops.resize(1);
  // J = t J_p rho with D = 1 m and rho = 1 is k5. Given to two digits: half a unit of the last one
  // is 1 % of the value.
  EXPECT_NEAR(wheel.thickness * area_moments(outline).polar_moment / expected.drawn_k5, 1., 0.0105);
}

INSTANTIATE_TEST_SUITE_P(EveryRow, JohnsonTable, testing::ValuesIn(table),
                         [](const testing::TestParamInfo<TableRow>& row) {
                           return std::to_string(row.param.stations) + "stations";
                         });

TEST(JohnsonRow, BeyondTenStationsProportionsShrinkWithThePitch) {
  for (int n = 11; n <= 24; ++n) {
    const JohnsonRow row = johnson_row(n);
    const double scale = std::sin(pi / n) / std::sin(pi / 10.);
    EXPECT_NEAR(row.k2, 0.10 * scale, 1e-15);
    EXPECT_NEAR(row.k3, 0.10 * scale, 1e-15);
    EXPECT_NEAR(row.k4, 0.08 * scale, 1e-15);
    EXPECT_FALSE(row.k5.has_value());
    EXPECT_FALSE(row.from_table);
  }
}

TEST(JohnsonRow, RefusesStationsOutOfRange) {
  expect_refused([] { johnson_row(2); }, {"number of stations is 2", "3 to 24"});
  expect_refused([] { johnson_row(25); }, {"number of stations is 25"});
}

// Johnson's Example 1 in his units.
const Elastic example_steel{30e6 * psi, 0.3};

WheelLoad example_load() {
  return {solid_cylinder_inertia(4. * inch, 0.25 * inch, density), 2. * pound * inch};
}

/// 600 rpm with the printed ratio 5.409.
double example_acceleration() {
  const double speed = 600. * 2. * pi / 60.;
  return 5.409 * speed * speed;
}

struct Example {
  const char* name;
  double diameter, inertia, force, pin, stress, half_width;       // Johnson's units
  double inertia_unit, force_unit, stress_unit, half_width_unit;  // of the last digit given
  double printed_force, printed_stress;
};

const Example examples[] = {
    {"optimum", 4.53, 0.0070769, 232.87, 0.6795, 72750., 0.0029990, 1e-7, 1e-2, 10., 1e-7, 232.,
     72600.},
    {"small", 2., 0.00011871, 215.82, 0.300, 158632., 0.0028871, 1e-8, 1e-2, 1., 1e-7, 215.,
     158200.},
    {"large", 6., 0.028847, 500.82, 0.900, 80549., 0.0043980, 1e-6, 1e-2, 1., 1e-7, 499., 80400.}};

class JohnsonExampleOne : public testing::TestWithParam<Example> {};

/// Johnson's Table 1 as printed for n = 4.
JohnsonRow printed_row() {
  JohnsonRow row = johnson_row(4);
  row.k = 0.2384;
  return row;
}

TEST_P(JohnsonExampleOne, UnroundedNumbers) {
  const Example& example = GetParam();
  const JohnsonRow row = printed_row();
  const double diameter = example.diameter * inch;
  const double inertia = johnson_wheel_inertia(*row.k5, density, diameter);
  const double force = pin_force(inertia, example_load(), example_acceleration(), row.k * diameter);
  const double pin = row.k2 * diameter;
  const double stress = johnson_stress(force, pin, pin, example_steel, example_steel);
  const HertzLine line =
      hertz_line(force / pin, pin / 2., contact_modulus(example_steel, example_steel));
  EXPECT_NEAR(inertia / inertia_unit, example.inertia, 0.51 * example.inertia_unit);
  EXPECT_NEAR(force / pound, example.force, 0.51 * example.force_unit);
  EXPECT_NEAR(pin / inch, example.pin, 1e-12);
  EXPECT_NEAR(stress / psi, example.stress, 0.51 * example.stress_unit);
  EXPECT_NEAR(line.half_width / inch, example.half_width, 0.51 * example.half_width_unit);
  EXPECT_NEAR(line.peak_pressure / stress, 1., 1e-14);  // Eq. 2 is Hertz's line contact
}

TEST_P(JohnsonExampleOne, EquationEightGivesTheSameStress) {
  const Example& example = GetParam();
  const double stress =
      johnson_stress_of_diameter(example.diameter * inch, printed_row(), example_load(),
                                 example_acceleration(), density, example_steel, example_steel);
  EXPECT_NEAR(stress / psi, example.stress, 0.51 * example.stress_unit);
}

TEST_P(JohnsonExampleOne, PrintedNumbersAreWithinHalfAPercent) {
  // Johnson rounds to three digits on the way: 21 300 for 21 354 and 3240 for 3239.4
  const Example& example = GetParam();
  EXPECT_NEAR(example.force / example.printed_force, 1., 5e-3);
  EXPECT_NEAR(example.stress / example.printed_stress, 1., 5e-3);
}

TEST_P(JohnsonExampleOne, RecomputedConstantsChangeTheStressByATenthOfAPercent) {
  // k = 0.2387 against 0.2384 and 5.4070 against 5.409: 0.14 % in force, half of it in stress
  const Example& example = GetParam();
  const JohnsonRow row = johnson_row(4);
  const double speed = 600. * 2. * pi / 60.;
  const double stress = johnson_stress_of_diameter(example.diameter * inch, row, example_load(),
                                                   row.peak_acceleration_ratio * speed * speed,
                                                   density, example_steel, example_steel);
  EXPECT_NEAR(stress / psi / example.stress, 1., 1.2e-3);
}

INSTANTIATE_TEST_SUITE_P(ThreeWheels, JohnsonExampleOne, testing::ValuesIn(examples),
                         [](const testing::TestParamInfo<Example>& example) {
                           return example.param.name;
                         });

TEST(Johnson, ExampleOneLoadInertiaAndOptimumAreThePrintedOnes) {
  EXPECT_NEAR(example_load().load_inertia / inertia_unit, 0.0046, 5e-5);
  const double optimum = optimum_wheel_inertia(example_load(), example_acceleration());
  EXPECT_NEAR(optimum / inertia_unit, 0.00704, 1.5e-5);  // 0.0046 for 0.004607 on the way
  const double diameter =
      optimum_wheel_diameter(example_load(), example_acceleration(), 0.00506, density);
  EXPECT_NEAR(diameter / inch, 4.53, 5e-3);
  EXPECT_NEAR(johnson_wheel_inertia(0.00506, density, diameter) / optimum, 1., 1e-14);
}

TEST(Johnson, SolidCylinderInertiaIsHalfMassTimesRadiusSquared) {
  const double mass = 7850. * pi * 0.05 * 0.05 * 0.02;
  EXPECT_NEAR(solid_cylinder_inertia(0.1, 0.02, 7850.) / (mass * 0.05 * 0.05 / 2.), 1., 1e-14);
}

TEST(Johnson, PinForceIsNegativeWhereTheOppositeWallCarries) {
  // ((1 + 2) (-4) + 3)/0.5
  EXPECT_NEAR(pin_force(1., {2., 3.}, -4., 0.5), -18., 1e-14);
}

TEST(Johnson, RefusesNegativeLoads) {
  expect_refused([] { pin_force(1., {-2., 0.}, 1., 0.1); }, {"load inertia is -2 kg m^2"});
  expect_refused([] { pin_force(1., {0., -2.}, 1., 0.1); }, {"friction moment is -2 N m"});
  expect_refused([] { pin_force(-1., {0., 0.}, 1., 0.1); }, {"wheel inertia is -1 kg m^2"});
  expect_refused([] { pin_force(1., {0., 0.}, HUGE_VAL, 0.1); }, {"wheel acceleration is inf"});
  expect_refused([] { pin_force(1., {0., 0.}, 1., 0.); }, {"arm of the pin force is 0 mm"});
}

TEST(Johnson, RefusesStressWithoutPositiveForce) {
  expect_refused(
      [] {
        johnson_stress(-5., 0.01, 0.01, {1e11, 0.3}, {1e11, 0.3});
      },
      {"pin force is -5 N", "positive"});
}

TEST(Johnson, RefusesEquationEightBeyondTenStations) {
  expect_refused(
      [] {
        johnson_stress_of_diameter(0.1, johnson_row(12), {1e-3, 0.}, 1e3, 7850., {1e11, 0.3},
                                   {1e11, 0.3});
      },
      {"number of stations is 12", "3 to 10", "take"});
}

TEST(Johnson, RefusesOptimumWithoutAcceleration) {
  expect_refused([] { optimum_wheel_inertia({1e-3, 0.}, 0.); }, {"peak acceleration is 0 rad/s^2"});
}

TEST(Johnson, RefusesInertiaConstantThatIsNotPositive) {
  expect_refused([] { johnson_wheel_inertia(-1., 7850., 0.1); },
                 {"k5 is -1: it must be", "greater than 0"});
}

RC_GTEST_PROP(JohnsonProperty, OptimumIsAMinimumOfEquationEight, ()) {
  const JohnsonRow row = johnson_row(test::uniform(3, 11));
  const WheelLoad load{between(1e-5, 1e-1), between(0., 10.)};
  const double speed = between(1., 100.);
  const double acceleration = row.peak_acceleration_ratio * speed * speed;
  const double rho = between(1000., 20000.);
  const double optimum = optimum_wheel_diameter(load, acceleration, *row.k5, rho);
  const auto stress = [&](double diameter) {
    return johnson_stress_of_diameter(diameter, row, load, acceleration, rho, {2.1e11, 0.3},
                                      {2.1e11, 0.3});
  };
  // the relative rise is of second order, 1e-6 at the minimum step: far above rounding
  const double step = between(1e-3, 0.9);
  RC_ASSERT(stress(optimum * (1. + step)) > stress(optimum));
  RC_ASSERT(stress(optimum * (1. - step)) > stress(optimum));
}

}  // namespace
}  // namespace geneva::loads
