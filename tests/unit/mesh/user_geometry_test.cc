
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "case_directory.h"
#include "mesh/mesh_quality.h"
#include "saved_mesh.h"
#include "test_mesher.h"
#include "tests/support/refusal.h"

namespace geneva::mesh {
namespace {

using loads::test::expect_refused;
using test::CaseDirectory;

const std::string two_blocks = R"(
Point(1) = {0, 0, 0}; Point(2) = {4, 0, 0}; Point(3) = {4, 2, 0}; Point(4) = {0, 2, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 5; Transfinite Curve {2, 4} = 3; Transfinite Surface {1};
Point(11) = {0, 2, 0}; Point(12) = {4, 2, 0}; Point(13) = {4, 5, 0}; Point(14) = {0, 5, 0};
Line(11) = {11, 12}; Line(12) = {12, 13}; Line(13) = {13, 14}; Line(14) = {14, 11};
Curve Loop(11) = {11, 12, 13, 14}; Plane Surface(11) = {11};
Transfinite Curve {11, 13} = 4; Transfinite Curve {12, 14} = 4; Transfinite Surface {11};
Physical Surface("lower") = {1}; Physical Surface("upper") = {11};
Physical Curve("lower top") = {3}; Physical Curve("upper base") = {11};
Physical Curve("foot") = {1};
)";

/// A disc of radius 2 about (3, 1) with a square hole, and lc for the size of its cells.
const std::string disc = R"(
Point(1) = {3, 1, 0, lc}; Point(2) = {5, 1, 0, lc}; Point(3) = {3, 3, 0, lc};
Point(4) = {1, 1, 0, lc}; Point(5) = {3, -1, 0, lc};
Circle(1) = {2, 1, 3}; Circle(2) = {3, 1, 4}; Circle(3) = {4, 1, 5}; Circle(4) = {5, 1, 2};
Point(6) = {3.5, 0.5, 0, lc}; Point(7) = {3.5, 1.5, 0, lc}; Point(8) = {2.5, 1.5, 0, lc};
Point(9) = {2.5, 0.5, 0, lc};
Line(5) = {6, 7}; Line(6) = {7, 8}; Line(7) = {8, 9}; Line(8) = {9, 6};
Curve Loop(1) = {1:4}; Curve Loop(2) = {5:8}; Plane Surface(1) = {1, 2};
Physical Surface("disc") = {1}; Physical Curve("round") = {1:4};
)";

/// Two unit squares with their own vertices; the parts of a text .msh 2.2 file may be exchanged.
struct Msh {
  std::string names = "4\n2 1 \"left\"\n2 2 \"right\"\n1 3 \"base\"\n1 4 \"face\"\n";
  std::string nodes = "8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 1 0 0\n6 2 0 0\n7 2 1 0\n8 1 1 0\n";
  // number, type, two tags: physical group and entity, nodes
  std::string elements = "4\n1 1 2 3 1 1 2\n2 1 2 4 2 8 5\n3 3 2 1 1 1 2 3 4\n4 3 2 2 2 5 6 7 8\n";

  [[nodiscard]] std::string text() const {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" + names +
           "$EndPhysicalNames\n$Nodes\n" + nodes + "$EndNodes\n$Elements\n" + elements +
           "$EndElements\n";
  }
};

MeshData<2> read(const std::string& name, const std::string& content, double unit = 1.) {
  const CaseDirectory directory;
  return read_geometry<2>(directory.write(name, content), unit);
}

MeshData<2> read_geo(const std::string& content) { return read("geometry.geo", content + "\n"); }

void expect_geo_refused(const std::string& content, std::initializer_list<std::string> parts) {
  const CaseDirectory directory;
  const auto file = directory.write("geometry.geo", content + "\n");
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, {file.string()});
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, parts);
}

void expect_msh_refused(const std::string& content, std::initializer_list<std::string> parts) {
  const CaseDirectory directory;
  const auto file = directory.write("wheel.msh", content);
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, {file.string()});
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, parts);
}

std::size_t edges_of(const MeshData<2>& mesh, const std::string& surface) {
  return static_cast<std::size_t>(
      std::count_if(mesh.faces.begin(), mesh.faces.end(),
                    [&](const Face<2>& edge) { return mesh.surfaces[edge.surface] == surface; }));
}

