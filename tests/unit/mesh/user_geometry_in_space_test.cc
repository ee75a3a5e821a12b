#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "case_directory.h"
#include "saved_mesh.h"
#include "test_mesher.h"
#include "tests/support/refusal.h"

namespace geneva::mesh {
namespace {

using loads::test::expect_refused;
using test::CaseDirectory;

/// A quarter of a pipe about an axis through (1, 2, 3) along x, radii 2 and 4, length 5.
const std::string pipe = R"(
SetFactory("OpenCASCADE");
Point(1) = {0, 2, 3}; Point(2) = {0, 4, 3}; Point(3) = {0, 6, 3}; Point(4) = {0, 2, 7};
Point(5) = {0, 2, 5};
Line(1) = {2, 3}; Circle(2) = {3, 1, 4}; Line(3) = {4, 5}; Circle(4) = {5, 1, 2};
Curve Loop(1) = {1:4}; Plane Surface(1) = {1};
Transfinite Curve {1:4} = 4; Transfinite Surface {1}; Recombine Surface {1};
pipe[] = Extrude {5, 0, 0} { Surface{1}; Layers{3}; Recombine; };
Physical Volume("pipe") = {pipe[1]};
Physical Surface("outside") = {pipe[3]}; Physical Surface("inside") = {pipe[5]};
Physical Surface("end") = {1};
)";

/// A shell between spheres of radius 3 and 6 about (1, 0, 0), a sixth of the whole.
const std::string shell = R"(
Point(1) = {1, 0, 0};
Macro Patch
  r = s / Sqrt(3);
  Point(n + 1) = {1 - r, -r, r}; Point(n + 2) = {1 + r, -r, r}; Point(n + 3) = {1 + r, r, r};
  Point(n + 4) = {1 - r, r, r};
  For i In {1:4}
    Circle(n + i) = {n + i, 1, n + 1 + (i % 4)};
  EndFor
  Curve Loop(n) = {n + 1, n + 2, n + 3, n + 4}; Surface(n) = {n} In Sphere {1};
Return
n = 10; s = 3; Call Patch;
n = 20; s = 6; Call Patch;
For i In {1:4}
  Line(30 + i) = {10 + i, 20 + i};
EndFor
For i In {1:4}
  Curve Loop(30 + i) = {10 + i, 31 + (i % 4), -(20 + i), -(30 + i)};
  Plane Surface(30 + i) = {30 + i};
EndFor
Surface Loop(1) = {10, 20, 31:34}; Volume(1) = {1};
Transfinite Curve {11:14, 21:24, 31:34} = 4;
Transfinite Surface {10, 20, 31:34}; Recombine Surface {10, 20, 31:34}; Transfinite Volume {1};
Physical Volume("shell") = {1}; Physical Surface("inside") = {10}; Physical Surface("outside") = {20};
)";

const std::string square = R"(
SetFactory("OpenCASCADE"); Rectangle(1) = {0, 0, 0, 1, 1};
Physical Surface("square") = {1}; Physical Curve("base") = {1};
)";

MeshData<3> read_in_space(const std::string& name, const std::string& content, double unit = 1.) {
  const CaseDirectory directory;
  return read_geometry<3>(directory.write(name, content), unit);
}

/// Circle of a surface's faces; none if they have different ones, or none.
std::optional<Circle> circle_of(const MeshData<3>& mesh, const std::string& surface) {
  std::set<int> circles;
  for (const Face<3>& face : mesh.faces)
    if (mesh.surfaces[face.surface] == surface) circles.insert(face.circle);
  if (circles.size() != 1 || *circles.begin() < 0) return std::nullopt;
  return mesh.circles[static_cast<std::size_t>(*circles.begin())];
}

void expect_cylinder(const std::optional<Circle>& circle, const double radius) {
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius, radius, 1e-10);
  EXPECT_NEAR(circle->axis[0], 1., 1e-12);
  EXPECT_NEAR(circle->centre[1], 2., 1e-10);
  EXPECT_NEAR(circle->centre[2], 3., 1e-10);
}

