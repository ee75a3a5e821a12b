#include <gtest/gtest.h>

#include <cmath>
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

/// Of Hertz's elliptical contact over z = 1.5 - 4 ... 1.5 + 4.
ContactSection section_of_ellipse(const double z) {
  const double share = 1. - std::pow((z - 1.5) / 4., 2);
  const double root = std::sqrt(share);
  return {z, 6. * share, 40. * root, 8. * root, 12. * root, 0.8 * root};
}

TEST(MiddleSection, OfAnEllipticalContactLiesBetweenItsNeighboursExactly) {
  std::vector<ContactSection> sections;
  for (const double z : {-0.5, 1.1, 1.9, 2.6, 4.}) sections.push_back(section_of_ellipse(z));
  const ContactSection middle = middle_section(contact_of_length_four(), {}, sections);
  const ContactSection exact = section_of_ellipse(2.);
  EXPECT_NEAR(middle.z, 2., 1e-14);
  EXPECT_NEAR(middle.line_load, exact.line_load, 1e-13);
  EXPECT_NEAR(middle.peak_pressure, exact.peak_pressure, 1e-13);
  EXPECT_NEAR(middle.half_width, exact.half_width, 1e-13);
  EXPECT_NEAR(middle.max_shear, exact.max_shear, 1e-13);
  EXPECT_NEAR(middle.max_shear_depth, exact.max_shear_depth, 1e-13);
}

TEST(MiddleSection, WithOneNeighbourOnASideLiesOnTheLineBetweenTheNearestTwo) {
  const ContactSection middle =
      middle_section(contact_of_length_four(), {}, sections_of({{1., 2.}, {3., 6.}, {4., 7.}}));
  EXPECT_NEAR(middle.line_load, 4., 1e-14);
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
