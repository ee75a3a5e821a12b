#include "mesh/mesher_exchange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/refusal.h"

namespace geneva::mesh {
namespace {

using loads::test::expect_refused;
using nlohmann::json;

/// One square with a round side.
MeshData<2> square() {
  MeshData<2> mesh;
  mesh.vertices = {{0., 0.}, {1. / 3., 0.}, {1. / 3., 0.1}, {0., 1e-300}};
  mesh.cells = {{{0, 1, 2, 3}, 0}};
  mesh.faces = {{{0, 1}, 1, 0}, {{1, 2}, 0, -1}};
  mesh.circles = {{{0.1, -0.2, 0.}, 0.7}};
  mesh.bodies = {"square"};
  mesh.surfaces = {"", "round"};
  return mesh;
}

/// What a text of JSON says after having been a text.
json sent(const json& value) { return json::parse(value.dump()); }

TEST(MesherExchange, GivesBackMeshesToTheLastBit) {
  const MeshData<2> given = square();
  const auto got = mesh_of<2>(sent(json_of(given)));
  EXPECT_EQ(got.vertices, given.vertices);
  EXPECT_EQ(got.cells[0].vertices, given.cells[0].vertices);
  EXPECT_EQ(got.faces[0].circle, 0);
  EXPECT_EQ(got.faces[1].circle, -1);
  EXPECT_EQ(got.circles[0].centre, given.circles[0].centre);
  EXPECT_EQ(got.circles[0].axis, given.circles[0].axis);
  EXPECT_EQ(got.bodies, given.bodies);
  EXPECT_EQ(got.surfaces, given.surfaces);
}

TEST(MesherExchange, GivesBackTasksToTheLastBit) {
  const loads::Segment arc{{0.1, 1. / 3.}, {2., 3.}, true, {4., 5.}, true, "rim"};
  const OutlineTask given{{{"wheel", {{arc}}}}, {1. / 7., 0.2, {0.3, 0.4}, 0.5}};
  const OutlineTask got = outline_task_of(sent(json_of(given)));
  const loads::Segment& segment = got.outlines.at(0).loops.at(0).at(0);
  EXPECT_EQ(segment.start.y, arc.start.y);
  EXPECT_EQ(segment.centre.x, 4.);
  EXPECT_TRUE(segment.is_arc && segment.clockwise);
  EXPECT_EQ(segment.surface, "rim");
  EXPECT_EQ(got.sizing.general, 1. / 7.);
  const GeometryTask task = geometry_task_of(sent(json_of(GeometryTask{
      3, "/d", "f", FileKind::step, 0.1, {"wheel"}, {{"wall", false, {0.1, 1. / 3., 2.}}}, 0.2})));
  EXPECT_EQ(task.dimension, 3);
  EXPECT_EQ(task.kind, FileKind::step);
  EXPECT_EQ(task.circle_tolerance, 0.1);
  EXPECT_EQ(task.bodies, std::vector<std::string>{"wheel"});
  EXPECT_EQ(task.picks.at(0).name, "wall");
  EXPECT_FALSE(task.picks.at(0).is_body);
  EXPECT_EQ(task.picks.at(0).place[1], 1. / 3.);
  EXPECT_EQ(task.cell_size, 0.2);
}

TEST(MesherExchange, RefusesWhatIsNoMesh) {
  const auto expect_no_mesh = [](const std::function<void(json&)>& change) {
    json mesh = json_of(square());
    change(mesh);
    expect_refused([&] { (void)mesh_of<2>(mesh); }, {"is no mesh"});
  };
  expect_no_mesh([](json& mesh) { mesh = json::array(); });
  expect_no_mesh([](json& mesh) { mesh = nullptr; });
  expect_no_mesh([](json& mesh) { mesh["dimension"] = 3; });
  for (const char* const member : {"vertices", "cells", "faces", "circles", "bodies", "surfaces"}) {
    expect_no_mesh([&](json& mesh) { mesh.erase(member); });
    expect_no_mesh([&](json& mesh) { mesh[member] = "x"; });
    expect_no_mesh([&](json& mesh) { mesh[member] = {json::object()}; });
    expect_no_mesh([&](json& mesh) { mesh[member] = {{1.}}; });
  }
  expect_no_mesh([](json& mesh) { mesh["vertices"][0] = {0., 0., 0.}; });
  expect_no_mesh([](json& mesh) { mesh["vertices"][0][1] = nullptr; });
  expect_no_mesh([](json& mesh) { mesh["vertices"][0][1] = INFINITY; });
  expect_no_mesh([](json& mesh) { mesh["cells"][0][2] = -1; });
  expect_no_mesh([](json& mesh) { mesh["cells"][0][2] = 1.5; });
  expect_no_mesh([](json& mesh) { mesh["cells"][0][2] = 4294967296; });
  expect_no_mesh([](json& mesh) { mesh["faces"][0][3] = -2; });
  expect_no_mesh([](json& mesh) { mesh["faces"][0][3] = 3000000000; });
  expect_no_mesh([](json& mesh) { mesh["circles"][0][3] = 0.; });
  expect_no_mesh([](json& mesh) { mesh["circles"][0][6] = 2.; });
  expect_no_mesh([](json& mesh) { mesh["surfaces"] = json::array(); });
}

}  // namespace
}  // namespace geneva::mesh
