#include <gtest/gtest.h>

#include <vector>

#include "post/crown_output.h"

namespace geneva::post {
namespace {

/// Sections with a line load by place.
std::vector<ContactSection> sections_of(const std::vector<std::pair<double, double>>& loads) {
  std::vector<ContactSection> sections;
  for (const auto& [z, load] : loads) sections.push_back({z, load, 0., 0., 0., 0.});
  return sections;
}

TEST(GreatestMeanLoad, OfAnEvenLoadIsItself) {
  const auto sections = sections_of({{-1., 3.}, {0.2, 3.}, {1., 3.}});
  EXPECT_NEAR(greatest_mean_load(sections, 0.1).value, 3., 1e-14);
  EXPECT_NEAR(greatest_mean_load(sections, 2.).value, 3., 1e-14);
}

TEST(GreatestMeanLoad, OfALoadThatGrowsTowardsAnEndIsTheMeanOverThatEnd) {
  const GreatestMean greatest =
      greatest_mean_load(sections_of({{0., 0.}, {1., 1.}, {2., 5.}}), 0.5);
  EXPECT_NEAR(greatest.value, 4., 1e-14);
  EXPECT_NEAR(greatest.place, 1.75, 1e-14);
}

TEST(GreatestMeanLoad, CountsNothingBeyondTheLoadedSections) {
  EXPECT_NEAR(greatest_mean_load(sections_of({{0., 2.}, {1., 2.}}), 4.).value, 0.5, 1e-14);
}

TEST(GreatestMeanLoad, OfAPeakIsTheMeanAroundIt) {
  const auto sections = sections_of({{-1., 0.}, {0., 10.}, {1., 0.}});
  const GreatestMean greatest = greatest_mean_load(sections, 0.2);
  EXPECT_NEAR(greatest.value, 9.5, 1e-14);
  EXPECT_NEAR(greatest.place, 0., 1e-14);
}

}  // namespace
}  // namespace geneva::post