std::size_t cells_of(const MeshData<2>& mesh, const std::string& body) {
  return static_cast<std::size_t>(
      std::count_if(mesh.cells.begin(), mesh.cells.end(),
                    [&](const Cell<2>& quad) { return mesh.bodies[quad.body] == body; }));
}

TEST(GeoFile, OfTwoBlocksHasTheirCellsAndNamesInOrder) {
  const MeshData<2> mesh = read_geo(two_blocks);
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(mesh.surfaces, (std::vector<std::string>{"", "lower top", "upper base", "foot"}));
  EXPECT_EQ(cells_of(mesh, "lower"), 8U);
  EXPECT_EQ(cells_of(mesh, "upper"), 9U);
  EXPECT_EQ(edges_of(mesh, "lower top"), 4U);
  EXPECT_EQ(edges_of(mesh, "upper base"), 3U);
  EXPECT_EQ(edges_of(mesh, ""), 2U + 2U + 3U + 3U + 3U);
  EXPECT_NEAR(minimum_scaled_jacobian(mesh), 1., 1e-12);
  EXPECT_TRUE(mesh.circles.empty());
}

TEST(GeoFile, WithoutALineFeedAtTheEndIsRefusedAndNotReadInPart) {
  const CaseDirectory directory;
  const std::string last = "a = 1; Physical Curve(\"last\") = {2};";
  EXPECT_EQ(edges_of(read_geo(two_blocks + last), "last"), 2U);
  const auto file = directory.write("geometry.geo", two_blocks + last);
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, {"last line has no end"});
  (void)directory.write("part.geo", "a = 1; b = 2;");
  const auto outer = directory.write("outer.geo", "Include \"part.geo\";\n" + two_blocks);
  expect_refused([&] { (void)read_geometry<2>(outer, 1.); }, {"part.geo:1: the last line"});
}

TEST(GeoFile, IsScaledToMetres) {
  const MeshData<2> mesh = read("geometry.geo", two_blocks, 0.0254);
  double right = 0.;
  for (const auto& vertex : mesh.vertices) right = std::max(right, vertex[0]);
  EXPECT_DOUBLE_EQ(right, 4. * 0.0254);
}

TEST(GeoFile, IsRecombinedAndKnowsItsCircle) {
  const MeshData<2> mesh = read("geometry.geo", "lc = 0.5;" + disc, 1e-3);
  ASSERT_EQ(mesh.circles.size(), 1U);
  EXPECT_NEAR(mesh.circles[0].centre[0], 3e-3, 1e-15);
  EXPECT_NEAR(mesh.circles[0].centre[1], 1e-3, 1e-15);
  EXPECT_NEAR(mesh.circles[0].radius, 2e-3, 1e-15);
  for (const Face<2>& edge : mesh.faces)
    EXPECT_EQ(edge.circle, mesh.surfaces[edge.surface] == "round" ? 0 : -1);
  EXPECT_GT(edges_of(mesh, "round"), 16U);
}

TEST(GeoFile, OfTheOtherKernelWithBooleansKnowsItsCircles) {
  const MeshData<2> mesh = read_geo(R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 4, 4}; Disk(2) = {4, 2, 0, 1};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
MeshSize {:} = 0.5;
Physical Surface("plate") = {3}; Physical Curve("all") = {Boundary{Surface{3};}};)");
  ASSERT_EQ(mesh.circles.size(), 1U);
  EXPECT_NEAR(mesh.circles[0].centre[0], 4., 1e-12);
  EXPECT_NEAR(mesh.circles[0].centre[1], 2., 1e-12);
  EXPECT_NEAR(mesh.circles[0].radius, 1., 1e-12);
  const auto on_circle = [&](unsigned int vertex) {
    const auto& [x, y] = mesh.vertices[vertex];
    return std::abs(std::hypot(x - 4., y - 2.) - 1.) < 1e-9;
  };
  for (const Face<2>& edge : mesh.faces)
    EXPECT_EQ(edge.circle == 0, on_circle(edge.vertices[0]) && on_circle(edge.vertices[1]));
}

