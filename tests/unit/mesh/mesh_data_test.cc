#include "mesh/mesh_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/mesh_quality.h"
#include "tests/support/refusal.h"

namespace geneva::mesh {
namespace {

using loads::test::expect_refused;

/// Two squares beside each other that touch without a common vertex: "left" of two cells, "right"
/// of one.
MeshData<2> two_bodies() {
  MeshData<2> mesh;
  mesh.vertices = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}, {1., 2.},
                   {0., 2.}, {1., 0.}, {2., 0.}, {2., 1.}, {1., 1.}};
  mesh.cells = {{{0, 1, 2, 3}, 0}, {{3, 2, 4, 5}, 0}, {{6, 7, 8, 9}, 1}};
  mesh.bodies = {"left", "right"};
  mesh.surfaces = {"", "base"};
  mesh.faces = {{{0, 1}, 1, -1}, {{1, 2}, 0, -1}, {{2, 4}, 0, -1}, {{4, 5}, 0, -1},
                {{5, 3}, 0, -1}, {{3, 0}, 0, -1}, {{6, 7}, 1, -1}, {{7, 8}, 0, -1},
                {{8, 9}, 0, -1}, {{9, 6}, 0, -1}};
  return mesh;
}

TEST(ScaledJacobian, IsOneForARectangle) {
  EXPECT_DOUBLE_EQ(scaled_jacobian({{{0., 0.}, {3., 0.}, {3., 1.}, {0., 1.}}}), 1.);
}

TEST(ScaledJacobian, IsTheSineOfTheAngleOfARhombus) {
  const double angle = 0.4;
  const double x = std::cos(angle);
  const double y = std::sin(angle);
  EXPECT_NEAR(scaled_jacobian({{{0., 0.}, {1., 0.}, {1. + x, y}, {x, y}}}), std::sin(angle), 1e-15);
}

TEST(ScaledJacobian, IsNegativeForACellThatIsClockwiseOrNotConvex) {
  EXPECT_LT(scaled_jacobian({{{0., 0.}, {0., 1.}, {1., 1.}, {1., 0.}}}), 0.);
  EXPECT_LT(scaled_jacobian({{{0., 0.}, {1., 0.}, {0.2, 0.2}, {0., 1.}}}), 0.);
}

TEST(ScaledJacobian, IsZeroWhereTwoVerticesCoincide) {
  EXPECT_EQ(scaled_jacobian({{{0., 0.}, {1., 0.}, {1., 0.}, {0., 1.}}}), 0.);
}

TEST(ScaledJacobian, AfterRefinementSeesTheBentEdge) {
  MeshData<2> mesh = two_bodies();
  EXPECT_NEAR(minimum_scaled_jacobian_refined(mesh), 1., 1e-15);
  mesh.circles = {{{0.5, 0.5}, std::sqrt(0.5)}};
  mesh.faces[0].circle = 0;
  EXPECT_LT(minimum_scaled_jacobian_refined(mesh), 0.99);
  EXPECT_DOUBLE_EQ(minimum_scaled_jacobian(mesh), 1.);
}

TEST(MeshCheck, AcceptsBodiesThatTouchWithoutSharingVertices) { check(two_bodies()); }

TEST(MeshCheck, RefusesAVertexOfTwoBodies) {
  MeshData<2> mesh = two_bodies();
  mesh.cells[2].vertices = {1, 7, 8, 2};
  expect_refused([&] { check(mesh); }, {"left", "right", "(1, 0)", "its own points"});
}

TEST(MeshCheck, RefusesAClockwiseCell) {
  MeshData<2> mesh = two_bodies();
  mesh.cells[2].vertices = {6, 9, 8, 7};
  expect_refused([&] { check(mesh); }, {"cell 2", "right", "(1, 0)", "turned over", "-1"});
}

TEST(MeshCheck, RefusesAFlatCell) {
  MeshData<2> mesh = two_bodies();
  mesh.vertices[8] = {1.505, 0.5};
  expect_refused([&] { check(mesh); }, {"cell 2", "smaller cells"});
}

TEST(MeshCheck, RefusesAVertexThatNoCellUses) {
  MeshData<2> mesh = two_bodies();
  mesh.vertices.push_back({7., 8.});
  expect_refused([&] { check(mesh); }, {"vertex 10", "(7, 8)", "no cell"});
}

TEST(MeshCheck, RefusesABodyWithoutCells) {
  MeshData<2> mesh = two_bodies();
  mesh.bodies.emplace_back("third");
  expect_refused([&] { check(mesh); }, {"third", "no cells"});
}

