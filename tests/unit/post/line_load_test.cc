#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "post/analysis/contact_sections.h"
#include "post/analysis/load_evenness.h"

namespace geneva::post {
namespace {

/// Sections with a line load by place.
std::vector<ContactSection> sections_of(const std::vector<std::pair<double, double>>& loads) {
  std::vector<ContactSection> sections;
  for (const auto& [z, load] : loads) sections.push_back({z, load, 0., 0., 0., 0.});
  return sections;
}

TEST(MaximumMeanLoad, OfAnEvenLoadIsItself) {
  const auto sections = sections_of({{-1., 3.}, {0.2, 3.}, {1., 3.}});
  EXPECT_NEAR(maximum_mean_load(sections, 0.1).value, 3., 1e-14);
  EXPECT_NEAR(maximum_mean_load(sections, 2.).value, 3., 1e-14);
}

TEST(MaximumMeanLoad, OfALoadThatGrowsTowardsAnEndIsTheMeanOverThatEnd) {
  const loads::MaximumMean maximum =
      maximum_mean_load(sections_of({{0., 0.}, {1., 1.}, {2., 5.}}), 0.5);
  EXPECT_NEAR(maximum.value, 4., 1e-14);
  EXPECT_NEAR(maximum.place, 1.75, 1e-14);
}

TEST(MaximumMeanLoad, CountsNothingBeyondTheLoadedSections) {
  EXPECT_NEAR(maximum_mean_load(sections_of({{0., 2.}, {1., 2.}}), 4.).value, 0.5, 1e-14);
}

TEST(MaximumMeanLoad, OfAPeakIsTheMeanAroundIt) {
  const auto sections = sections_of({{-1., 0.}, {0., 10.}, {1., 0.}});
  const loads::MaximumMean maximum = maximum_mean_load(sections, 0.2);
  EXPECT_NEAR(maximum.value, 9.5, 1e-14);
  EXPECT_NEAR(maximum.place, 0., 1e-14);
}

/// A contact whose surfaces reach from z = 0 to 4.
fem::ContactResult<3> contact_of_length_four() {
  fem::ContactResult<3> contact;
  for (const double z : {0., 4.}) {
    fem::ContactNode<3> node{};
    node.position = {0., 0., z};
    contact.nodes.push_back(node);
  }
  return contact;
}

TEST(MiddleSection, LiesBetweenItsNeighbours) {
  const std::vector<ContactSection> sections{{0., 1., 10., 3., 5., 0.2},
                                             {1., 2., 20., 4., 6., 0.4},
                                             {3., 6., 40., 8., 8., 0.8},
                                             {4., 7., 70., 9., 9., 1.}};
  const ContactSection middle = middle_section(contact_of_length_four(), {}, sections);
  EXPECT_NEAR(middle.z, 2., 1e-14);
  EXPECT_NEAR(middle.line_load, 4., 1e-14);
  EXPECT_NEAR(middle.peak_pressure, 30., 1e-13);
  EXPECT_NEAR(middle.half_width, 6., 1e-14);
  EXPECT_NEAR(middle.max_shear, 7., 1e-14);
  EXPECT_NEAR(middle.max_shear_depth, 0.6, 1e-14);
}

TEST(MiddleSection, IsALayerThatStandsThere) {
  const auto sections = sections_of({{1., 2.}, {2., 5.}, {3., 3.}});
  EXPECT_EQ(middle_section(contact_of_length_four(), {}, sections).line_load, 5.);
}

TEST(MiddleSection, IsTheNextLoadedOneWhereTheMiddleCarriesNothing) {
  EXPECT_EQ(middle_section(contact_of_length_four(), {}, sections_of({{3., 2.}, {4., 5.}})).z, 3.);
  EXPECT_EQ(middle_section(contact_of_length_four(), {}, sections_of({{0., 2.}, {1., 5.}})).z, 1.);
  EXPECT_THROW(middle_section(contact_of_length_four(), {}, {}), std::invalid_argument);
}

TEST(MiddleSection, HasTheNodesInContactOfTheLayerNearestToTheMiddle) {
  fem::ContactResult<3> contact = contact_of_length_four();
  const auto add_layer = [&](const double z, const unsigned int closed) {
    for (unsigned int i = 0; i < 5; ++i) {
      fem::ContactNode<3> node{};
      node.position = {0.1 * i, 0., z};
      node.status = i < closed ? fem::NodeStatus::stick : fem::NodeStatus::open;
      contact.nodes.push_back(node);
    }
  };
  EXPECT_EQ(nodes_across_middle(contact, {}), 0U) << "nothing is loaded";
  add_layer(0.5, 5);
  add_layer(1.8, 2);
  add_layer(3.5, 4);
  EXPECT_EQ(nodes_across_middle(contact, {}), 2U);
}

}  // namespace
}  // namespace geneva::post
