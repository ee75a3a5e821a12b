#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "case_directory.h"
#include "loads/pi.h"
#include "mesh/kinks.h"
#include "mesh/onto_circles.h"
#include "mesh/round_shapes.h"
#include "saved_mesh.h"
#include "test_mesher.h"
#include "tests/support/refusal.h"

namespace geneva::mesh {
namespace {

using loads::degree;
using loads::pi;
using loads::test::expect_refused;
using test::CaseDirectory;

/// Points of an arc of radius 2 about (1, -3), by turns a little outside and inside.
std::vector<Place> wavy_arc(const int count, const double angle, const double off) {
  std::vector<Place> points;
  for (int i = 0; i < count; ++i) {
    const double at = angle * i / count;
    const double radius = 2. + (i % 2 == 0 ? off : -off);
    points.push_back({1. + radius * std::cos(at), -3. + radius * std::sin(at), 0.});
  }
  return points;
}

TEST(CircleNear, IsTheOneOfLeastSquares) {
  // an even number of even waves round a whole turn moves neither centre nor radius
  const auto circle = circle_near(wavy_arc(16, 2. * pi, 1e-4), 1e-4);
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->centre[0], 1., 1e-12);
  EXPECT_NEAR(circle->centre[1], -3., 1e-12);
  EXPECT_NEAR(circle->radius, 2., 1e-12);
}

TEST(CircleNear, IsExactOnPointsOfACircle) {
  for (const double angle : {0.2, 1., 6.}) {
    const auto circle = circle_near(wavy_arc(7, angle, 0.), 1e-6);
    ASSERT_TRUE(circle) << angle;
    EXPECT_NEAR(circle->radius, 2., 1e-10) << angle;
  }
}

TEST(CircleNear, IsNoneFartherOffThanTheToleranceOrWithTooFewPoints) {
  EXPECT_TRUE(circle_near(wavy_arc(16, 2. * pi, 1e-4), 0.51e-4));
  EXPECT_FALSE(circle_near(wavy_arc(16, 2. * pi, 1e-4), 0.49e-4));
  EXPECT_FALSE(circle_near(wavy_arc(4, 2. * pi, 1e-4), 1e-2));
}

TEST(CircleNear, IsNoneOfALineThatIsNotStraight) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-1e-6, 1e-6);
  std::vector<Place> points;
  for (int i = 0; i < 20; ++i) points.push_back({0.1 * i, off(random), 0.});
  EXPECT_FALSE(circle_near(points, 1e-2)) << "a circle of a thousand times its length would do";
}

/// Points of a patch of a cylinder of radius 3 along a skew axis, or of a sphere, and their
/// normals.
struct Patch {
  std::vector<Place> points;
  std::vector<SurfaceNormal> normals;
};
Patch patch(const bool is_sphere, const double off) {
  const Place axis{2. / 3., 1. / 3., 2. / 3.};
  const Place first{1. / 3., 2. / 3., -2. / 3.};
  const Place second{-2. / 3., 2. / 3., 1. / 3.};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-off, off);
  Patch result;
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 6; ++k) {
      const double across = 0.15 * i;
      const double along = is_sphere ? std::sin(0.2 * k) : 0.;
      const double share = is_sphere ? std::cos(0.2 * k) : 1.;
      const double radius = 3. + noise(random);
      Place normal{};
      Place point{};
      for (std::size_t c = 0; c < 3; ++c) {
        normal[c] =
            share * (std::cos(across) * first[c] + std::sin(across) * second[c]) + along * axis[c];
        point[c] = 1. + radius * normal[c] + (is_sphere ? 0. : 0.7 * k * axis[c]);
      }
      result.points.push_back(point);
      result.normals.push_back({point, normal});
    }
  return result;
}

TEST(RoundSurfaceNear, TellsACylinderFromASphere) {
  for (const bool is_sphere : {false, true}) {
    const Patch near = patch(is_sphere, 1e-4);
    EXPECT_FALSE(round_surface_through(near.points, near.normals));
    const auto shape = round_surface_near(near.points, near.normals, 1e-3);
    ASSERT_TRUE(shape);
    EXPECT_NEAR(shape->radius, 3., 1e-2);
    EXPECT_EQ(std::hypot(shape->axis[0], shape->axis[1], shape->axis[2]) > 0.5, !is_sphere);
    EXPECT_FALSE(round_surface_near(near.points, near.normals, 1e-6));
  }
}