TEST(MeshCheck, RefusesABoundaryEdgeThatIsNotListed) {
  MeshData<2> mesh = two_bodies();
  mesh.faces.pop_back();
  expect_refused([&] { check(mesh); }, {"not listed", "(1, 0)", "(1, 1)"});
}

TEST(MeshCheck, RefusesAnEdgeThatIsListedTwice) {
  MeshData<2> mesh = two_bodies();
  mesh.faces.push_back({{1, 0}, 0, -1});
  expect_refused([&] { check(mesh); }, {"twice", "(0, 0)", "(1, 0)"});
}

TEST(MeshCheck, RefusesAnEdgeInsideOfABody) {
  MeshData<2> mesh = two_bodies();
  mesh.faces.push_back({{2, 3}, 0, -1});
  expect_refused([&] { check(mesh); }, {"inside a body"});
}

TEST(MeshCheck, RefusesAnEdgeThatIsNoSideOfACell) {
  MeshData<2> mesh = two_bodies();
  mesh.faces.push_back({{0, 2}, 0, -1});
  expect_refused([&] { check(mesh); }, {"no side of a cell"});
}

TEST(MeshCheck, RefusesThreeCellsAtASide) {
  MeshData<2> mesh = two_bodies();
  mesh.cells.push_back(mesh.cells[0]);
  mesh.cells.push_back(mesh.cells[0]);
  expect_refused([&] { check(mesh); }, {"cells meet", "at most two"});
}

TEST(MeshCheck, RefusesAVertexOffTheCircleOfItsEdge) {
  MeshData<2> mesh = two_bodies();
  mesh.circles = {{{0., 0.}, 1.}};
  mesh.faces[2].circle = 0;
  expect_refused([&] { check(mesh); }, {"off the circle"});
}

TEST(MeshCheck, RefusesIndicesThatPointNowhere) {
  const auto refuses = [](auto change, const std::string& word) {
    MeshData<2> mesh = two_bodies();
    change(mesh);
    expect_refused([&] { check(mesh); }, {word, "of"});
  };
  refuses([](MeshData<2>& mesh) { mesh.cells[0].body = 2; }, "body 2");
  refuses([](MeshData<2>& mesh) { mesh.faces[0].surface = 5; }, "surface 5");
  refuses([](MeshData<2>& mesh) { mesh.faces[0].circle = 0; }, "circle 0");
  MeshData<2> mesh = two_bodies();
  mesh.cells[1].vertices[0] = 99;
  expect_refused([&] { check(mesh); }, {"cell 1", "beyond"});
}

TEST(MeshCheck, RefusesCoordinatesThatAreNotFinite) {
  MeshData<2> mesh = two_bodies();
  mesh.vertices[3][1] = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { check(mesh); }, {"vertex 3", "finite"});
}

TEST(MeshCheck, RefusesSurfacesThatDoNotBeginWithTheNamelessOne) {
  MeshData<2> mesh = two_bodies();
  mesh.surfaces = {"base", "other"};
  expect_refused([&] { check(mesh); }, {"first surface"});
}

/// A brick of edges 1, 2 and 3.
MeshData<3> brick() {
  MeshData<3> mesh;
  for (const double z : {0., 3.})
    for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 2.}, {0., 2.}})
      mesh.vertices.push_back({x, y, z});
  mesh.cells = {{{0, 1, 2, 3, 4, 5, 6, 7}, 0}};
  for (const auto& side : sides(mesh.cells[0])) mesh.faces.push_back({side, 0, -1});
  mesh.bodies = {"brick"};
  mesh.surfaces = {""};
  return mesh;
}

TEST(MeshCheckInSpace, AcceptsABrickAndKnowsItsShape) {
  const MeshData<3> mesh = brick();
  EXPECT_NO_THROW(check(mesh));
  EXPECT_DOUBLE_EQ(scaled_jacobian(mesh, mesh.cells[0]), 1.);
}

TEST(MeshCheckInSpace, ASlantedBrickHasTheSineOfItsAngle) {
  MeshData<3> mesh = brick();
  for (std::size_t i = 4; i < 8; ++i) mesh.vertices[i][0] += 3.;
  EXPECT_NEAR(scaled_jacobian(mesh, mesh.cells[0]), std::sqrt(0.5), 1e-15);
}

