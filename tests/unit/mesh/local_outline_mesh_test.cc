#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "loads/wheel/local_outline.h"
#include "mesh/mesh_quality.h"
#include "mesh_measures.h"
#include "test_mesher.h"

namespace geneva::mesh {
namespace {

using loads::LocalDimensions;
using test::area;
using test::edges_by_surface;
using test::has_vertex;

MeshData<2> meshed(const LocalDimensions& dimensions) {
  return mesh_outlines(loads::local_outlines(dimensions), default_sizing(dimensions));
}

/// A pin of 10 mm on a block of that width and depth, in pin diameters.
LocalDimensions block(double width, double depth) {
  return {0.01, 0.0025, 0.01 * width, 0.01 * depth};
}

const MeshData<2>& usual() {
  static const MeshData<2> mesh = meshed(block(4., 3.));
  return mesh;
}

TEST(LocalOutlineMesh, HasAFewHundredGoodCellsWhateverTheBlock) {
  for (const auto& [width, depth] : {std::pair{1., 0.5},
                                     {1., 1.},
                                     {1., 4.},
                                     {2., 1.},
                                     {3., 0.5},
                                     {4., 2.},
                                     {4., 3.},
                                     {4., 4.},
                                     {7.3, 5.1},
                                     {10., 10.},
                                     {20., 10.},
                                     {50., 50.}}) {
    const MeshData<2> mesh = meshed(block(width, depth));
    check(mesh);
    EXPECT_GE(mesh.cells.size(), 70U) << width << " x " << depth;
    EXPECT_LE(mesh.cells.size(), 700U) << width << " x " << depth;
    EXPECT_GT(minimum_scaled_jacobian(mesh), 0.15) << width << " x " << depth;
    EXPECT_GT(minimum_scaled_jacobian_refined(mesh), 0.15) << width << " x " << depth;
  }
}

TEST(LocalOutlineMesh, HasTheAreaOfItsOutlines) {
  const auto outlines = loads::local_outlines(block(4., 3.));
  for (unsigned int body = 0; body < 2; ++body) {
    const double exact = loads::area_moments(outlines[body]).area;
    EXPECT_NEAR(area(usual(), body), exact, 1e-12 * exact);
  }
}

TEST(LocalOutlineMesh, HasAllNamedSurfacesAndNoNamelessBoundary) {
  const auto edges = edges_by_surface(usual());
  for (const char* const name : {"driving wall", "back", "sides", "pin", "pin core"})
    EXPECT_GT(edges.count(name), 0U) << name;
  EXPECT_EQ(edges.size(), 5U);
}

TEST(LocalOutlineMesh, HasThePointOfContactAsAVertexOfThePin) {
  EXPECT_TRUE(has_vertex(usual(), 1, {0., 0.}));
}

TEST(LocalOutlineMesh, KeepsTheFacesOfTheBlockStraight) {
  for (const Face<2>& edge : usual().faces)
    for (const unsigned int vertex : edge.vertices) {
      const std::string& name = usual().surfaces[edge.surface];
      const auto& [x, y] = usual().vertices[vertex];
      if (name == "driving wall") {
        EXPECT_EQ(y, 0.);
      }
      if (name == "back") {
        EXPECT_NEAR(y, 0.03, 1e-16);
      }
      if (name == "sides") {
        EXPECT_NEAR(std::abs(x), 0.02, 1e-16);
      }
    }
}

/// A vertex of the contact where other than two cells meet leaves a defect of the pressure that no
/// refinement removes.
TEST(LocalOutlineMesh, IsRegularAlongTheContact) {
  std::vector<int> cells(usual().vertices.size(), 0);
  for (const Cell<2>& quad : usual().cells)
    for (const unsigned int vertex : quad.vertices) ++cells[vertex];
  for (const Face<2>& edge : usual().faces) {
    const std::string& name = usual().surfaces[edge.surface];
    for (const unsigned int vertex : edge.vertices) {
      const bool is_corner = std::abs(std::abs(usual().vertices[vertex][0]) - 0.02) < 1e-15;
      if (name == "pin" || (name == "driving wall" && !is_corner)) {
        EXPECT_EQ(cells[vertex], 2) << name;
      }
    }
  }
}

TEST(LocalOutlineMesh, DoesNotDependOnTheUnitOfLength) {
  const MeshData<2> inches = meshed({0.01 / 0.0254, 0.0025 / 0.0254, 0.04 / 0.0254, 0.03 / 0.0254});
  ASSERT_EQ(inches.cells.size(), usual().cells.size());
  for (std::size_t i = 0; i < usual().cells.size(); ++i)
    EXPECT_EQ(inches.cells[i].vertices, usual().cells[i].vertices);
}

}  // namespace
}  // namespace geneva::mesh