void expect_sphere(const std::optional<Circle>& circle, const double radius) {
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius, radius, 1e-10);
  EXPECT_EQ(circle->axis, (std::array<double, 3>{0., 0., 0.}));
  EXPECT_NEAR(circle->centre[0], 1., 1e-10);
  EXPECT_NEAR(circle->centre[1], 0., 1e-10);
  EXPECT_NEAR(circle->centre[2], 0., 1e-10);
}

TEST(GeometryInSpace, OfAnExtrudedPipeHasItsCellsNamesAndCylinders) {
  const MeshData<3> mesh = read_in_space("geometry.geo", pipe);
  EXPECT_EQ(mesh.bodies, std::vector<std::string>{"pipe"});
  EXPECT_EQ(mesh.cells.size(), 27U);
  EXPECT_EQ(mesh.faces.size(), 6U * 9U);
  EXPECT_EQ(mesh.circles.size(), 2U);
  expect_cylinder(circle_of(mesh, "outside"), 4.);
  expect_cylinder(circle_of(mesh, "inside"), 2.);
  EXPECT_FALSE(circle_of(mesh, "end"));
}

TEST(GeometryInSpace, OfAShellHasItsSpheres) {
  const MeshData<3> mesh = read_in_space("geometry.geo", shell);
  EXPECT_EQ(mesh.cells.size(), 27U);
  EXPECT_EQ(mesh.circles.size(), 2U);
  expect_sphere(circle_of(mesh, "outside"), 6.);
  expect_sphere(circle_of(mesh, "inside"), 3.);
}

TEST(GeometryInSpace, IsScaledWithItsShapes) {
  const MeshData<3> mesh = read_in_space("geometry.geo", shell, 0.001);
  EXPECT_NEAR(circle_of(mesh, "outside")->radius, 0.006, 1e-13);
  EXPECT_NEAR(circle_of(mesh, "outside")->centre[0], 0.001, 1e-13);
}

TEST(GeometryInSpace, OfAMeshFileFindsCylindersAndSpheresInTheNodes) {
  for (const double version : {2.2, 4.1}) {
    const MeshData<3> round = read_in_space("mesh.msh", test::saved(pipe, version, true, 3));
    expect_cylinder(circle_of(round, "outside"), 4.);
    EXPECT_FALSE(circle_of(round, "end"));
    expect_sphere(
        circle_of(read_in_space("mesh.msh", test::saved(shell, version, false, 3)), "inside"), 3.);
  }
}

/// Volume of hexahedra as six tetrahedra about a diagonal each.
double volume_of(const MeshData<3>& mesh) {
  double sum = 0.;
  for (const Cell<3>& cell : mesh.cells) {
    const auto place = [&](const std::size_t i) { return mesh.vertices[cell.vertices[i]]; };
    for (const auto& [i, k] : {std::pair{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}}) {
      const auto a = place(static_cast<std::size_t>(i));
      const auto b = place(static_cast<std::size_t>(k));
      const auto o = place(0);
      const auto d = place(6);
      const auto minus = [&](const auto& p) {
        return std::array<double, 3>{p[0] - o[0], p[1] - o[1], p[2] - o[2]};
      };
      const auto [u, v, w] = std::array{minus(a), minus(b), minus(d)};
      sum += (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
              u[2] * (v[0] * w[1] - v[1] * w[0])) /
             6.;
    }
  }
  return sum;
}

TEST(GeometryInSpace, OfTetrahedraIsDividedIntoHexahedra) {
  for (const int order : {1, 2}) {
    const MeshData<3> mesh =
        read_in_space("geometry.geo", fmt::format("Mesh.ElementOrder = {};", order) + R"(
SetFactory("OpenCASCADE"); Box(1) = {0, 0, 0, 1, 2, 3};
Physical Volume("box") = {1}; Physical Surface("side") = {1};
)");
    EXPECT_EQ(mesh.cells.size() % 4, 0U);
    EXPECT_NEAR(volume_of(mesh), 6., 1e-12);
    EXPECT_TRUE(mesh.circles.empty());
  }
}