TEST(RoundSurfaceNear, IsNoneOfAPlaneThatIsNotFlat) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-1e-6, 1e-6);
  Patch plane;
  for (int i = 0; i < 30; ++i) {
    plane.points.push_back({0.1 * (i % 6), 0.1 * std::floor(i / 6.), off(random)});
    plane.normals.push_back({plane.points.back(), {1e-4 * off(random), 0., 1.}});
  }
  EXPECT_FALSE(round_surface_near(plane.points, plane.normals, 1e-2));
}

/// Three edges of one surface through these points.
MeshData<2> chain(const std::vector<std::array<double, 2>>& points, const int circle = -1) {
  MeshData<2> mesh;
  mesh.vertices = points;
  mesh.surfaces = {"", "side"};
  for (unsigned int i = 0; i + 1 < points.size(); ++i)
    mesh.faces.push_back({{i, i + 1}, 1, circle});
  return mesh;
}

TEST(Kinks, OfAPolygonAreTheAnglesBetweenItsEdges) {
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i <= 6; ++i)
    points.push_back({std::cos(10. * degree * i), std::sin(10. * degree * i)});
  EXPECT_NEAR(maximum_kink(chain(points), "side"), 10. * degree, 1e-12);
  EXPECT_EQ(maximum_kink(chain(points), "other"), 0.);
  MeshData<2> round = chain(points, 0);
  round.circles = {{{0., 0.}, 1.}};
  EXPECT_EQ(maximum_kink(round, "side"), 0.);
}

TEST(Kinks, AreNoneOfAFlatSideAndOfASquareCorner) {
  EXPECT_EQ(maximum_kink(chain({{0., 0.}, {1., 0.}, {3., 0.}, {3.5, 0.}}), "side"), 0.);
  EXPECT_EQ(maximum_kink(chain({{0., 0.}, {1., 0.}, {1., 2.}, {-1., 2.}}), "side"), 0.);
  EXPECT_NEAR(maximum_kink(chain({{0., 0.}, {1., 0.}, {2., 1.}}), "side"), 45. * degree, 1e-12);
}

TEST(Kinks, InSpaceAreThoseAcrossTheEdgesOfQuadrilaterals) {
  MeshData<3> roof;
  const double slope = std::tan(7. * degree);
  for (const double y : {0., 1.})
    for (const double x : {-1., 0., 1.}) roof.vertices.push_back({x, y, -std::abs(x) * slope});
  roof.surfaces = {"", "roof"};
  roof.faces = {{{0, 1, 4, 3}, 1, -1}, {{1, 2, 5, 4}, 1, -1}};
  EXPECT_NEAR(maximum_kink(roof, "roof"), 14. * degree, 1e-12);
  for (auto& vertex : roof.vertices) vertex[2] = 0.;
  EXPECT_EQ(maximum_kink(roof, "roof"), 0.);
}

TEST(MoveOntoCircles, KeepsTheEndOnTheFlatFaceBeside) {
  // the last edge is flat: its vertex on the circle slides along it
  MeshData<2> mesh = chain({{1., 0.}, {0.01, 0.99}, {-0.5, 0.99}});
  mesh.circles = {{{0., 0.}, 1.}};
  mesh.faces[0].circle = 0;
  mesh.vertices[1] = {0.6, 0.79};
  mesh.vertices[2] = {0.6, 2.};
  move_onto_circles(mesh, {0});
  EXPECT_EQ(mesh.vertices[1][0], 0.6);
  EXPECT_NEAR(mesh.vertices[1][1], 0.8, 1e-14);
  EXPECT_EQ(mesh.vertices[2], (std::array<double, 2>{0.6, 2.}));
}

TEST(MoveOntoCircles, GoesStraightToTheCircleFromAFlatFaceAlongIt) {
  MeshData<2> mesh = chain({{1., 0.}, {0., 1.001}, {-2., 1.001}});
  mesh.circles = {{{0., 0.}, 1.}};
  mesh.faces[0].circle = 0;
  move_onto_circles(mesh, {0});
  EXPECT_EQ(mesh.vertices[1][0], 0.);
  EXPECT_NEAR(mesh.vertices[1][1], 1., 1e-14);
}

TEST(MoveOntoCircles, PutsAVertexOnBothOfItsCircles) {
  MeshData<2> mesh = chain({{1., 0.}, {0.001, 1.0005}, {-1., 2.}});
  mesh.circles = {{{0., 0.}, 1.}, {{-1., 1.}, 1.}};
  mesh.faces[0].circle = 0;
  mesh.faces[1].circle = 1;
  move_onto_circles(mesh, {0});
  EXPECT_NEAR(mesh.vertices[1][0], 0., 1e-13);
  EXPECT_NEAR(mesh.vertices[1][1], 1., 1e-13);
}