TEST(GeoFile, HasNoCircleOnAnEllipseOrASpline) {
  const MeshData<2> mesh = read_geo(R"(lc = 0.3;
Point(1) = {0, 0, 0, lc}; Point(2) = {2, 0, 0, lc}; Point(3) = {0, 1, 0, lc};
Ellipse(1) = {2, 1, 2, 3}; Line(2) = {3, 1}; Line(3) = {1, 2};
Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};
Physical Surface("quarter") = {1}; Physical Curve("edge") = {1};)");
  EXPECT_TRUE(mesh.circles.empty());
}

TEST(GeoFile, RunsLoopsMacrosAndConditionsAsGmshDoes) {
  const MeshData<2> mesh = read_geo(R"(
Macro block
  p = newp; Point(p) = {x, 0, 0}; Point(p + 1) = {x + 1, 0, 0};
  Point(p + 2) = {x + 1, 1, 0}; Point(p + 3) = {x, 1, 0};
  l = newl; Line(l) = {p, p + 1}; Line(l + 1) = {p + 1, p + 2};
  Line(l + 2) = {p + 2, p + 3}; Line(l + 3) = {p + 3, p};
  Curve Loop(l) = {l:l+3}; Plane Surface(l) = {l};
  Transfinite Curve {l:l+3} = 3; Transfinite Surface {l};
  Physical Surface(Sprintf("block %g", i)) = {l};
  If (i == 2)
    Physical Curve("last") = {l + 1};
  EndIf
Return
For i In {0:2}
  x = 2 * i;
  Call block;
EndFor)");
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"block 0", "block 1", "block 2"}));
  EXPECT_EQ(mesh.cells.size(), 12U);
  EXPECT_EQ(edges_of(mesh, "last"), 2U);
}

TEST(GeoFile, MayIncludeAndMergeFilesOfItsDirectory) {
  const CaseDirectory directory;
  (void)directory.write("parts/size.geo", "lc = 0.5;\n");
  (void)directory.write("square.msh", Msh().text());
  const auto included = directory.write("disc.geo", "Include \"parts/size.geo\";\n" + disc);
  EXPECT_EQ(read_geometry<2>(included, 1.).bodies, std::vector<std::string>{"disc"});
  const auto merged = directory.write("merged.geo", "Merge \"square.msh\";\n");
  EXPECT_EQ(read_geometry<2>(merged, 1.).bodies, (std::vector<std::string>{"left", "right"}));
}

TEST(GeoFile, CannotHideACommandWhereGmshTakesUpReadingAfterABranch) {
  const CaseDirectory directory;
  const auto made = directory.path() / "made";
  const auto file = directory.write(
      "geometry.geo", fmt::format("E = 1; lc = 0.5;\nIf (0)\n x = E// EndIf System 'touch {}';\n"
                                  " ;\nEndIf\n{}",
                                  made.string(), disc));
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, {"aborting system call"});
  EXPECT_FALSE(std::filesystem::exists(made));
}

TEST(GeoFile, RunsNothingFromTheOptionFileBesideIt) {
  const CaseDirectory directory;
  const auto made = directory.path() / "made";
  const std::string command = fmt::format("SystemCall 'touch {}';", made.string());
  (void)directory.write("geometry.geo.opt", command);
  (void)directory.write("wheel.msh.opt", command);
  for (const auto& file :
       {directory.write("geometry.geo", two_blocks), directory.write("wheel.msh", Msh().text())})
    expect_refused([&] { (void)read_geometry<2>(file, 1.); }, {"aborting system call"});
  EXPECT_FALSE(std::filesystem::exists(made));
}

TEST(GeoFile, WithACommandThatMayNotBeThereIsRefusedAndNothingRuns) {
  const CaseDirectory directory;
  const auto made = directory.path() / "made";
  const auto file = directory.write(
      "geometry.geo", two_blocks + fmt::format("SystemCall 'touch {}';", made.string()));
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, {file.string() + ":13:", "SystemCall"});
  EXPECT_FALSE(std::filesystem::exists(made));
}

TEST(GeoFile, WithASyntaxErrorIsRefusedWithItsLine) {
  const CaseDirectory directory;
  const auto file =
      directory.write("geometry.geo", "// a comment\n\nPoint(1) = {0, 0, 0};\nLine Loop(1) {1};\n");
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, {file.string() + ":4: syntax error"});
}

