#include "fem/contact/rounded_edge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/contact/surface_in_space.h"
#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;

/// From the left to the right: a flat of length 1 at y = 0, then an arc of radius 0.5 whose centre
/// is above it (the body's underside bulges) or below it (a hollow).
/// @param slant of the flat at its end [rad]: 0 for a smooth passage
Boundary<2> flat_and_arc(const bool bulges, const double slant = 0.) {
  constexpr unsigned int n = 4;
  const double side = bulges ? 1. : -1.;
  Boundary<2> boundary;
  boundary.circles = {{{0., side * 0.5}, 0.5}};
  for (unsigned int i = 0; i <= 2 * n; ++i) {
    const double along = static_cast<double>(i) / n - 1.;
    const double turn = pi / 4. * along;
    boundary.nodes.push_back(
        {i <= n ? Point<2>(along * std::cos(slant), along * std::sin(slant))
                : Point<2>(0.5 * std::sin(turn), side * 0.5 * (1. - std::cos(turn))),
         {2 * i, 2 * i + 1},
         0});
    if (i > 0) boundary.faces.push_back({{i - 1, i}, 1, i <= n ? -1 : 0});
  }
  return boundary;
}

Surface<2> plane_surface(const Boundary<2>& boundary) {
  return make_surface(boundary, 1, boundary.nodes.front().position);
}

/// A surface in the plane, one layer thick along z.
Surface<3> extruded_surface(const Boundary<2>& plane) {
  Boundary<3> boundary;
  for (const mesh::Circle& circle : plane.circles) boundary.circles.push_back(circle);
  const auto n = static_cast<unsigned int>(plane.nodes.size());
  for (const double z : {0., 1.})
    for (const auto& node : plane.nodes)
      boundary.nodes.push_back({Point<3>(node.position[0], node.position[1], z), {}, 0});
  for (const auto& face : plane.faces)
    boundary.faces.push_back(
        {{face.nodes[0], face.nodes[1], face.nodes[1] + n, face.nodes[0] + n}, 1, face.circle});
  return make_surface(boundary, 1);
}

TEST(RoundedEdge, IsWhereAFlatPassesOverIntoARoundThatBulges) {
  EXPECT_TRUE(has_rounded_edge(plane_surface(flat_and_arc(true))));
  EXPECT_TRUE(has_rounded_edge(extruded_surface(flat_and_arc(true))));
}

TEST(RoundedEdge, IsNoneWhereTheRoundIsHollowOrTheTwoMeetInACorner) {
  for (const Boundary<2>& boundary : {flat_and_arc(false), flat_and_arc(true, 0.02)}) {
    EXPECT_FALSE(has_rounded_edge(plane_surface(boundary)));
    EXPECT_FALSE(has_rounded_edge(extruded_surface(boundary)));
  }
}

TEST(RoundedEdge, IsNoneOnAFlatOrOnOneCircle) {
  EXPECT_FALSE(has_rounded_edge(underside({-1., -0.3, 0.2, 1.}, 0.)));
  EXPECT_FALSE(has_rounded_edge(full_circle({{0.3, -0.2}, 0.7}, 5)));
}

}  // namespace
}  // namespace geneva::fem::test