TEST(MoveOntoCircles, RefusesCirclesThatDoNotMeet) {
  MeshData<2> mesh = chain({{1., 0.}, {0., 1.}, {-1., 2.}});
  mesh.circles = {{{0., 0.}, 1.}, {{0., 2.1}, 1.}};
  mesh.faces[0].circle = 0;
  mesh.faces[1].circle = 1;
  expect_refused([&] { move_onto_circles(mesh, {0}); }, {"(0, 1", "Circle tolerance"});
}

/// A quarter of a pipe about an axis through (1, 2, 3) along x, radii 2 and 4, length 5.
const std::string pipe = R"(
SetFactory("OpenCASCADE");
Point(1) = {0, 2, 3}; Point(2) = {0, 4, 3}; Point(3) = {0, 6, 3}; Point(4) = {0, 2, 7};
Point(5) = {0, 2, 5};
Line(1) = {2, 3}; Circle(2) = {3, 1, 4}; Line(3) = {4, 5}; Circle(4) = {5, 1, 2};
Curve Loop(1) = {1:4}; Plane Surface(1) = {1};
Transfinite Curve {1:4} = 7; Transfinite Surface {1}; Recombine Surface {1};
pipe[] = Extrude {5, 0, 0} { Surface{1}; Layers{3}; Recombine; };
Physical Volume("pipe") = {pipe[1]};
Physical Surface("outside") = {pipe[3]}; Physical Surface("inside") = {pipe[5]};
Physical Surface("end") = {1}; Physical Surface("side") = {pipe[2]};
)";

/// An ASCII mesh of format 2.2 whose nodes on the outside of the pipe are off by a share of its
/// radius at most.
std::string off_round(const std::string& mesh, const double off) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> noise(-off, off);
  std::istringstream lines(mesh);
  std::string result;
  bool in_nodes = false;
  for (std::string line; std::getline(lines, line);) {
    if (line[0] == '$') in_nodes = line == "$Nodes";
    std::istringstream words(line);
    std::size_t tag = 0;
    double x = 0.;
    double y = 0.;
    double z = 0.;
    if (in_nodes && words >> tag >> x >> y >> z) {
      const double radius = std::hypot(y - 2., z - 3.);
      const double stretch = std::abs(radius - 4.) < 1e-9 ? 1. + noise(random) : 1.;
      std::ostringstream moved;
      moved.precision(17);
      moved << tag << ' ' << x << ' ' << 2. + stretch * (y - 2.) << ' ' << 3. + stretch * (z - 3.);
      line = moved.str();
    }
    result += line + '\n';
  }
  return result;
}

TEST(GeometryInSpace, OfANearlyRoundMeshIsRoundWithinTheTolerance) {
  const double off = 1e-5;
  const CaseDirectory directory;
  const auto file = directory.write("mesh.msh", off_round(test::saved(pipe, 2.2, false, 3), off));
  const MeshData<3> polygon = read_geometry<3>(file, 1.);
  EXPECT_NEAR(maximum_kink(polygon, "outside"), 15. * degree, 0.1 * degree);
  EXPECT_EQ(maximum_kink(polygon, "inside"), 0.);

  const MeshData<3> round = read_geometry<3>(file, 1., 2. * off);
  EXPECT_EQ(maximum_kink(round, "outside"), 0.);
  ASSERT_EQ(round.circles.size(), 2U);
  for (const Circle& circle : round.circles)
    if (circle.radius > 3.) {
      EXPECT_NEAR(circle.radius, 4., 4. * 10. * off);
    }
  // the faces beside stay flat: their vertices slide along them
  for (const Face<3>& face : round.faces)
    for (const unsigned int vertex : face.vertices) {
      const std::string& surface = round.surfaces[face.surface];
      if (surface == "end") {
        EXPECT_NEAR(round.vertices[vertex][0], 0., 1e-15);
      } else if (surface == "side") {
        EXPECT_NEAR(round.vertices[vertex][2], 3., 1e-14);
      }
    }
  double farthest = 0.;
  for (std::size_t i = 0; i < round.vertices.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      farthest = std::max(farthest, std::abs(round.vertices[i][k] - polygon.vertices[i][k]));
  EXPECT_GT(farthest, 0.);
  EXPECT_LE(farthest, 4. * 2. * off);
}

}  // namespace
}  // namespace geneva::mesh
