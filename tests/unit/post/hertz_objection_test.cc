#include "post/analysis/hertz_objection.h"

#include <gtest/gtest.h>

namespace geneva::post {
namespace {

/// A pin of radius 1 in a hole of radius 1.05.
fem::Solution<2> pin_and_hole() {
  fem::Solution<2> solution;
  solution.mesh.circles = {{{0., 0.}, 1.}, {{0., 0.05}, 1.05}};
  return solution;
}

fem::ContactResult<2> between(const int target_circle, const bool target_is_convex) {
  fem::ContactResult<2> contact{};
  contact.source = "pin";
  contact.target = "hole";
  contact.source_circle = 0;
  contact.source_is_convex = true;
  contact.target_circle = target_circle;
  contact.target_is_convex = target_is_convex;
  contact.has_one_curvature = true;
  return contact;
}

TEST(HertzObjection, IsThatAWideContactInAHoleIsNoParabola) {
  const fem::Solution<2> solution = pin_and_hole();
  EXPECT_EQ(hertz_objection(solution, between(1, false), 0.29), "");
  const std::string objection = hertz_objection(solution, between(1, false), 0.4);
  for (const char* const part : {"'pin -> hole'", "encloses", "0.4 of the radius"})
    EXPECT_NE(objection.find(part), std::string::npos) << objection;
}

TEST(HertzObjection, IsNoneOnAFlatOrABulgingTarget) {
  const fem::Solution<2> solution = pin_and_hole();
  EXPECT_EQ(hertz_objection(solution, between(-1, false), 0.4), "");
  EXPECT_EQ(hertz_objection(solution, between(1, true), 0.4), "");
}

TEST(HertzObjection, IsThatTheCurvatureChanges) {
  const fem::Solution<2> solution = pin_and_hole();
  fem::ContactResult<2> contact = between(-1, false);
  contact.has_one_curvature = false;
  EXPECT_NE(hertz_objection(solution, contact, 0.01).find("different curvature"),
            std::string::npos);
}

}  // namespace
}  // namespace geneva::post
