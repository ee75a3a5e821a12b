#include "mesh/grading.h"

#include <gtest/gtest.h>

namespace geneva::mesh {
namespace {

constexpr Grading some_gradings[] = {{3.}, {3., 0.01}};

/// Thickness of a thin layer over that of the even one around the same place.
double thickness(const Grading& grading, const double even) {
  constexpr double step = 1e-5;
  return (graded(grading, even + step) - graded(grading, even - step)) / (2. * step);
}

TEST(Grading, MakesLayersAtTheEndsAsThinAsAsked) {
  for (const Grading& grading : some_gradings) {
    const double middle = thickness(grading, 0.);
    EXPECT_NEAR(thickness(grading, 3.) / middle, grading.thickness_at_ends, 2e-5);
    EXPECT_NEAR(thickness(grading, -3.) / middle, grading.thickness_at_ends, 2e-5);
    for (int i = 0; i < 29; ++i)
      EXPECT_GT(thickness(grading, 0.1 * i), thickness(grading, 0.1 * (i + 1))) << 0.1 * i;
  }
  EXPECT_EQ(Grading{3.}.thickness_at_ends, 0.5);
}

TEST(Grading, MakesLayersThickerBeyondTheEndsAsItMadeThemThinner) {
  for (const Grading& grading : some_gradings)
    for (const double distance : {0.1, 1., 2.5}) {
      EXPECT_NEAR(graded(grading, 3. + distance) - 3., 3. - graded(grading, 3. - distance), 1e-14);
      EXPECT_NEAR(thickness(grading, 3. + distance), thickness(grading, 3. - distance), 1e-9);
    }
}

TEST(Grading, LeavesTheMiddleTheEndsAndWhatLiesFarBeyond) {
  for (const Grading& grading : some_gradings)
    for (const double place : {-7., -6., -3., 0., 3., 6., 11.}) {
      EXPECT_EQ(graded(grading, place), place);
      EXPECT_NEAR(even(grading, place), place, 1e-13);
    }
}

TEST(Grading, IsTheSameTowardsBothEnds) {
  for (const double place : {0.1, 1., 2.9, 4.})
    EXPECT_EQ(graded({3.}, -place), -graded({3.}, place));
}

TEST(Grading, IsUndoneByItsInverse) {
  for (const Grading& grading : some_gradings)
    for (const double place : {-5.9, -2.999, -1., 1e-6, 0.5, 2.999, 3.001, 7.})
      EXPECT_NEAR(even(grading, graded(grading, place)), place, 2e-13);
}

}  // namespace
}  // namespace geneva::mesh
