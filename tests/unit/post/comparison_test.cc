// What the closing table, the safety factors and the figures of friction say of a cylinder that is
// pressed on a block, where Hertz, McEwen and Smith and Liu know the answers.

#include "post/analysis/comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loads/contact_limits.h"
#include "post/analysis/friction.h"
#include "post/analysis/material_limits.h"
#include "post/analysis/strength_rows.h"
#include "tests/unit/post/cylinder_on_a_block.h"

namespace geneva::post {
namespace {

void expect_within_its_error(const ComparisonRow& row, const double most_error = 0.1) {
  ASSERT_TRUE(row.computed && row.closed_form && row.error) << row.quantity;
  EXPECT_LT(std::abs(*row.computed / *row.closed_form - 1.), *row.error) << row.quantity;
  EXPECT_LT(*row.error, most_error) << row.quantity;
}

TEST_F(CylinderOnABlock, ComparisonHasHertzsFiguresWithinTheirErrors) {
  for (const char* const quantity :
       {"peak contact pressure", "half-width", "maximum shear", "its depth"})
    expect_within_its_error(pressed().row(quantity));
  EXPECT_NEAR(*pressed().row("contact force").computed, 250., 250e-9);
  EXPECT_FALSE(pressed().row("contact force").closed_form) << "the case's load, no mechanism's";
}

TEST_F(CylinderOnABlock, ComparisonOfBodiesThatSlideHasSmithAndLiusTension) {
  const ComparisonRow tension = sliding().row("surface tension");
  expect_within_its_error(tension, 0.2);
  EXPECT_NEAR(*tension.closed_form / (2. * mu * sliding().peak()), 1., 0.02);
  EXPECT_NEAR(*sliding().row("friction force").computed, mu * 250., 1e-6 * 250.);
}

TEST_F(CylinderOnABlock, ComparisonIsTheFigureOfWhichTheAccuracyIs) {
  EXPECT_EQ(refined_figure(pressed().solution), "peak contact pressure");
  fem::Solution<2> without = pressed().solution;
  without.problem.pairs.clear();
  EXPECT_EQ(refined_figure(without), "maximum stress");
}

TEST_F(CylinderOnABlock, ComparisonTableHasALineForEachFigureAndTheBalance) {
  const std::string table = comparison_table(pressed().solution, pressed().results,
                                             pressed().errors, base::UnitSystem::mm_newton);
  for (const char* const part :
       {"this program", "peak contact pressure [MPa]", "half-width [mm]",
        "estimated error of the peak contact pressure: ", "force balance: residual "})
    EXPECT_NE(table.find(part), std::string::npos) << part << " in\n" << table;
}

TEST_F(CylinderOnABlock, ComparisonTableSaysWhereTheMeshIsTooCoarseForAnError) {
  fem::Solution<2> solution = pressed().solution;
  solution.error_estimate = 1.;
  const std::string table =
      comparison_table(solution, pressed().results, pressed().errors, base::UnitSystem::si);
  EXPECT_NE(table.find("unknown, the mesh is too coarse"), std::string::npos) << table;
}

TEST_F(CylinderOnABlock, FieldDifferenceOfAFineMeshIsSmallInBothBodies) {
  const auto& difference = pressed().results.contacts.front().difference;
  ASSERT_TRUE(difference);
  EXPECT_GT(difference->source_body, 0.);
  EXPECT_LT(difference->source_body, 0.03);
  EXPECT_LT(difference->target_body, 0.03);
}

TEST_F(CylinderOnABlock, FrictionSlidesTheOtherWayInTheOtherDirection) {
  const fem::ContactResult<2>& contact = sliding().solution.contacts.front();
  const dealii::Tensor<1, 2> along({1., 0.});
  const dealii::Tensor<1, 2> across({0., 1.});
  EXPECT_EQ(sliding_friction(sliding().solution, contact, along), mu);
  EXPECT_EQ(sliding_friction(sliding().solution, contact, -along), -mu);
  EXPECT_EQ(sliding_friction(sliding().solution, contact, across), 0.);
  EXPECT_EQ(sliding_friction(pressed().solution, pressed().solution.contacts.front(), along), 0.);
}

TEST_F(CylinderOnABlock, FrictionOfWhatSlidesHasNoSticking) {
  const auto figures =
      friction_figures(sliding().solution, sliding().solution.contacts.front(), std::nullopt);
  ASSERT_TRUE(figures);
  EXPECT_EQ(figures->coefficient, mu);
  EXPECT_EQ(figures->sticking, 0U);
  EXPECT_GT(figures->slipping, 10U);
  EXPECT_FALSE(figures->sticking_share) << "sliding is imposed";
  EXPECT_FALSE(figures->speed) << "no mechanism";
  EXPECT_FALSE(
      friction_figures(pressed().solution, pressed().solution.contacts.front(), std::nullopt));
}

TEST_F(CylinderOnABlock, SafetyOfAContactPressureIsThatOfThePeak) {
  const Cylinder& run = pressed();
  RunReport report = run.errors;
  EXPECT_TRUE(safety(run.solution, run.results, report).empty()) << "nothing is limited";
  report.allowed.contact_pressure = 2. * run.peak();
  const auto row = run.limit("peak contact pressure", report);
  ASSERT_TRUE(row);
  EXPECT_NEAR(*row->factor(), 2., 1e-12);
  EXPECT_FALSE(row->driver_angle());
}

TEST_F(CylinderOnABlock, SafetyOfAYieldStrengthIsThatOfFirstYieldShakedownAndTheStresses) {
  const Cylinder& run = pressed();
  RunReport report = run.errors;
  const double yield = 1e9;
  report.allowed.yield_strengths = {{"block", yield}};
  const loads::ContactLimits limits = loads::line_contact_limits(0.3, 0.);
  EXPECT_NEAR(*run.limit("contact, first yield, block", report)->factor(),
              limits.first_yield * yield / run.peak(), 1e-9);
  EXPECT_NEAR(*run.limit("contact, shakedown, block", report)->factor(),
              limits.shakedown * yield / run.peak(), 1e-9);
  EXPECT_FALSE(run.limit("contact, first yield, cylinder", report)) << "its strength is not known";
  const double von_mises = run.results.max_von_mises[1].value;
  EXPECT_NEAR(*run.limit("maximum von Mises stress of the block", report)->factor(),
              yield / von_mises, 1e-9);
  // The yield of the material is where the computed stress is greatest: 0.558 p0 (nu = 0.3).
  EXPECT_NEAR(von_mises / run.peak(), 1. / limits.first_yield, 0.03);
}

TEST_F(CylinderOnABlock, SafetyOfAHardenedLayerIsJudgedByItsOwnStrength) {
  const Cylinder& run = pressed();
  RunReport report = run.errors;
  report.allowed.yield_strengths = {{"block", 1e9}};
  const double below_the_maximum = 3. * run.results.contacts.front().max_shear_depth;
  report.allowed.layers = {{"block", {below_the_maximum, 3e9}}};
  EXPECT_TRUE(is_in_layer(run.solution, run.results, report.allowed, 1));
  EXPECT_EQ(run.limit("maximum von Mises stress of the block", report)->allowed, 3e9);
  report.allowed.layers = {{"block", {1e-6 * below_the_maximum, 3e9}}};
  EXPECT_FALSE(is_in_layer(run.solution, run.results, report.allowed, 1));
  EXPECT_EQ(run.limit("maximum von Mises stress of the block", report)->allowed, 1e9);
}

/// A mechanism whose pin force is greatest elsewhere by a fifth.
MechanismReport mechanism_of(const Cylinder& run) {
  MechanismReport mechanism{};
  mechanism.load.force = 250.;
  mechanism.load.driver_angle = -0.2;
  mechanism.load.slip_speed = -0.5;
  mechanism.parts = 1.;
  mechanism.cycle_force = {300., -0.1, 0.};
  mechanism.cycle_pressure = {std::sqrt(1.2) * run.peak(), -0.1, 0.};
  mechanism.cycle_wear = {2. * run.peak(), -0.3, 0.};
  mechanism.beam = loads::BeamBending{};
  mechanism.beam->root_stress = 50e6;
  mechanism.beam->root_shear = 40e6;
  return mechanism;
}

TEST_F(CylinderOnABlock, SafetyOfAMechanismIsThatOfTheCyclesWorstInstant) {
  const Cylinder& run = pressed();
  RunReport report = run.errors;
  report.mechanism = mechanism_of(run);
  report.allowed.contact_pressure = run.peak();
  report.allowed.pressure_times_slip = run.peak();
  report.allowed.yield_strengths = {{"pin", 140e6}};
  const auto pressure = run.limit("peak contact pressure", report);
  EXPECT_NEAR(*pressure->factor(), 1. / std::sqrt(1.2), 1e-12);
  EXPECT_EQ(pressure->driver_angle(), -0.1);
  const auto wear = run.limit("peak contact pressure times slip speed", report);
  EXPECT_NEAR(*wear->computed_factor(), 2., 1e-12) << "at 0.5 m/s";
  EXPECT_NEAR(*wear->factor(), 0.5, 1e-12);
  const auto root = run.limit("von Mises stress at the pin's root (beam theory)", report);
  EXPECT_NEAR(*root->computed_factor(), 140. / (std::sqrt(3.) * 40.), 1e-12)
      << "shear across the middle is worse than bending";
  EXPECT_NEAR(*root->factor(), *root->computed_factor() / 1.2, 1e-12) << "it goes with the force";
}

TEST_F(CylinderOnABlock, ComparisonOfAMechanismHasThePinsRootAndTheTorqueOfTheBore) {
  const Cylinder& run = pressed();
  RunReport report = run.errors;
  report.mechanism = mechanism_of(run);
  report.mechanism->held_surface = "bore";
  report.mechanism->bore_torque = 9.9;
  report.mechanism->expected_bore_torque = 10.;
  expect_within_its_error(run.row("contact force", report));
  EXPECT_EQ(run.row("bending stress, pin root", report).closed_form, 50e6);
  EXPECT_EQ(run.row("shear stress, pin root", report).closed_form, 40e6);
  const ComparisonRow torque = run.row("bore torque", report);
  EXPECT_EQ(torque.computed, 9.9);
  EXPECT_EQ(torque.closed_form, 10.);
}

TEST_F(CylinderOnABlock, StrengthRowsNameTwoStressesOfEachBodyAwayFromTheContact) {
  const auto stresses = named_stresses(pressed().solution);
  ASSERT_FALSE(stresses.empty());
  for (const NamedStress<2>& stress : stresses) {
    EXPECT_GT(stress.maximum.value, 0.) << stress.name << " of " << stress.body;
    EXPECT_LT(stress.maximum.value, pressed().peak()) << stress.name << " of " << stress.body;
    EXPECT_FALSE(stress.where.empty());
  }
  const std::string line = strength_line(pressed().solution);
  EXPECT_EQ(line.find("outside the contact's own field: von Mises stress of 'cylinder': "), 0U)
      << line;
  EXPECT_EQ(strength_rows(pressed().solution).size(), stresses.size());
}

}  // namespace
}  // namespace geneva::post
