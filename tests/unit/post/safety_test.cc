#include "post/analysis/safety.h"

#include <gtest/gtest.h>

namespace geneva::post {
namespace {

SafetyRow pressure_row() {
  return {"peak contact pressure",
          base::Dimension::stress,
          400e6,
          500e6,
          -0.2,
          CycleValue{625e6, -0.1},
          ""};
}

TEST(SafetyRow, IsJudgedWhereTheCycleIsWorse) {
  const SafetyRow row = pressure_row();
  EXPECT_EQ(row.factor(), 0.8);
  EXPECT_EQ(row.driver_angle(), -0.1);
  EXPECT_EQ(row.computed_factor(), 1.25);
}

TEST(SafetyRow, IsJudgedAsAnalysedWhereThatIsWorse) {
  SafetyRow row = pressure_row();
  row.computed = 1000e6;
  EXPECT_EQ(row.factor(), 0.5);
  EXPECT_EQ(row.driver_angle(), -0.2);
}

TEST(SafetyRow, KnowsNoPlaceWithoutAMechanism) {
  SafetyRow row = pressure_row();
  row.cycle.reset();
  row.analysed_angle.reset();
  EXPECT_EQ(row.factor(), 1.25);
  EXPECT_EQ(row.driver_angle(), std::nullopt);
  EXPECT_EQ(safety_lines({row}, base::UnitSystem::si),
            "peak contact pressure: 4e+08 of 5e+08 Pa allowed, safety factor 1.25\n");
}

TEST(SafetyRow, HasNoFactorWhereThePressureIsNotBounded) {
  SafetyRow row = pressure_row();
  row.computed.reset();
  EXPECT_EQ(row.factor(), std::nullopt) << "Hertz knows no edge";
  EXPECT_NE(safety_lines({row}, base::UnitSystem::si).find("not bounded"), std::string::npos);
}

TEST(SafetyLines, SayWhereTheFactorIsLeast) {
  EXPECT_EQ(safety_lines({pressure_row()}, base::UnitSystem::mm_newton),
            "peak contact pressure: 625 of 500 MPa allowed, safety factor 0.8, EXCEEDED at -5.7296 "
            "deg (as "
            "analysed at -11.459 deg: 400, 1.25)\n");
}

}  // namespace
}  // namespace geneva::post