TEST(GeometryInSpace, OfTetrahedraFollowsItsCylindersAndSpheres) {
  const std::string ball = R"(
SetFactory("OpenCASCADE"); Sphere(1) = {1, 0, 0, 6};
Mesh.MeshSizeMax = 4; Mesh.RecombineAll = 0;
Physical Volume("ball") = {1}; Physical Surface("outside") = {1};
)";
  for (const int order : {1, 2}) {
    const std::string text = fmt::format("Mesh.ElementOrder = {};", order) + ball;
    expect_sphere(circle_of(read_in_space("geometry.geo", text), "outside"), 6.);
    expect_sphere(circle_of(read_in_space("mesh.msh", test::saved(text, 4.1, true, 3)), "outside"),
                  6.);
  }
}

TEST(GeometryInSpace, OfPrismsIsDividedIntoHexahedra) {
  const MeshData<3> mesh = read_in_space("geometry.geo", R"(
SetFactory("OpenCASCADE"); Mesh.MeshSizeMax = 1;
Rectangle(1) = {0, 0, 0, 2, 1};
box[] = Extrude {0, 0, 3} { Surface{1}; Layers{2}; Recombine; };
Physical Volume("box") = {box[1]}; Physical Surface("top") = {box[0]};
)");
  EXPECT_EQ(mesh.cells.size() % 6, 0U);
  EXPECT_NEAR(volume_of(mesh), 6., 1e-12);
}

TEST(GeometryInSpace, AndInThePlaneAreToldApart) {
  const CaseDirectory directory;
  const auto plane = directory.write("plane.geo", square);
  expect_refused([&] { (void)read_geometry<3>(plane, 1.); },
                 {"no physical volume", "'set Dimension = 2'"});
  const auto space = directory.write("space.geo", pipe + "Physical Curve(\"edge\") = {1};\n");
  expect_refused([&] { (void)read_geometry<2>(space, 1.); }, {"'set Dimension = 3'"});
}

/// Two cubes that touch along an edge parallel to z, which Gmsh's built-in Extrude makes one line.
const std::string cubes = R"(
Macro Square
  Point(n + 1) = {s, s, 0}; Point(n + 2) = {s + 1, s, 0}; Point(n + 3) = {s + 1, s + 1, 0};
  Point(n + 4) = {s, s + 1, 0};
  For i In {1:4}
    Line(n + i) = {n + i, n + 1 + (i % 4)};
  EndFor
  Curve Loop(n) = {n + 1, n + 2, n + 3, n + 4}; Plane Surface(n) = {n};
  Transfinite Curve {n + 1, n + 2, n + 3, n + 4} = 3; Transfinite Surface {n};
  Recombine Surface {n};
Return
n = 100; s = 0; Call Square;
lower[] = Extrude {0, 0, 1} { Surface{100}; Layers{2}; Recombine; };
n = 200; s = 1; Call Square;
upper[] = Extrude {0, 0, 1} { Surface{200}; Layers{2}; Recombine; };
Physical Volume("lower") = {lower[1]}; Physical Surface("lower top") = {lower[4]};
Physical Volume("upper") = {upper[1]}; Physical Surface("upper bottom") = {upper[2]};
)";

