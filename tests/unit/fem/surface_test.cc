#include "fem/contact/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fem/contact/projection.h"
#include "tests/unit/fem/discretisation.h"
#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;
using dealii::Tensor;

/// A few roundings of numbers of size 1.
constexpr double round_off = 1e-14;

TEST(Surface, PutsTheEdgesOfAnOpenCurveInOrderFromTheEndNearestToTheOrigin) {
  const std::vector<Point<2>> points{{0., 0.}, {1., 0.}, {1., 2.}, {4., 6.}};
  Boundary<2> boundary = curve(points);
  std::reverse(boundary.faces.begin(), boundary.faces.end());
  std::swap(boundary.faces[0], boundary.faces[1]);
  const Surface<2> surface = make_surface(boundary, 1, Point<2>(0.1, 0.));
  ASSERT_EQ(surface.nodes.size(), 4U);
  const std::array<double, 4> arc_lengths{0., 1., 3., 8.};
  for (unsigned int i = 0; i < 4; ++i) {
    EXPECT_EQ(surface.nodes[i].position, points[i]);
    EXPECT_DOUBLE_EQ(surface.nodes[i].arc_length, arc_lengths[i]);
  }
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_EQ(surface.faces[i].nodes, (std::array<unsigned int, 2>{i, i + 1}));
  EXPECT_FALSE(surface.closed);
  EXPECT_DOUBLE_EQ(surface.length, 8.);
}

TEST(Surface, LeavesOtherSurfacesOut) {
  Boundary<2> boundary = curve({{0., 0.}, {1., 0.}, {2., 0.}, {3., 0.}});
  boundary.faces[2].surface = 7;
  EXPECT_EQ(make_surface(boundary, 1, Point<2>()).nodes.size(), 3U);
  EXPECT_EQ(make_surface(boundary, 7, Point<2>()).nodes.size(), 2U);
}

TEST(Surface, CountsTheArcLengthOfAClosedCurveFromTheNodeNearestToTheOrigin) {
  const mesh::Circle circle{{1., 2.}, 3.};
  Boundary<2> boundary;
  boundary.circles = {circle};
  for (unsigned int i = 0; i < 8; ++i) {
    boundary.nodes.push_back(
        {Point<2>(1. + 3. * std::cos(pi * i / 4.), 2. + 3. * std::sin(pi * i / 4.)),
         {2 * i, 2 * i + 1},
         0});
    boundary.faces.push_back({{i, (i + 1) % 8}, 1, 0});
  }
  const Surface<2> surface = make_surface(boundary, 1, Point<2>(1., 6.));
  EXPECT_TRUE(surface.closed);
  EXPECT_EQ(surface.nodes.front().position, boundary.nodes[2].position);
  for (unsigned int i = 0; i < 8; ++i)
    EXPECT_NEAR(surface.nodes[i].arc_length, 3. * pi * i / 4., 10. * round_off);
  EXPECT_EQ(surface.faces.back().nodes[1], 0U);
}

TEST(Surface, OfACircleIsTwoPiRLongOnAnyMesh) {
  for (const unsigned int n : {3U, 4U, 7U, 24U, 1000U}) {
    const Surface<2> surface = full_circle({{0.3, -0.2}, 0.7}, n);
    // n arcs, each with a few roundings of numbers of size 1 (asin is steep by 2 for n = 3).
    EXPECT_NEAR(surface.length, 2. * pi * 0.7, n * round_off) << n << " edges";
  }
}

TEST(Surface, NormalsOfACircleAreRadialAndPointOutOfTheBody) {
  const mesh::Circle circle{{0.3, -0.2}, 0.7};
  for (const bool is_hole : {false, true}) {
    const std::vector<double> angles{0.1, 0.4, 0.5, 1.2};
    const Surface<2> surface =
        arc(circle, is_hole ? std::vector<double>(angles.rbegin(), angles.rend()) : angles);
    for (const SurfaceNode<2>& node : surface.nodes) {
      const Tensor<1, 2> radial = (node.position - Point<2>(0.3, -0.2)) / 0.7;
      EXPECT_LT((node.normal - (is_hole ? -1. : 1.) * radial).norm(), round_off);
    }
    for (const SurfaceFace<2>& face : surface.faces)
      EXPECT_DOUBLE_EQ(curvature(surface, face), (is_hole ? -1. : 1.) / 0.7);
  }
}

