#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include "drawn_wheels.h"
#include "mesh/mesh_quality.h"
#include "mesh_measures.h"

namespace geneva::mesh {
namespace {

using test::area;
using test::DrawnWheel;
using test::edges_by_surface;
using test::meshed;
using test::usual;
using test::WheelType;

/// Vertices on lines and circles, in units of the radius or length: a few roundings.
constexpr double round_off = 1e-14;
constexpr double diameter = 0.1;

std::string name_of(const WheelType type) {
  return type == WheelType::external ? "External" : "Internal";
}

class EveryWheel : public testing::TestWithParam<std::tuple<WheelType, int>> {
 protected:
  [[nodiscard]] WheelType type() const { return std::get<0>(GetParam()); }
  [[nodiscard]] int stations() const { return std::get<1>(GetParam()); }
  [[nodiscard]] const DrawnWheel& wheel() const { return usual(type(), stations()); }
};
INSTANTIATE_TEST_SUITE_P(Stations, EveryWheel,
                         testing::Combine(testing::Values(WheelType::external, WheelType::internal),
                                          testing::Range(3, 25)),
                         [](const auto& wheel) {
                           return name_of(std::get<0>(wheel.param)) +
                                  std::to_string(std::get<1>(wheel.param));
                         });

TEST_P(EveryWheel, HasAValidMeshOfGoodCellsForThePinAtBothEndsAndBetween) {
  for (const double way : {0., 0.1, 0.5, 1.}) {
    const MeshData<2> mesh =
        way == 0.1 ? wheel().mesh : meshed(type(), stations(), diameter, way).mesh;
    check(mesh);
    EXPECT_GT(minimum_scaled_jacobian(mesh), 0.15) << way;
    EXPECT_GT(minimum_scaled_jacobian_refined(mesh), 0.15) << way;
  }
}

TEST_P(EveryWheel, HasTheAreaOfItsOutlinesWithTheCirclesCountedIn) {
  ASSERT_EQ(wheel().mesh.bodies, (std::vector<std::string>{"wheel", "pin"}));
  for (unsigned int body = 0; body < 2; ++body) {
    const double exact = loads::area_moments(wheel().outlines[body]).area;
    EXPECT_NEAR(area(wheel().mesh, body), exact, 1e-12 * exact);
  }
}

TEST_P(EveryWheel, HasAFewHundredCells) {
  const std::size_t cells = wheel().mesh.cells.size();
  const std::size_t most_for_few_stations = type() == WheelType::external ? 400 : 600;
  EXPECT_GE(cells, 150U);
  EXPECT_LE(cells, stations() <= 8 ? most_for_few_stations : 1300U);
}

TEST_P(EveryWheel, HasAllNamedSurfacesAndNoNamelessBoundary) {
  const auto edges = edges_by_surface(wheel().mesh);
  for (const char* const name :
       {"driving wall", "opposite wall", "slots", "locking arcs", "rim",
        type() == WheelType::external ? "bore" : "inner rim", "pin", "pin core"})
    EXPECT_GT(edges.count(name), 0U) << name;
  EXPECT_EQ(edges.size(), 8U);
}

TEST_P(EveryWheel, HasEnoughEdgesOnItsArcs) {
  const int n = stations();
  const auto edges = edges_by_surface(wheel().mesh);
  // each half of an internal wheel's locking arc is more than a quarter turn
  EXPECT_GE(edges.at("locking arcs"), (type() == WheelType::external ? 2 : 6) * n);
  EXPECT_GE(edges.at("slots"), 6 * (n - 1));  // two per quarter arc, one per wall
  EXPECT_GE(edges.at("driving wall"), 5);
  EXPECT_GE(edges.at("pin"), 16);
  EXPECT_GE(edges.at(type() == WheelType::external ? "bore" : "rim"), 8);
}

class BothWheels : public testing::TestWithParam<WheelType> {};
INSTANTIATE_TEST_SUITE_P(Types, BothWheels,
                         testing::Values(WheelType::external, WheelType::internal),
                         [](const auto& wheel) { return name_of(wheel.param); });

TEST_P(BothWheels, HaveThePointOfContactAsAVertexOfThePin) {
  const DrawnWheel& wheel = usual(GetParam(), 4);
  const std::array<double, 2> contact{wheel.outlines[1].loops[0][0].start.x,
                                      wheel.outlines[1].loops[0][0].start.y};
  EXPECT_NEAR(contact[0], wheel.pin_distance, 1e-15);
  EXPECT_NEAR(contact[1], wheel.dimensions.slot_width / 2., 1e-15);
  EXPECT_TRUE(test::has_vertex(wheel.mesh, 1, contact));
}

TEST_P(BothWheels, HaveNoVertexOfBothBodiesThoughTheyTouch) {
  // without clearance the pin at its farthest into the slot touches both walls and the bottom
  const double deepest = GetParam() == WheelType::external ? 0. : 1.;
  const MeshData<2> mesh = meshed(GetParam(), 6, diameter, deepest).mesh;
  std::set<unsigned int> of_wheel;
  std::set<unsigned int> of_pin;
  for (const Cell<2>& quad : mesh.cells)
    (quad.body == 0 ? of_wheel : of_pin).insert(quad.vertices.begin(), quad.vertices.end());
  for (const unsigned int vertex : of_pin) EXPECT_EQ(of_wheel.count(vertex), 0U);
}

TEST_P(BothWheels, HaveEveryVertexOfTheOutlineExactly) {
  const DrawnWheel& wheel = usual(GetParam(), 5);
  const std::set<std::array<double, 2>> vertices(wheel.mesh.vertices.begin(),
                                                 wheel.mesh.vertices.end());
  for (const loads::Outline& outline : wheel.outlines)
    for (const loads::Loop& loop : outline.loops)
      for (const loads::Segment& segment : loop)
        EXPECT_EQ(vertices.count({segment.start.x, segment.start.y}), 1U);
}

TEST_P(BothWheels, HaveTheirBoundaryOnTheCirclesOfTheOutlineToRoundOff) {
  const DrawnWheel& wheel = usual(GetParam(), 4);
  for (const Face<2>& edge : wheel.mesh.faces) {
    const std::string& name = wheel.mesh.surfaces[edge.surface];
    if (wheel.radius.count(name) == 0) continue;
    ASSERT_GE(edge.circle, 0) << name;
    const Circle& circle = wheel.mesh.circles[static_cast<std::size_t>(edge.circle)];
    EXPECT_NEAR(circle.radius, wheel.radius.at(name), round_off * wheel.size) << name;
    for (const unsigned int vertex : edge.vertices) {
      const auto& [x, y] = wheel.mesh.vertices[vertex];
      EXPECT_NEAR(std::hypot(x - circle.centre[0], y - circle.centre[1]), circle.radius,
                  2. * round_off * wheel.size);
    }
  }
}

TEST_P(BothWheels, ListEveryCircleOnce) {
  // rim, bore or inner rim, pin and core, and a bottom and a locking arc per station
  EXPECT_EQ(usual(GetParam(), 4).mesh.circles.size(), 4U + 2U * 4U);
}

TEST_P(BothWheels, KeepTheDrivingWallStraightAndTheBottomOfItsSlotRound) {
  const DrawnWheel& wheel = usual(GetParam(), 4);
  const double half_width = wheel.dimensions.slot_width / 2.;
  int straight = 0;
  int round = 0;
  for (const Face<2>& edge : wheel.mesh.faces) {
    if (wheel.mesh.surfaces[edge.surface] != "driving wall") continue;
    ++(edge.circle < 0 ? straight : round);
    if (edge.circle < 0)
      for (const unsigned int vertex : edge.vertices)
        EXPECT_NEAR(wheel.mesh.vertices[vertex][1], half_width, round_off * wheel.size);
    else
      EXPECT_NEAR(wheel.mesh.circles[static_cast<std::size_t>(edge.circle)].radius, half_width,
                  round_off * wheel.size);
  }
  EXPECT_GT(straight, 0);
  EXPECT_GE(round, 4);
}

TEST_P(BothWheels, AreFineOnTheDrivingWallAtTheContact) {
  for (const int n : {3, 4, 6, 12, 24}) {
    const DrawnWheel wheel = meshed(GetParam(), n, diameter, 0.4);
    for (const Face<2>& edge : wheel.mesh.faces) {
      if (wheel.mesh.surfaces[edge.surface] != "driving wall" || edge.circle >= 0) continue;
      const double a = wheel.mesh.vertices[edge.vertices[0]][0];
      const double b = wheel.mesh.vertices[edge.vertices[1]][0];
      if (std::min(a, b) > wheel.pin_distance || std::max(a, b) < wheel.pin_distance) continue;
      EXPECT_LT(std::abs(a - b), wheel.dimensions.pin_diameter / 5.) << n;
      EXPECT_GT(std::abs(a - b), wheel.dimensions.pin_diameter / 15.) << n;
    }
  }
}

TEST_P(BothWheels, DoNotDependOnTheUnitOfLength) {
  for (const int n : {4, 7, 13}) {
    const MeshData<2>& metres = usual(GetParam(), n).mesh;
    for (const double factor : {0.0254, 1000., 1. / 3.}) {
      const MeshData<2> scaled = meshed(GetParam(), n, diameter * factor).mesh;
      ASSERT_EQ(scaled.vertices.size(), metres.vertices.size());
      ASSERT_EQ(scaled.cells.size(), metres.cells.size());
      for (std::size_t i = 0; i < metres.cells.size(); ++i)
        EXPECT_EQ(scaled.cells[i].vertices, metres.cells[i].vertices);
      for (std::size_t i = 0; i < metres.vertices.size(); ++i)
        for (std::size_t k = 0; k < 2; ++k)
          EXPECT_NEAR(scaled.vertices[i][k], factor * metres.vertices[i][k],
                      1e-12 * diameter * factor);
    }
  }
}

TEST_P(BothWheels, AreTheSameEveryTime) {
  EXPECT_EQ(usual(GetParam(), 9).mesh.vertices, meshed(GetParam(), 9).mesh.vertices);
}

TEST(ExternalWheelMesh, OfFourStationsHasTwoToFourHundredCells) {
  const std::size_t cells = usual(WheelType::external, 4).mesh.cells.size();
  EXPECT_GE(cells, 200U);
  EXPECT_LE(cells, 400U);
}

TEST(ExternalWheelMesh, MakesARingOfLayersOfThePin) {
  const DrawnWheel& wheel = usual(WheelType::external, 4);
  const auto edges = edges_by_surface(wheel.mesh);
  const int around = edges.at("pin");
  EXPECT_EQ(edges.at("pin core"), around);
  EXPECT_LE(around, 32);
  const loads::CommonDimensions& d = wheel.dimensions;
  const double middle = (d.slot_width - d.pin_diameter) / 2.;
  int cells = 0;
  for (const Cell<2>& quad : wheel.mesh.cells) {
    if (quad.body != 1) continue;
    ++cells;
    EXPECT_GT(scaled_jacobian(corners(wheel.mesh, quad)), 0.98);
    for (const unsigned int vertex : quad.vertices) {
      const auto& [x, y] = wheel.mesh.vertices[vertex];
      const double layer = (std::hypot(x - wheel.pin_distance, y - middle) - d.pin_core_radius) /
                           (d.pin_diameter / 2. - d.pin_core_radius) * 2.;
      EXPECT_NEAR(layer, std::round(layer), 0.02);
    }
  }
  EXPECT_EQ(cells, 2 * around);
}

TEST(ExternalWheelMesh, CopesWithAThinWebBetweenSlotsAndBore) {
  auto input = test::wheel_of<loads::GenevaDimensionsInput>(4);
  input.pin_diameter = 0.0186;
  input.slot_width = 0.0192;
  input.bore_radius = 0.0095;  // the web is 1.6 mm
  EXPECT_GT(minimum_scaled_jacobian_refined(meshed(input).mesh), 0.15);
}

TEST(ExternalWheelMesh, CopesWithAPinMuchThinnerThanItsSlotAndALargeCore) {
  auto input = test::wheel_of<loads::GenevaDimensionsInput>(6);
  input.pin_diameter = 0.002;
  input.slot_width = 0.014;
  input.pin_core_radius = 0.0009;
  EXPECT_GT(minimum_scaled_jacobian_refined(meshed(input).mesh), 0.15);
}

TEST(InternalWheelMesh, CopesWithAThinWebOverTheSlotsAndDeepSlots) {
  auto input = test::wheel_of<loads::InternalDimensionsInput>(6);
  input.slot_depth = 0.05;   // 35.8 mm would do
  input.rim_radius = 0.103;  // the web is 3 mm
  EXPECT_GT(minimum_scaled_jacobian_refined(meshed(input).mesh), 0.15);
}

}  // namespace
}  // namespace geneva::mesh