TEST(GeoFile, WithAnErrorInAnIncludedFileIsRefusedWithThatLine) {
  const CaseDirectory directory;
  const auto part = directory.write("part.geo", "\n\nPoint(1) = {0, 0};\n");
  const auto file = directory.write("geometry.geo", "Include \"part.geo\";\n");
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, {part.string() + ":3: syntax error"});
}

TEST(GeoFile, CanBeReadAfterOneWithErrors) {
  expect_geo_refused("Point(1) = {0, 0};\nIf (1)\nx = {1, 2;\nEndIf", {});
  expect_geo_refused("Point(1) = 0, 0};", {":1: syntax error"});
  expect_geo_refused("Point(1) = ;\nPoint(2) = ;", {":1: syntax error", ":2: syntax error"});
  EXPECT_EQ(read_geo(two_blocks).cells.size(), 17U);
}

TEST(GeoFile, WithUnknownEntitiesIsRefusedInTheWordsOfGmsh) {
  expect_geo_refused("Point(1) = {0, 0, 0};\nLine(1) = {1, 7};", {"7"});
}

TEST(GeoFile, WithoutPhysicalSurfaceIsRefused) {
  expect_geo_refused("lc = 1;" + disc.substr(0, disc.find("Physical")),
                     {"no physical surface", "Physical Surface(\"name\")"});
}

TEST(GeoFile, WithoutPhysicalCurveIsRefused) {
  expect_geo_refused("lc = 1;" + disc.substr(0, disc.find("Physical Curve")),
                     {"no physical curve", "Physical Curve(\"name\")"});
}

TEST(GeoFile, WithGroupsWithoutNameIsRefused) {
  const std::string shape = "lc = 1;" + disc.substr(0, disc.find("Physical"));
  expect_geo_refused(shape + "Physical Surface(7) = {1}; Physical Curve(\"round\") = {1:4};",
                     {"Physical Surface 7 has no name", "Physical Surface(\"name\", 7)"});
  expect_geo_refused(shape + "Physical Surface(\"disc\") = {1}; Physical Curve(8) = {1:4};",
                     {"Physical Curve 8 has no name"});
}

TEST(GeoFile, WithANameUsedTwiceIsRefused) {
  expect_geo_refused("lc = 1;" + disc + "Physical Curve(\"round\", 99) = {5};",
                     {":10: ", "physical", "already exists"});
}

TEST(GeoFile, WithACurveOfTwoNamesIsRefused) {
  expect_geo_refused("lc = 1;" + disc + "Physical Curve(\"also\") = {2};",
                     {"curve 2", "\"round\"", "\"also\""});
}

TEST(GeoFile, WithABodyInNoGroupIsRefused) {
  const std::size_t at = two_blocks.find("Physical Surface(\"upper\")");
  std::string without = two_blocks;
  without.erase(at, two_blocks.find('\n', at) - at);
  expect_geo_refused(without, {"surface 11", "no physical group"});
}

TEST(GeoFile, WithANamedCurveThatBoundsNothingIsRefused) {
  expect_geo_refused("lc = 1;" + disc +
                         "Point(91) = {8, 8, 0}; Point(92) = {9, 9, 0}; Line(91) = {91, 92};"
                         "Physical Curve(\"stray\") = {91};",
                     {"\"stray\"", "no edge of a body's boundary"});
}

TEST(GeoFile, WithBodiesThatShareEdgesIsRefused) {
  std::string alike = two_blocks;
  alike.replace(alike.find("{11, 13} = 4"), 12, "{11, 13} = 5");
  EXPECT_EQ(read_geo(alike).cells.size(), 20U);
  expect_geo_refused(alike + "Coherence;", {"lower", "upper", "share", "Coherence"});
}