TEST(GeometryInSpace, OfBodiesThatTouchInALineGivesEachVerticesOfItsOwn) {
  const MeshData<3> mesh = read_in_space("geometry.geo", cubes);
  EXPECT_EQ(mesh.cells.size(), 16U);
  EXPECT_EQ(mesh.vertices.size(), 2U * 27U);
  EXPECT_EQ(mesh.faces.size(), 2U * 24U);
  std::array<std::set<unsigned int>, 2> of_body;
  for (const Cell<3>& cell : mesh.cells)
    of_body.at(cell.body).insert(cell.vertices.begin(), cell.vertices.end());
  EXPECT_EQ(of_body[0].size(), 27U);
  EXPECT_EQ(of_body[1].size(), 27U);
  std::map<std::string, std::size_t> faces;
  for (const Face<3>& face : mesh.faces) ++faces[mesh.surfaces[face.surface]];
  EXPECT_EQ(faces["lower top"], 4U);
  EXPECT_EQ(faces["upper bottom"], 4U);
}

TEST(GeometryInSpace, OfBodiesThatShareFacesIsRefused) {
  const CaseDirectory directory;
  const auto file = directory.write("geometry.geo", pipe + R"(
other[] = Extrude {-5, 0, 0} { Surface{1}; Layers{3}; Recombine; };
Physical Volume("other") = {other[1]};
)");
  expect_refused([&] { (void)read_geometry<3>(file, 1.); },
                 {"pipe", "other", "share the face", "AutoCoherence = 0", "OpenCASCADE"});
}

/// A quarter of a ring with a conical outside, which is so many cells long.
std::string conical(const int cells) {
  return fmt::format(R"(
Point(1) = {{2, 0, 0}}; Point(2) = {{4, 0, 0}}; Point(3) = {{3, 1, 0}}; Point(4) = {{2, 1, 0}};
Line(1) = {{1, 2}}; Line(2) = {{2, 3}}; Line(3) = {{3, 4}}; Line(4) = {{4, 1}};
Curve Loop(1) = {{1:4}}; Plane Surface(1) = {{1}};
Transfinite Curve {{1, 3}} = 2; Transfinite Curve {{2, 4}} = {}; Transfinite Surface {{1}}; Recombine Surface {{1}};
v[] = Extrude {{{{0, 1, 0}}, {{0, 0, 0}}, Pi / 2}} {{ Surface{{1}}; Layers{{5}}; Recombine; }};
Physical Volume("ring") = {{v[1]}}; Physical Surface("cone") = {{v[3]}}; Physical Surface("bore") = {{v[5]}};
)",
                     cells + 1);
}

TEST(GeometryInSpace, OfAMeshedConeIsNoSphereThoughTwoRingsOfNodesLieOnOne) {
  for (const int cells : {1, 2, 3}) {
    const MeshData<3> mesh = read_in_space("mesh.msh", test::saved(conical(cells), 4.1, false, 3));
    EXPECT_FALSE(circle_of(mesh, "cone")) << cells;
    const auto bore = circle_of(mesh, "bore");
    ASSERT_TRUE(bore) << cells;
    EXPECT_NEAR(bore->radius, 2., 1e-12);
  }
}

TEST(GeometryInSpace, OfAMeshedSphereIsRound) {
  const auto outside =
      circle_of(read_in_space("mesh.msh", test::saved(shell, 4.1, false, 3)), "outside");
  ASSERT_TRUE(outside);
  EXPECT_NEAR(outside->radius, 6., 1e-12);
}

/// A quarter of a turned part from its outline: points x and y, then curves between them.
std::string turned(const std::string& points, const std::string& curves, const int n_curves,
                   const double cell_size) {
  return fmt::format(R"(
SetFactory("OpenCASCADE");
{}
{}
Curve Loop(1) = {{1:{}}}; Plane Surface(1) = {{1}};
v[] = Extrude {{{{0, 1, 0}}, {{0, 0, 0}}, Pi / 2}} {{ Surface{{1}}; }};
Physical Volume("part") = {{v[1]}};
For i In {{1:{}}}
  Physical Surface(Sprintf("of curve %g", i)) = {{v[i + 1]}};
EndFor
Mesh.MeshSizeMax = {}; Mesh.MeshSizeMin = 1;
)",
                     points, curves, n_curves, n_curves, cell_size);
}

