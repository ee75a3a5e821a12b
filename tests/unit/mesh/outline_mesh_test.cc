#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "loads/design/johnson.h"
#include "loads/pi.h"
#include "loads/wheel/outline.h"
#include "mesh/gmsh_mesher.h"
#include "mesh/mesh_quality.h"
#include "mesh_measures.h"
#include "tests/support/refusal.h"

namespace geneva::mesh {
namespace {

using loads::GenevaDimensions;
using loads::Outline;
using loads::Point;
using loads::Segment;
using loads::test::expect_refused;
using test::area;
using test::edges_by_surface;
using test::has_vertex;

/// Vertices on lines and circles, in units of the radius or length: a few roundings.
constexpr double round_off = 1e-14;

struct WheelAndPin {
  GenevaDimensions dimensions;
  double pin_distance;
  std::vector<Outline> outlines;
  MeshData mesh;
};

/// @param way of the pin along the driving wall: 0 nearest to the wheel's axis, 1 at the rim
WheelAndPin meshed(const loads::GenevaDimensionsInput& input, double way = 0.1) {
  const GenevaDimensions d = loads::complete_dimensions(input);
  const double nearest = d.centre_distance - d.crank_radius;
  const double farthest = std::sqrt(std::pow(d.wheel_diameter, 2) - std::pow(d.slot_width, 2)) / 2.;
  const double distance = nearest + way * (farthest - nearest);
  std::vector<Outline> outlines{loads::wheel_outline(d), loads::pin_outline(d, distance)};
  MeshData mesh = mesh_outlines(outlines, default_sizing(d, distance));
  return {d, distance, std::move(outlines), std::move(mesh)};
}

loads::GenevaDimensionsInput stations(int number, double diameter = 0.1) {
  loads::GenevaDimensionsInput input{};
  input.stations = number;
  input.wheel_diameter = diameter;
  return input;
}

/// The wheel of 0.1 m with the pin a tenth of its way out.
const WheelAndPin& usual(int number) {
  static std::map<int, WheelAndPin> made;  // meshing takes most of the tests' time
  const auto found = made.find(number);
  if (found != made.end()) return found->second;
  return made.emplace(number, meshed(stations(number))).first->second;
}

class EveryWheel : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Stations, EveryWheel, testing::Range(3, 25));

TEST_P(EveryWheel, HasAValidMeshOfGoodCellsForThePinAtBothEndsAndBetween) {
  for (const double way : {0., 0.1, 0.5, 1.}) {
    const MeshData mesh =
        way == 0.1 ? usual(GetParam()).mesh : meshed(stations(GetParam()), way).mesh;
    check(mesh);
    EXPECT_GT(least_scaled_jacobian(mesh), 0.15) << way;
    EXPECT_GT(least_scaled_jacobian_refined(mesh), 0.15) << way;
  }
}

TEST_P(EveryWheel, HasTheAreaOfItsOutlinesWithTheCirclesCountedIn) {
  const WheelAndPin& result = usual(GetParam());
  ASSERT_EQ(result.mesh.bodies, (std::vector<std::string>{"wheel", "pin"}));
  for (unsigned int body = 0; body < 2; ++body) {
    const double exact = loads::area_moments(result.outlines[body]).area;
    EXPECT_NEAR(area(result.mesh, body), exact, 1e-12 * exact);
  }
}

TEST_P(EveryWheel, HasAFewHundredCells) {
  const std::size_t cells = usual(GetParam()).mesh.quads.size();
  EXPECT_GE(cells, 150U);
  EXPECT_LE(cells, GetParam() <= 8 ? 400U : 1300U);
}

TEST_P(EveryWheel, HasAllNamedSurfacesAndNoNamelessBoundary) {
  const auto edges = edges_by_surface(usual(GetParam()).mesh);
  for (const char* const name :
       {"driving wall", "opposite wall", "slots", "locking arcs", "rim", "bore", "pin", "pin core"})
    EXPECT_GT(edges.count(name), 0U) << name;
  EXPECT_EQ(edges.count(""), 0U);
}

TEST_P(EveryWheel, HasEnoughEdgesOnItsArcs) {
  const int n = GetParam();
  const auto edges = edges_by_surface(usual(n).mesh);
  EXPECT_GE(edges.at("locking arcs"), 2 * n);
  EXPECT_GE(edges.at("slots"), 4 * n + 2 * (n - 1));  // two per quarter arc, one per wall
  EXPECT_GE(edges.at("pin"), 16);
  EXPECT_GE(edges.at("bore"), 8);
}

TEST(OutlineMesh, OfFourStationsHasTwoToFourHundredCells) {
  const std::size_t cells = usual(4).mesh.quads.size();
  EXPECT_GE(cells, 200U);
  EXPECT_LE(cells, 400U);
}

TEST(OutlineMesh, HasNoVertexOfBothBodiesThoughTheyTouch) {
  // without clearance the pin in its nearest place touches both walls and the bottom of the slot
  const MeshData mesh = meshed(stations(6), 0.).mesh;
  std::set<unsigned int> of_wheel;
  std::set<unsigned int> of_pin;
  for (const Quad& quad : mesh.quads)
    (quad.body == 0 ? of_wheel : of_pin).insert(quad.vertices.begin(), quad.vertices.end());
  for (const unsigned int vertex : of_pin) EXPECT_EQ(of_wheel.count(vertex), 0U);
}

TEST(OutlineMesh, HasThePointOfContactAsAVertexOfThePin) {
  const WheelAndPin& result = usual(4);
  const std::array<double, 2> contact{result.outlines[1].loops[0][0].start.x,
                                      result.outlines[1].loops[0][0].start.y};
  EXPECT_NEAR(contact[0], result.pin_distance, 1e-15);
  EXPECT_NEAR(contact[1], result.dimensions.slot_width / 2., 1e-15);
  EXPECT_TRUE(has_vertex(result.mesh, 1, contact));
}

TEST(OutlineMesh, HasEveryVertexOfTheOutlineExactly) {
  const WheelAndPin& result = usual(5);
  const std::set<std::array<double, 2>> vertices(result.mesh.vertices.begin(),
                                                 result.mesh.vertices.end());
  for (const Outline& outline : result.outlines)
    for (const loads::Loop& loop : outline.loops)
      for (const Segment& segment : loop)
        EXPECT_EQ(vertices.count({segment.start.x, segment.start.y}), 1U);
}

TEST(OutlineMesh, HasItsBoundaryOnTheCirclesOfTheOutlineToRoundOff) {
  const WheelAndPin& result = usual(4);
  const GenevaDimensions& d = result.dimensions;
  const std::map<std::string, double> radius{{"locking arcs", d.locking_radius},
                                             {"rim", d.wheel_diameter / 2.},
                                             {"bore", d.bore_radius},
                                             {"pin", d.pin_diameter / 2.},
                                             {"pin core", d.pin_core_radius}};
  for (const Edge& edge : result.mesh.edges) {
    const std::string& name = result.mesh.surfaces[edge.surface];
    if (radius.count(name) == 0) continue;
    ASSERT_GE(edge.circle, 0) << name;
    const Circle& circle = result.mesh.circles[static_cast<std::size_t>(edge.circle)];
    EXPECT_NEAR(circle.radius, radius.at(name), round_off * d.wheel_diameter) << name;
    for (const unsigned int vertex : edge.vertices) {
      const auto& [x, y] = result.mesh.vertices[vertex];
      EXPECT_NEAR(std::hypot(x - circle.centre[0], y - circle.centre[1]), circle.radius,
                  round_off * d.wheel_diameter);
    }
  }
}

TEST(OutlineMesh, ListsEveryCircleOnce) {
  // rim, bore, pin and core, and a bottom and a locking arc per station
  EXPECT_EQ(usual(4).mesh.circles.size(), 4U + 2U * 4U);
}

TEST(OutlineMesh, KeepsTheDrivingWallStraight) {
  const WheelAndPin& result = usual(4);
  for (const Edge& edge : result.mesh.edges) {
    if (result.mesh.surfaces[edge.surface] != "driving wall") continue;
    EXPECT_EQ(edge.circle, -1);
    for (const unsigned int vertex : edge.vertices)
      EXPECT_NEAR(result.mesh.vertices[vertex][1], result.dimensions.slot_width / 2.,
                  round_off * result.dimensions.wheel_diameter);
  }
}

TEST(OutlineMesh, IsFineOnTheDrivingWallAtTheContact) {
  for (const int n : {3, 4, 6, 12, 24}) {
    const WheelAndPin result = meshed(stations(n), 0.4);
    for (const Edge& edge : result.mesh.edges) {
      if (result.mesh.surfaces[edge.surface] != "driving wall") continue;
      const double a = result.mesh.vertices[edge.vertices[0]][0];
      const double b = result.mesh.vertices[edge.vertices[1]][0];
      if (std::min(a, b) > result.pin_distance || std::max(a, b) < result.pin_distance) continue;
      EXPECT_LT(std::abs(a - b), result.dimensions.pin_diameter / 5.) << n;
      EXPECT_GT(std::abs(a - b), result.dimensions.pin_diameter / 15.) << n;
    }
  }
}

TEST(OutlineMesh, MakesARingOfLayersOfThePin) {
  const WheelAndPin& result = usual(4);
  const auto edges = edges_by_surface(result.mesh);
  const int around = edges.at("pin");
  EXPECT_EQ(edges.at("pin core"), around);
  EXPECT_LE(around, 32);
  const GenevaDimensions& d = result.dimensions;
  const double middle = (d.slot_width - d.pin_diameter) / 2.;
  int cells = 0;
  for (const Quad& quad : result.mesh.quads) {
    if (quad.body != 1) continue;
    ++cells;
    EXPECT_GT(scaled_jacobian(corners(result.mesh, quad)), 0.98);
    for (const unsigned int vertex : quad.vertices) {
      const auto& [x, y] = result.mesh.vertices[vertex];
      const double layer = (std::hypot(x - result.pin_distance, y - middle) - d.pin_core_radius) /
                           (d.pin_diameter / 2. - d.pin_core_radius) * 2.;
      EXPECT_NEAR(layer, std::round(layer), 0.02);
    }
  }
  EXPECT_EQ(cells, 2 * around);
}

TEST(OutlineMesh, DoesNotDependOnTheUnitOfLength) {
  for (const int n : {4, 7, 13}) {
    const MeshData& metres = usual(n).mesh;
    for (const double factor : {0.0254, 1000., 1. / 3.}) {
      const MeshData scaled = meshed(stations(n, 0.1 * factor)).mesh;
      ASSERT_EQ(scaled.vertices.size(), metres.vertices.size());
      ASSERT_EQ(scaled.quads.size(), metres.quads.size());
      for (std::size_t i = 0; i < metres.quads.size(); ++i)
        EXPECT_EQ(scaled.quads[i].vertices, metres.quads[i].vertices);
      for (std::size_t i = 0; i < metres.vertices.size(); ++i)
        for (std::size_t k = 0; k < 2; ++k)
          EXPECT_NEAR(scaled.vertices[i][k], factor * metres.vertices[i][k], 1e-12 * 0.1 * factor);
    }
  }
}

TEST(OutlineMesh, IsTheSameEveryTime) {
  const MeshData& once = usual(9).mesh;
  const MeshData again = meshed(stations(9)).mesh;
  EXPECT_EQ(once.vertices, again.vertices);
}

TEST(OutlineMesh, CopesWithAThinWebBetweenSlotsAndBore) {
  loads::GenevaDimensionsInput input = stations(4);
  input.pin_diameter = 0.0186;
  input.slot_width = 0.0192;
  input.bore_radius = 0.0095;  // the web is 1.6 mm
  const WheelAndPin result = meshed(input);
  EXPECT_GT(least_scaled_jacobian_refined(result.mesh), 0.15);
}

TEST(OutlineMesh, CopesWithAPinMuchThinnerThanItsSlotAndALargeCore) {
  loads::GenevaDimensionsInput input = stations(6);
  input.pin_diameter = 0.002;
  input.slot_width = 0.014;
  input.pin_core_radius = 0.0009;
  EXPECT_GT(least_scaled_jacobian_refined(meshed(input).mesh), 0.15);
}

Segment line(Point start, Point end) { return {start, end, false, {0., 0.}, false, "side"}; }

Outline square(double side) {
  return {"square",
          {{line({0., 0.}, {side, 0.}), line({side, 0.}, {side, side}),
            line({side, side}, {0., side}), line({0., side}, {0., 0.})}}};
}

TEST(OutlineMesh, OfASquareIsMadeOfSquares) {
  const MeshData mesh = mesh_outlines({square(1.)}, {0.25, 0.25, {0., 0.}, 1.});
  EXPECT_EQ(mesh.edges.size(), 16U);
  EXPECT_NEAR(area(mesh, 0), 1., 1e-12);
  EXPECT_TRUE(mesh.circles.empty());
}

TEST(OutlineMesh, RefusesSizesThatAreNotPositive) {
  for (const MeshSizing& sizing :
       {MeshSizing{0.1, 0., {0., 0.}, 1.}, MeshSizing{-0.1, 0.1, {0., 0.}, 1.},
        MeshSizing{0.1, 0.2, {0., 0.}, 1.}, MeshSizing{0.1, 0.1, {0., 0.}, 0.},
        MeshSizing{std::nan(""), 0.1, {0., 0.}, 1.}})
    expect_refused([&] { (void)mesh_outlines({square(1.)}, sizing); }, {"cell sizes"});
}

TEST(OutlineMesh, RefusesAnOpenOutline) {
  Outline open = square(1.);
  open.loops[0][2].end = {0.1, 1.};
  expect_refused(
      [&] {
        (void)mesh_outlines({open}, {0.25, 0.25, {0., 0.}, 1.});
      },
      {"square", "open", "(0.1, 1)"});
}

}  // namespace
}  // namespace geneva::mesh