TEST(Surface, NormalOfAStraightEdgeIsToTheRightOfItsDirection) {
  const Surface<2> surface = upper_side({0., 1., 3.});
  for (const SurfaceNode<2>& node : surface.nodes) EXPECT_EQ(node.normal, (Tensor<1, 2>({0., 1.})));
  for (const SurfaceFace<2>& face : surface.faces) {
    EXPECT_EQ(flat_normal(surface, face), (Tensor<1, 2>({0., 1.})));
    EXPECT_EQ(curvature(surface, face), 0.);
  }
}

/// The bottom of a slot of half-width 1 and its straight wall, n edges each, around the body above;
/// the wall may leave at an angle.
Surface<2> bottom_and_wall(const unsigned int n, const double angle = 0.) {
  Boundary<2> boundary;
  boundary.circles = {{{0., 0.}, 1.}};
  for (unsigned int i = 0; i <= 2 * n; ++i) {
    const double turn = pi / 2. * (1. - static_cast<double>(i) / n);
    const double along = static_cast<double>(i) / n - 1.;
    boundary.nodes.push_back({i <= n
                                  ? Point<2>(-std::sin(turn), std::cos(turn))
                                  : Point<2>(along * std::cos(angle), 1. + along * std::sin(angle)),
                              {2 * i, 2 * i + 1},
                              0});
    if (i > 0) boundary.faces.push_back({{i - 1, i}, 1, i <= n ? 0 : -1});
  }
  return make_surface(boundary, 1, boundary.nodes.front().position);
}

TEST(Surface, HasASmoothNormalWhereARoundBottomBecomesAStraightWall) {
  for (const unsigned int n : {1U, 2U, 7U}) {
    const Surface<2> surface = bottom_and_wall(n);
    ASSERT_EQ(surface.nodes.size(), 2 * n + 1);
    EXPECT_LT((surface.nodes[n].normal - Tensor<1, 2>({0., -1.})).norm(), round_off);
    std::vector<bool> ends(2 * n + 1, false);
    ends.front() = ends.back() = true;
    EXPECT_EQ(corners(surface), ends);
  }
}

TEST(Surface, HasACornerWhereItsNormalJumps) {
  const std::vector<bool> at_half_a_degree = corners(bottom_and_wall(3, pi / 360.));
  EXPECT_EQ(at_half_a_degree, (std::vector<bool>{true, false, false, true, false, false, true}));
  const std::vector<bool> of_circle = corners(full_circle({{0.3, -0.2}, 0.7}, 5));
  EXPECT_EQ(of_circle, std::vector<bool>(5, false)) << "a closed circle has neither end nor corner";
}

TEST(Surface, TruePointIsTheOneOfTheCircleNearestToTheChord) {
  const Surface<2> surface = arc({{0., 0.}, 2.}, {0., pi / 3.});
  const SurfaceFace<2>& face = surface.faces.front();
  const Point<2> middle = true_point(surface, face, chord_point(surface, face, 0.5));
  EXPECT_LT(middle.distance(Point<2>(2. * std::cos(pi / 6.), 2. * std::sin(pi / 6.))),
            round_off * 2.);
}

TEST(Projection, OnAStraightEdgeIsTheFootOfThePerpendicular) {
  const Surface<2> surface = upper_side({-1., 3.}, 0.5);
  const SurfaceFace<2>& face = surface.faces.front();
  for (const double eta : {-0.5, 0., 0.25, 0.7, 1., 2.})
    for (const double distance : {-0.3, 0., 1e-6, 5.}) {
      const Point<2> point =
          chord_point(surface, face, eta) + distance * flat_normal(surface, face);
      EXPECT_NEAR(project_on_face(surface, face, point), eta, 10. * round_off);
    }
}

