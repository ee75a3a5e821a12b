#include "mesh/grading.h"

#include <gtest/gtest.h>

namespace geneva::mesh {
namespace {

constexpr Grading grading{3.};

/// Thickness of a thin layer over that of the even one around the same place.
double thickness(const double even) {
  constexpr double step = 1e-5;
  return (graded(grading, even + step) - graded(grading, even - step)) / (2. * step);
}

TEST(Grading, MakesLayersAtTheEndsHalfAsThickAsInTheMiddle) {
  EXPECT_NEAR(thickness(3. - 2e-5) / thickness(0.), 0.5, 2e-5);
  EXPECT_NEAR(thickness(-3. + 2e-5) / thickness(0.), 0.5, 2e-5);
  for (int i = 0; i < 29; ++i)
    EXPECT_GT(thickness(0.1 * i), thickness(0.1 * (i + 1))) << "at " << 0.1 * i;
}

TEST(Grading, LeavesTheMiddleTheEndsAndWhatLiesBeyond) {
  for (const double place : {-4., -3., 0., 3., 7.}) {
    EXPECT_EQ(graded(grading, place), place);
    EXPECT_EQ(even(grading, place), place);
  }
}

TEST(Grading, IsTheSameTowardsBothEnds) {
  for (const double place : {0.1, 1., 2.9})
    EXPECT_EQ(graded(grading, -place), -graded(grading, place));
}

TEST(Grading, IsUndoneByItsInverse) {
  for (const double place : {-2.999, -1., 1e-6, 0.5, 2.999})
    EXPECT_NEAR(even(grading, graded(grading, place)), place, 1e-14);
}

}  // namespace
}  // namespace geneva::mesh