TEST(GeoFile, WithBodiesThatShareAPointGivesEachAVertexOfItsOwn) {
  const MeshData<2> mesh = read_geo(R"(
Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Point(5) = {2, 1, 0}; Point(6) = {2, 2, 0}; Point(7) = {1, 2, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {3, 5}; Line(6) = {5, 6}; Line(7) = {6, 7}; Line(8) = {7, 3};
Curve Loop(1) = {1:4}; Plane Surface(1) = {1};
Curve Loop(2) = {5:8}; Plane Surface(2) = {2};
Transfinite Curve {1:8} = 3; Transfinite Surface {1:2}; Recombine Surface {1:2};
Physical Surface("lower") = {1}; Physical Surface("upper") = {2};
Physical Curve("top") = {3}; Physical Curve("bottom") = {5};
)");
  EXPECT_EQ(mesh.cells.size(), 8U);
  EXPECT_EQ(mesh.vertices.size(), 18U);
  EXPECT_EQ(mesh.faces.size(), 16U);
}

TEST(GeoFile, ThatGmshCannotMeshIsRefusedInItsWords) {
  // made one by Coherence, the common side cannot have both three cells and four
  expect_geo_refused(two_blocks + "Coherence;", {"cannot be meshed", "divisions"});
}

TEST(GeoFile, OutOfThePlaneIsRefused) {
  std::string lifted = two_blocks;
  lifted.replace(lifted.find("{0, 5, 0}"), 9, "{0, 5, 1}");
  expect_geo_refused(lifted, {"z = ", "plane z = 0"});
}

TEST(GeoFile, OfSecondOrderLosesItsMiddleNodes) {
  const MeshData<2> linear = read_geo(two_blocks);
  const MeshData<2> second = read_geo("Mesh.ElementOrder = 2;" + two_blocks);
  EXPECT_EQ(second.cells.size(), linear.cells.size());
  EXPECT_EQ(second.vertices.size(), linear.vertices.size());
}

TEST(GeoFile, OfThirdOrderIsRefused) {
  expect_geo_refused("Mesh.ElementOrder = 3;" + two_blocks, {"order 3", "Mesh.ElementOrder = 1"});
}

TEST(GeoFile, ThatMeshesTrianglesItselfIsDividedAlongItsCircle) {
  for (const int order : {1, 2}) {
    const MeshData<2> mesh =
        read_geo(fmt::format("lc = 1; Mesh.RecombineAll = 0; Mesh.ElementOrder = {};", order) +
                 disc + "Mesh 2;");
    EXPECT_EQ(mesh.cells.size() % 3, 0U);
    EXPECT_EQ(mesh.circles.size(), 1U);
    check(mesh);  // vertices of round faces lie on their circle
  }
}

TEST(GeometryFile, ThatIsMissingIsNamed) {
  expect_refused([] { (void)read_geometry<2>("/nowhere/wheel.geo", 1.); },
                 {"/nowhere/wheel.geo", "no such file"});
  expect_refused([] { (void)read_geometry<2>("/nowhere/wheel.msh", 1.); },
                 {"/nowhere/wheel.msh", "no such file"});
}

TEST(GeometryFile, OfAnotherKindIsRefused) {
  expect_refused([] { (void)read_geometry<2>("/nowhere/wheel.iges", 1.); },
                 {"/nowhere/wheel.iges", ".geo, .msh, .step or .stp"});
}

TEST(GeometryFile, ThatIsADirectoryIsRefused) {
  const CaseDirectory directory;
  std::filesystem::create_directory(directory.path() / "wheel.msh");
  std::filesystem::create_directory(directory.path() / "wheel.geo");
  for (const char* const name : {"wheel.msh", "wheel.geo"})
    expect_refused([&] { (void)read_geometry<2>(directory.path() / name, 1.); },
                   {name, "not a file"});
}

TEST(GeometryFile, WithAUnitOfLengthThatIsNotPositiveIsRefused) {
  for (const double unit : {0., -1., std::nan("")})
    expect_refused([&] { (void)read("wheel.msh", Msh().text(), unit); }, {"unit of length"});
}

TEST(MshFile, OfTwoSquaresIsRead) {
  const MeshData<2> mesh = read("wheel.msh", Msh().text(), 0.001);
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(mesh.surfaces, (std::vector<std::string>{"", "base", "face"}));
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.cells.size(), 2U);
  EXPECT_EQ(mesh.faces.size(), 8U);
  EXPECT_EQ(edges_of(mesh, "base"), 1U);
  EXPECT_EQ(edges_of(mesh, "face"), 1U);
}