TEST(Projection, OnACircleFollowsTheRadius) {
  const double begin = 0.3;
  const double end = 0.8;
  const mesh::Circle circle{{0.5, 0.}, 2.};
  const Surface<2> surface = arc(circle, {begin, end});
  const SurfaceFace<2>& face = surface.faces.front();
  for (const double angle : {0.3, 0.35, 0.5, 0.79, 0.8})
    for (const double radius : {1.5, 2., 2.001, 9.}) {
      const Point<2> point(0.5 + radius * std::cos(angle), radius * std::sin(angle));
      // The chord divides the angle between its ends in the ratio of the sines.
      const double eta =
          std::sin(angle - begin) / (std::sin(angle - begin) + std::sin(end - angle));
      EXPECT_NEAR(project_on_face(surface, face, point), eta, 10. * round_off);
      const Tensor<1, 2> normal = face_normal(surface, face, eta);
      EXPECT_LT((normal - Tensor<1, 2>({std::cos(angle), std::sin(angle)})).norm(), round_off);
    }
}

/// Expects overlaps that follow each other without gap or overlap from begin to end.
void expect_tiles(const std::vector<Overlap>& tiles, const double begin, const double end) {
  ASSERT_FALSE(tiles.empty());
  EXPECT_NEAR(tiles.back().end, end, round_off);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    EXPECT_LT(tiles[i].begin, tiles[i].end);
    EXPECT_NEAR(tiles[i].begin, i > 0 ? tiles[i - 1].end : begin, round_off);
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(tiles[i].target_face, tiles[j].target_face);
  }
}

TEST(Overlaps, TileAnEdgeThatTheTargetCovers) {
  const Surface<2> source = underside({0., 1., 1.7, 4.}, 0.2);
  const Surface<2> target = upper_side({-1., 0.3, 0.9, 1., 1.4, 5.});
  const std::array<std::size_t, 3> expected{3, 2, 1};
  for (unsigned int face = 0; face < 3; ++face) {
    const auto tiles = overlaps(source, source.faces[face], target);
    expect_tiles(tiles, 0., 1.);
    EXPECT_EQ(tiles.size(), expected[face]);
  }
}

TEST(Overlaps, AreCutWhereTargetNodesProjectOnTheEdge) {
  const auto tiles = overlaps(underside({0., 2.}, 0.2), {{0, 1}, -1}, upper_side({-1., 0.5, 3.}));
  ASSERT_EQ(tiles.size(), 2U);
  EXPECT_NEAR(tiles[0].end, 0.25, round_off);
  EXPECT_EQ(tiles[0].target_face, 1U) << "the target's edges run from right to left";
  EXPECT_EQ(tiles[1].target_face, 0U);
}

TEST(Overlaps, EndWhereTheTargetEnds) {
  const auto tiles = overlaps(underside({0., 2.}, 0.2), {{0, 1}, -1}, upper_side({0.5, 0.7, 1.}));
  expect_tiles(tiles, 0.25, 0.5);
}

TEST(Overlaps, OfACircleOnAFlatTileTheEdgesAtTheBottom) {
  const Surface<2> circle = full_circle({{0., 1.}, 1.}, 24);
  const Surface<2> flat = upper_side({-3., -1.1, -0.95, -0.3, 0.05, 0.4, 0.95, 1.1, 3.});
  unsigned int covered = 0;
  for (const SurfaceFace<2>& face : circle.faces) {
    const auto tiles = overlaps(circle, face, flat);
    const double height = flat_normal(circle, face)[1];
    if (tiles.empty()) {
      EXPECT_GT(height, -0.11) << "only edges that look away from the flat have no overlap";
      continue;
    }
    ++covered;
    expect_tiles(tiles, 0., 1.);
    EXPECT_LT(height, -0.1);
  }
  EXPECT_EQ(covered, 12U) << "cos(84.3 deg) = 0.1: the edges at 7.5, 22.5 ... 82.5 deg";
}

/// What the target does far beyond the ends of a source edge says nothing about the edge.
TEST(Overlaps, ReachAcrossAnEdgeThatIsInclinedToAMuchLongerTarget) {
  const Surface<2> source = straight_surface({{8., 0.1}, {9., 0.7}});
  const Surface<2> target = upper_side({0., 10.});
  expect_tiles(overlaps(source, source.faces[0], target), 0., 1.);
}

