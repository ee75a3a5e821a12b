#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/adaptivity/error_estimate.h"

namespace geneva::fem::test {
namespace {

LevelRecord level(const double middle, const double end, const unsigned int halvings = 1) {
  LevelRecord record{};
  record.mid_length_pressure = middle;
  record.end_pressure = end;
  record.peak_pressure = std::max(middle, end);
  record.halvings = halvings;
  record.refined = Refined::zone;
  return record;
}

TEST(EdgePressure, GrowsByThePowerOfASquareEdge) {
  const double factor = std::pow(2., 0.226);
  const EdgePressure edge = edge_pressure({level(1., 1.5), level(1.01, 1.5 * factor)});
  EXPECT_FALSE(edge.is_bounded);
  EXPECT_NEAR(edge.growth_exponent, 0.226, 1e-14);
  EXPECT_DOUBLE_EQ(edge.pressure, 1.5 * factor);
}

TEST(EdgePressure, ExponentIsPerHalvingOfTheCells) {
  const EdgePressure edge = edge_pressure({level(1., 1.5), level(1., 1.5 * 4., 4)});
  EXPECT_NEAR(edge.growth_exponent, 0.5, 1e-14);
}

TEST(EdgePressure, IsThatOfTheLastMeshThatRefinedTheContact) {
  LevelRecord around = level(1., 3.1, 0);
  around.refined = Refined::surroundings;
  const EdgePressure edge = edge_pressure({level(1., 1.5), level(1., 3.), around});
  EXPECT_NEAR(edge.growth_exponent, 1., 1e-14);
  EXPECT_DOUBLE_EQ(edge.pressure, 3.1);
}

TEST(EdgePressure, IsBoundedWhereItSettlesOrIsNotTheMaximum) {
  EXPECT_TRUE(edge_pressure({level(1., 1.5)}).is_bounded) << "one mesh says nothing";
  EXPECT_TRUE(edge_pressure({level(1., 1.5), level(1., 1.51)}).is_bounded) << "it settles";
  EXPECT_TRUE(edge_pressure({level(1., 0.5), level(1., 0.7)}).is_bounded) << "the middle leads";
  EXPECT_TRUE(edge_pressure({level(1., 0.), level(1., 0.)}).is_bounded) << "open ends";
}

}  // namespace
}  // namespace geneva::fem::test