TEST(MshFile, HasItsClockwiseCellsTurned) {
  Msh msh;
  msh.elements = "3\n1 1 2 3 1 1 2\n3 3 2 1 1 1 4 3 2\n4 3 2 2 2 5 6 7 8\n";
  msh.names = "3\n2 1 \"left\"\n2 2 \"right\"\n1 3 \"base\"\n";
  EXPECT_NEAR(minimum_scaled_jacobian(read("wheel.msh", msh.text())), 1., 1e-15);
}

TEST(MshFile, IsReadInAllFormatsAlike) {
  const std::string geo = "lc = 0.5;" + disc;
  const MeshData<2> direct = read_geo(geo);
  for (const double version : {2.2, 4.1})
    for (const bool binary : {false, true}) {
      const MeshData<2> mesh = read("wheel.msh", test::saved(geo, version, binary));
      EXPECT_EQ(mesh.cells.size(), direct.cells.size());
      EXPECT_EQ(edges_of(mesh, "round"), edges_of(direct, "round"));
      ASSERT_EQ(mesh.circles.size(), 1U) << version << binary;
      EXPECT_NEAR(mesh.circles[0].centre[0], 3., 1e-12);
      EXPECT_NEAR(mesh.circles[0].radius, 2., 1e-12);
    }
}

TEST(MshFile, HasNoCircleOnAnArcOfFewNodesOrAnEllipse) {
  const MeshData<2> coarse = read("wheel.msh", test::saved("lc = 2;" + disc, 4.1, false));
  ASSERT_LT(edges_of(coarse, "round"), 16U);
  EXPECT_TRUE(coarse.circles.empty());
  const std::string ellipse = R"(lc = 0.2;
Point(1) = {0, 0, 0, lc}; Point(2) = {2, 0, 0, lc}; Point(3) = {0, 1.99, 0, lc};
Ellipse(1) = {2, 1, 2, 3}; Line(2) = {3, 1}; Line(3) = {1, 2};
Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};
Physical Surface("quarter") = {1}; Physical Curve("edge") = {1, 2, 3};)";
  EXPECT_TRUE(read("wheel.msh", test::saved(ellipse, 4.1, false)).circles.empty());
}

TEST(MshFile, CutShortAnywhereIsRefused) {
  for (const std::string& whole :
       {Msh().text(), test::saved(two_blocks, 4.1, false), test::saved(two_blocks, 4.1, true)}) {
    const std::size_t end = whole.find("$EndElements") + std::string("$EndElements").size();
    for (std::size_t length = 0; length < end; length += 37)
      expect_msh_refused(whole.substr(0, length), {});
    expect_msh_refused(whole.substr(0, end - 1), {"cut short", "$EndElements"});
  }
}

TEST(MshFile, ThatIsNoMeshIsRefusedAndNotRun) {
  const CaseDirectory directory;
  const auto made = directory.path() / "made";
  const auto file = directory.write(
      "wheel.msh", fmt::format("SystemCall 'touch {}';\n$MeshFormat\n", made.string()));
  expect_refused([&] { (void)read_geometry<2>(file, 1.); }, {"does not begin with $MeshFormat"});
  EXPECT_FALSE(std::filesystem::exists(made));
}

TEST(MshFile, OfAnUnknownFormatIsRefused) {
  const std::string text = Msh().text();
  const auto with = [&](const std::string& line) {
    return "$MeshFormat\n" + line + text.substr(text.find("\n$EndMeshFormat"));
  };
  expect_msh_refused(with("1 0 8"), {"MSH 1", "2.2 and 4.1"});
  expect_msh_refused(with("4 0 8"), {"MSH 4:", "2.2 and 4.1"});
  expect_msh_refused(with("2.2 0 4"), {"'2.2 0 8'"});
  expect_msh_refused(with("2.2 7 8"), {"'2.2 7 8'"});
}

TEST(MshFile, WithTrianglesIsDivided) {
  Msh msh;
  msh.elements =
      "5\n1 1 2 3 1 1 2\n2 1 2 4 2 8 5\n3 2 2 1 1 1 2 3\n4 2 2 1 1 1 3 4\n5 3 2 2 2 5 6 7 8\n";
  const CaseDirectory directory;
  const MeshData<2> mesh = read_geometry<2>(directory.write("mesh.msh", msh.text()), 1.);
  EXPECT_EQ(mesh.cells.size(), 2U * 3U + 4U);
}