TEST(Overlaps, OfAFlatUnderACircleTileTheEdges) {
  const Surface<2> flat = upper_side({-0.9, -0.3, 0.05, 0.4, 0.8});
  const Surface<2> circle = full_circle({{0., 1.}, 1.}, 24);
  for (const SurfaceFace<2>& face : flat.faces) expect_tiles(overlaps(flat, face, circle), 0., 1.);
}

TEST(Overlaps, OfAPinInAHoleTileTheEdges) {
  const Surface<2> pin = full_circle({{0., 0.}, 1.}, 24);
  std::vector<double> angles;
  for (int i = 0; i <= 31; ++i) angles.push_back(0.1 - 2. * pi * i / 31.);
  const Surface<2> hole = arc({{0., 0.}, 1.01}, angles);
  for (const SurfaceFace<2>& face : pin.faces) expect_tiles(overlaps(pin, face, hole), 0., 1.);
}

/// The lines along the normals at the ends of a wide target edge can pass a short source edge on
/// either side without the one looking at the other: a quarter of the way around.
TEST(Overlaps, OfAShortEdgeAreOnlyWithTheTargetEdgesThatItLooksAt) {
  const Surface<2> pin = full_circle({{0., 0.}, 1.}, 30);
  std::vector<double> angles;
  for (int i = 0; i <= 700; ++i) angles.push_back(0.1 - 2. * pi * i / 700.);
  const Surface<2> hole = arc({{0., 0.}, 1.5}, angles);
  for (const SurfaceFace<2>& face : hole.faces)
    for (const Overlap& overlap : overlaps(hole, face, pin)) {
      const double cosine =
          flat_normal(hole, face) * flat_normal(pin, pin.faces[overlap.target_face]);
      // A pin edge's turn, and the angle of half of the hole's edge.
      EXPECT_LT(cosine, -std::cos(2. * pi / 30. + 2. * pi / 1400.))
          << "an edge that is farther round than the nearest and its neighbours";
    }
}

TEST(Overlaps, AreNoneBetweenSurfacesThatLookTheSameWay) {
  const Surface<2> source = upper_side({0., 1.});
  EXPECT_TRUE(overlaps(source, source.faces[0], upper_side({-1., 2.})).empty());
}

TEST(Boundary, OfARefinedRingHasTheSameArcLengthAndOrderOnEveryRank) {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_ring(
      mesh, "ring",
      {{0.2, 0.1}, {0.5, 1.}, geneva::test::equal_steps(0., 2. * pi, 8), "bore", "rim", "", ""});
  Discretisation<2> coarse(mesh);
  Discretisation<2> fine(mesh, 3);
  for (const char* name : {"bore", "rim"}) {
    const unsigned int id = geneva::test::surface_id(mesh, name);
    const double radius = id == geneva::test::surface_id(mesh, "rim") ? 1. : 0.5;
    const Surface<2> before =
        make_surface(gather_boundary(*coarse.dof_handler, mesh.circles, 1.), id, Point<2>(2., 0.1));
    const Surface<2> after =
        make_surface(gather_boundary(*fine.dof_handler, mesh.circles, 1.), id, Point<2>(2., 0.1));
    ASSERT_EQ(before.nodes.size(), 8U);
    ASSERT_EQ(after.nodes.size(), 64U);
    EXPECT_NEAR(before.length, 2. * pi * radius, 64. * round_off);
    EXPECT_NEAR(after.length, 2. * pi * radius, 64. * round_off);
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_NEAR(before.nodes[i].arc_length, after.nodes[8 * i].arc_length, 64. * round_off);
    for (const SurfaceNode<2>& node : after.nodes) {
      const Tensor<1, 2> radial = (node.position - Point<2>(0.2, 0.1)) / radius;
      EXPECT_LT((node.normal - (radius < 1. ? -1. : 1.) * radial).norm(), 10. * round_off);
    }
  }
}

}  // namespace
}  // namespace geneva::fem::test