TEST(MeshCheckInSpace, TheSidesOfABrickLookOutwards) {
  const MeshData<3> mesh = brick();
  for (const Face<3>& face : mesh.faces) {
    const auto& a = mesh.vertices[face.vertices[0]];
    const auto& b = mesh.vertices[face.vertices[1]];
    const auto& d = mesh.vertices[face.vertices[3]];
    double outwards = 0.;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const double normal = (b[j] - a[j]) * (d[k] - a[k]) - (b[k] - a[k]) * (d[j] - a[j]);
      outwards += normal * (a[i] - std::array<double, 3>{0.5, 1., 1.5}[i]);
    }
    EXPECT_GT(outwards, 0.);
  }
}

TEST(MeshCheckInSpace, RefusesWhatASolverCannotUse) {
  const auto refuses = [](auto change, const std::string& word) {
    MeshData<3> mesh = brick();
    change(mesh);
    expect_refused([&] { check(mesh); }, {word});
  };
  refuses([](MeshData<3>& mesh) { std::swap(mesh.vertices[0], mesh.vertices[4]); }, "turned over");
  refuses([](MeshData<3>& mesh) { mesh.faces.pop_back(); }, "is not listed");
  refuses([](MeshData<3>& mesh) { mesh.faces.push_back(mesh.faces[0]); }, "listed twice");
  refuses([](MeshData<3>& mesh) { mesh.faces[0].vertices[0] = 6; }, "is no side of a cell");
  refuses([](MeshData<3>& mesh) { mesh.vertices.push_back({9., 9., 9.}); }, "belongs to no cell");
  refuses(
      [](MeshData<3>& mesh) {
        mesh.circles = {{{0., 0., 0.}, 1., {0., 0., 0.}}};
        mesh.faces[0].circle = 0;
      },
      "off the circle of its face");
}

TEST(MeshCheckInSpace, RefusesASlitBetweenCellsThatShareThreeOfFourVertices) {
  MeshData<3> mesh = brick();
  mesh.vertices.push_back({0., 2., 3.5});  // opposite vertex 7, which it leaves
  for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 2.}, {0., 2.}})
    mesh.vertices.push_back({x, y, 6.});
  mesh.cells.push_back({{4, 5, 6, 8, 9, 10, 11, 12}, 0});
  for (const auto& side : sides(mesh.cells[1])) mesh.faces.push_back({side, 0, -1});
  expect_refused([&] { check(mesh); }, {"three vertices in common"});
}

TEST(MeshCheck, RefusesSquaresThatHangTogetherInAVertex) {
  MeshData<2> mesh = two_bodies();
  mesh.cells[2] = {{4, 7, 8, 9}, 0};
  mesh.vertices[7] = {3., 2.};
  mesh.vertices[8] = {3., 3.};
  mesh.vertices[9] = {1., 3.};
  mesh.vertices.erase(mesh.vertices.begin() + 6);
  mesh.cells[2].vertices = {4, 6, 7, 8};
  mesh.bodies.pop_back();
  mesh.faces.resize(6);
  for (const auto& side : sides(mesh.cells[2])) mesh.faces.push_back({side, 0, -1});
  expect_refused([&] { check(mesh); }, {"have no common edge there"});
}

TEST(MeshCheck, RefusesCellsOnTheSameSideOfTheirEdge) {
  MeshData<2> mesh = two_bodies();
  mesh.vertices[4] = {1., 0.5};
  mesh.vertices[5] = {0., 0.5};
  mesh.cells[1] = {{3, 5, 4, 2}, 0};
  expect_refused([&] { check(mesh); }, {"lie on the same side of it"});
}

TEST(MeshCheckInSpace, RefusesBricksThatHangTogetherInAnEdge) {
  MeshData<3> mesh = brick();
  const std::size_t first = mesh.vertices.size();
  for (const double z : {mesh.vertices[2][2], mesh.vertices[6][2]})
    for (const auto& [x, y] : {std::pair{2., 2.}, {2., 4.}, {1., 4.}})
      mesh.vertices.push_back({x, y, z});
  const auto at = [&](const std::size_t i) { return static_cast<unsigned int>(first + i); };
  mesh.cells.push_back({{2, at(0), at(1), at(2), 6, at(3), at(4), at(5)}, 0});
  for (const auto& side : sides(mesh.cells[1])) mesh.faces.push_back({side, 0, -1});
  expect_refused([&] { check(mesh); }, {"have no common face there"});
}

}  // namespace
}  // namespace geneva::mesh
