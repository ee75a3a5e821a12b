#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "loads/design/johnson.h"
#include "loads/wheel/internal_outline.h"
#include "mesh/gmsh_mesher.h"
#include "mesh/mesh_quality.h"
#include "mesh_measures.h"

namespace geneva::mesh {
namespace {

using loads::InternalDimensions;
using loads::Outline;
using test::area;
using test::edges_by_surface;
using test::has_vertex;

/// Vertices on lines and circles, in units of the radius or length: a few roundings.
constexpr double round_off = 1e-14;

struct RingAndPin {
  InternalDimensions dimensions;
  double pin_distance;
  std::vector<Outline> outlines;
  MeshData mesh;
};

/// @param way of the pin along the driving wall: 0 at the inner rim, 1 farthest from the axis
RingAndPin meshed(const loads::InternalDimensionsInput& input, double way = 0.1) {
  const InternalDimensions d = loads::complete_internal_dimensions(input);
  const double nearest = wall_end(d);
  const double farthest = d.centre_distance + d.crank_radius;
  const double distance = nearest + way * (farthest - nearest);
  std::vector<Outline> outlines{loads::internal_wheel_outline(d),
                                loads::internal_pin_outline(d, distance)};
  MeshData mesh = mesh_outlines(outlines, default_sizing(d, distance));
  return {d, distance, std::move(outlines), std::move(mesh)};
}

loads::InternalDimensionsInput stations(int number, double diameter = 0.1) {
  loads::InternalDimensionsInput input{};
  input.stations = number;
  input.wheel_diameter = diameter;
  return input;
}

/// The wheel of 0.1 m with the pin a tenth of its way out.
const RingAndPin& usual(int number) {
  static std::map<int, RingAndPin> made;  // meshing takes most of the tests' time
  const auto found = made.find(number);
  if (found != made.end()) return found->second;
  return made.emplace(number, meshed(stations(number))).first->second;
}

class EveryInternalWheel : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Stations, EveryInternalWheel, testing::Range(3, 25));

TEST_P(EveryInternalWheel, HasAValidMeshOfGoodCellsForThePinAtBothEndsAndBetween) {
  for (const double way : {0., 0.1, 0.5, 1.}) {
    const MeshData mesh =
        way == 0.1 ? usual(GetParam()).mesh : meshed(stations(GetParam()), way).mesh;
    check(mesh);
    EXPECT_GT(least_scaled_jacobian(mesh), 0.15) << way;
    EXPECT_GT(least_scaled_jacobian_refined(mesh), 0.15) << way;
  }
}

TEST_P(EveryInternalWheel, HasTheAreaOfItsOutlinesWithTheCirclesCountedIn) {
  const RingAndPin& result = usual(GetParam());
  ASSERT_EQ(result.mesh.bodies, (std::vector<std::string>{"wheel", "pin"}));
  for (unsigned int body = 0; body < 2; ++body) {
    const double exact = loads::area_moments(result.outlines[body]).area;
    EXPECT_NEAR(area(result.mesh, body), exact, 1e-12 * exact);
  }
}

TEST_P(EveryInternalWheel, HasAFewHundredCells) {
  const std::size_t cells = usual(GetParam()).mesh.quads.size();
  EXPECT_GE(cells, 150U);
  EXPECT_LE(cells, GetParam() <= 8 ? 600U : 1300U);
}

TEST_P(EveryInternalWheel, HasAllNamedSurfacesAndNoNamelessBoundary) {
  const auto edges = edges_by_surface(usual(GetParam()).mesh);
  for (const char* const name : {"driving wall", "opposite wall", "slots", "locking arcs",
                                 "inner rim", "rim", "pin", "pin core"})
    EXPECT_GT(edges.count(name), 0U) << name;
  EXPECT_EQ(edges.size(), 8U);
}

TEST_P(EveryInternalWheel, HasEnoughEdgesOnItsArcs) {
  const int n = GetParam();
  const auto edges = edges_by_surface(usual(n).mesh);
  EXPECT_GE(edges.at("locking arcs"), 6 * n);         // each half is more than a quarter turn
  EXPECT_GE(edges.at("slots"), 4 * n + 2 * (n - 1));  // two per quarter arc, one per wall
  EXPECT_GE(edges.at("pin"), 16);
  EXPECT_GE(edges.at("rim"), 8);
}

TEST(InternalOutlineMesh, HasThePointOfContactAsAVertexOfThePinOnly) {
  const RingAndPin& result = usual(4);
  const loads::Point contact = result.outlines[1].loops[0][0].start;
  EXPECT_TRUE(has_vertex(result.mesh, 1, {contact.x, contact.y}));
  std::set<unsigned int> of_wheel;
  for (const Quad& quad : result.mesh.quads)
    if (quad.body == 0) of_wheel.insert(quad.vertices.begin(), quad.vertices.end());
  for (const Quad& quad : result.mesh.quads) {
    if (quad.body != 1) continue;
    for (const unsigned int vertex : quad.vertices) EXPECT_EQ(of_wheel.count(vertex), 0U);
  }
}

TEST(InternalOutlineMesh, HasItsBoundaryOnTheCirclesOfTheOutlineToRoundOff) {
  const RingAndPin& result = usual(4);
  const InternalDimensions& d = result.dimensions;
  const std::map<std::string, double> radius{{"locking arcs", d.locking_radius},
                                             {"inner rim", d.wheel_diameter / 2.},
                                             {"rim", d.rim_radius},
                                             {"pin", d.pin_diameter / 2.},
                                             {"pin core", d.pin_core_radius}};
  for (const Edge& edge : result.mesh.edges) {
    const std::string& name = result.mesh.surfaces[edge.surface];
    if (radius.count(name) == 0) continue;
    ASSERT_GE(edge.circle, 0) << name;
    const Circle& circle = result.mesh.circles[static_cast<std::size_t>(edge.circle)];
    EXPECT_NEAR(circle.radius, radius.at(name), round_off * d.rim_radius) << name;
    for (const unsigned int vertex : edge.vertices) {
      const auto& [x, y] = result.mesh.vertices[vertex];
      EXPECT_NEAR(std::hypot(x - circle.centre[0], y - circle.centre[1]), circle.radius,
                  round_off * d.rim_radius);
    }
  }
}

TEST(InternalOutlineMesh, ListsEveryCircleOnce) {
  // both rims, pin and core, and a bottom and a locking arc per station
  EXPECT_EQ(usual(4).mesh.circles.size(), 4U + 2U * 4U);
}

TEST(InternalOutlineMesh, IsFineOnTheDrivingWallAtTheContact) {
  for (const int n : {3, 4, 6, 12, 24}) {
    const RingAndPin result = meshed(stations(n), 0.4);
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

TEST(InternalOutlineMesh, DoesNotDependOnTheUnitOfLength) {
  for (const int n : {4, 13}) {
    const MeshData& metres = usual(n).mesh;
    for (const double factor : {0.0254, 1000.}) {
      const MeshData scaled = meshed(stations(n, 0.1 * factor)).mesh;
      ASSERT_EQ(scaled.vertices.size(), metres.vertices.size());
      ASSERT_EQ(scaled.quads.size(), metres.quads.size());
      for (std::size_t i = 0; i < metres.quads.size(); ++i)
        EXPECT_EQ(scaled.quads[i].vertices, metres.quads[i].vertices);
    }
  }
}

TEST(InternalOutlineMesh, CopesWithAThinWebOverTheSlotsAndDeepSlots) {
  loads::InternalDimensionsInput input = stations(6);
  input.slot_depth = 0.05;   // 35.8 mm would do
  input.rim_radius = 0.103;  // the web is 3 mm
  EXPECT_GT(least_scaled_jacobian_refined(meshed(input).mesh), 0.15);
}

}  // namespace
}  // namespace geneva::mesh