void expect_torus(const MeshData<3>& mesh, const std::string& surface, const double ring,
                  const double tube) {
  const auto circle = circle_of(mesh, surface);
  ASSERT_TRUE(circle) << surface;
  EXPECT_NEAR(circle->ring_radius, ring, 1e-9) << surface;
  EXPECT_NEAR(circle->radius, tube, 1e-9) << surface;
}

TEST(GeometryInSpace, OfTetrahedraFollowsAFilletBetweenAPlaneAndACylinder) {
  const MeshData<3> mesh = read_in_space(
      "geometry.geo",
      turned("Point(1) = {6, 0, 0}; Point(2) = {22, 0, 0}; Point(3) = {22, 20, 0}; Point(4) = {18, "
             "20, 0}; Point(5) = {15, 23, 0}; Point(6) = {15, 40, 0}; Point(7) = {6, 40, 0}; "
             "Point(8) = {18, 23, 0};",
             "Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Circle(4) = {4, 8, 5}; Line(5) "
             "= {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 1};",
             7, 1.5));
  expect_torus(mesh, "of curve 4", 18., 3.);
  for (const Face<3>& face : mesh.faces) {
    if (mesh.surfaces[face.surface] != "of curve 3") continue;
    for (const unsigned int vertex : face.vertices)
      EXPECT_NEAR(mesh.vertices[vertex][1], 20., 1e-9);
  }
}

TEST(GeometryInSpace, OfTetrahedraFollowsToriThatTouchASphereAndEachOther) {
  // A ball of 10 at a plate with a fillet of 3: the centres are 13 apart, the fillet's 3 above the
  // plate. Then an edge rounded by 6, that goes on with 2.
  const double ring = std::sqrt(13. * 13. - 3. * 3.);
  const double touch = 10. / 13.;
  const MeshData<3> ball = read_in_space(
      "geometry.geo",
      turned(fmt::format("Point(1) = {{18, -4, 0}}; Point(2) = {{18, 0, 0}}; Point(3) = {{{0}, 0, "
                         "0}}; Point(4) = {{{1}, {2}, 0}}; Point(5) = {{2, {3}, 0}}; Point(6) = "
                         "{{2, -4, 0}}; Point(7) = {{{0}, 3, 0}}; Point(8) = {{0, 0, 0}};",
                         ring, touch * ring, touch * 3., std::sqrt(96.)),
             "Line(1) = {1, 2}; Line(2) = {2, 3}; Circle(3) = {3, 7, 4}; Circle(4) = {4, 8, 5}; "
             "Line(5) = {5, 6}; Line(6) = {6, 1};",
             6, 1.5));
  expect_torus(ball, "of curve 3", ring, 3.);
  const auto sphere = circle_of(ball, "of curve 4");
  ASSERT_TRUE(sphere);
  EXPECT_NEAR(sphere->radius, 10., 1e-9);

  const double half = std::sqrt(0.5);
  const MeshData<3> edge = read_in_space(
      "geometry.geo",
      turned(fmt::format(
                 "Point(1) = {{17, 15, 0}}; Point(2) = {{{0}, 15, 0}}; Point(3) = {{{0}, 20, 0}}; "
                 "Point(4) = {{{1}, {2}, 0}}; Point(5) = {{{3}, {4}, 0}}; Point(6) = {{17, {4}, "
                 "0}}; Point(7) = {{20, 20, 0}}; Point(8) = {{{3}, {5}, 0}};",
                 26., 20. + 6. * half, 20. + 6. * half, 20. + 4. * half, 22. + 4. * half,
                 20. + 4. * half),
             "Line(1) = {1, 2}; Line(2) = {2, 3}; Circle(3) = {3, 7, 4}; Circle(4) = {4, 8, 5}; "
             "Line(5) = {5, 6}; Line(6) = {6, 1};",
             6, 1.2));
  expect_torus(edge, "of curve 3", 20., 6.);
  expect_torus(edge, "of curve 4", 20. + 4. * half, 2.);
}

}  // namespace
}  // namespace geneva::mesh