TEST(MshFile, OfSecondOrderLosesItsMiddleNodes) {
  const CaseDirectory directory;
  const std::string second = test::saved("Mesh.ElementOrder = 2;" + two_blocks, 4.1, false);
  EXPECT_EQ(read_geometry<2>(directory.write("mesh.msh", second), 1.).cells.size(), 17U);
}

TEST(MshFile, WithoutNamesIsRefused) {
  Msh msh;
  msh.names = "0\n";
  expect_msh_refused(msh.text(), {"Physical Surface 1 has no name"});
  msh.names = "2\n2 1 \"left\"\n2 2 \"right\"\n";
  expect_msh_refused(msh.text(), {"Physical Curve 3 has no name"});
}

TEST(MshFile, WithANameUsedTwiceIsRefused) {
  Msh msh;
  msh.names = "4\n2 1 \"left\"\n2 2 \"left\"\n1 3 \"base\"\n1 4 \"face\"\n";
  expect_msh_refused(msh.text(), {"\"left\"", "more than one Physical Surface"});
}

TEST(MshFile, MayUseOneNameForABodyAndASurface) {
  Msh msh;
  msh.names = "4\n2 1 \"left\"\n2 2 \"right\"\n1 3 \"left\"\n1 4 \"face\"\n";
  EXPECT_EQ(edges_of(read("wheel.msh", msh.text()), "left"), 1U);
}

TEST(MshFile, WithCellsInNoGroupIsRefused) {
  Msh msh;
  msh.elements = "4\n1 1 2 3 1 1 2\n2 1 2 4 2 8 5\n3 3 2 1 1 1 2 3 4\n4 3 2 0 2 5 6 7 8\n";
  expect_msh_refused(msh.text(), {"surface 2", "no physical group"});
}

TEST(MshFile, WithoutPhysicalSurfaceIsRefused) {
  Msh msh;
  msh.elements = "2\n1 1 2 3 1 1 2\n2 1 2 4 2 8 5\n";
  msh.names = "2\n1 3 \"base\"\n1 4 \"face\"\n";
  expect_msh_refused(msh.text(), {"no physical surface"});
}

TEST(MshFile, WithoutPhysicalCurveIsRefused) {
  Msh msh;
  msh.elements = "2\n3 3 2 1 1 1 2 3 4\n4 3 2 2 2 5 6 7 8\n";
  msh.names = "2\n2 1 \"left\"\n2 2 \"right\"\n";
  expect_msh_refused(msh.text(), {"no physical curve"});
}

TEST(MshFile, WithBodiesThatShareEdgesIsRefused) {
  Msh msh;
  msh.elements = "3\n1 1 2 3 1 1 2\n3 3 2 1 1 1 2 3 4\n4 3 2 2 2 2 6 7 3\n";
  msh.names = "3\n2 1 \"left\"\n2 2 \"right\"\n1 3 \"base\"\n";
  expect_msh_refused(msh.text(), {"left", "right", "share", "its own points"});
}

TEST(MshFile, OutOfThePlaneIsRefused) {
  Msh msh;
  msh.nodes = "8\n1 0 0 0\n2 1 0 0\n3 1 1 0.5\n4 0 1 0\n5 1 0 0\n6 2 0 0\n7 2 1 0\n8 1 1 0\n";
  expect_msh_refused(msh.text(), {"z = 0.5"});
}

TEST(MshFile, WithACellThatIsTurnedOverIsRefused) {
  Msh msh;
  msh.nodes = "8\n1 0 0 0\n2 1 0 0\n3 0.1 0.1 0\n4 0 1 0\n5 1 0 0\n6 2 0 0\n7 2 1 0\n8 1 1 0\n";
  expect_msh_refused(msh.text(), {"left", "scaled Jacobian"});
}

TEST(MshFile, ThatRefersToNodesThatDoNotExistIsRefused) {
  Msh msh;
  msh.elements = "3\n1 1 2 3 1 1 2\n3 3 2 1 1 1 2 3 99\n4 3 2 2 2 5 6 7 8\n";
  expect_msh_refused(msh.text(), {});
}

}  // namespace
}  // namespace geneva::mesh
