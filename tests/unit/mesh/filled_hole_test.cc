#include "mesh/filled_hole.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mesh/mesh_quality.h"
#include "test_mesher.h"
#include "tests/unit/mesh/mesh_measures.h"

namespace geneva::mesh::test {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A pin of the given diameter on a block of twice its width.
MeshData<2> pin_on_block(const double diameter, const double core) {
  const loads::LocalDimensions dimensions{diameter, core, 2. * diameter, diameter};
  return mesh_outlines(loads::local_outlines(dimensions), default_sizing(dimensions));
}

unsigned int pin_of(const MeshData<2>& mesh) {
  const auto found = std::find(mesh.bodies.begin(), mesh.bodies.end(), "pin");
  return static_cast<unsigned int>(found - mesh.bodies.begin());
}

TEST(FilledHole, MakesASolidPin) {
  for (const double core : {0.1, 0.25, 0.4}) {
    const MeshData<2> hollow = pin_on_block(1., core);
    const MeshData<2> solid = with_filled_hole(hollow, "pin core");
    EXPECT_NEAR(area(solid, pin_of(solid)), pi / 4., 1e-12) << core;
    EXPECT_GT(minimum_scaled_jacobian(solid), 0.2) << core;
    EXPECT_GT(minimum_scaled_jacobian_refined(solid), 0.2) << core;
    EXPECT_EQ(edges_by_surface(solid).count("pin core"), 0U);
    EXPECT_EQ(edges_by_surface(solid)["pin"], edges_by_surface(hollow)["pin"]);
  }
}

TEST(FilledHole, DoesNotDependOnTheUnitOfLength) {
  const MeshData<2> metres = with_filled_hole(pin_on_block(1., 0.25), "pin core");
  const MeshData<2> inches = with_filled_hole(pin_on_block(0.0254, 0.25 * 0.0254), "pin core");
  ASSERT_EQ(metres.vertices.size(), inches.vertices.size());
  for (std::size_t i = 0; i < metres.vertices.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(inches.vertices[i][k], 0.0254 * metres.vertices[i][k], 1e-14);
  for (std::size_t i = 0; i < metres.cells.size(); ++i)
    EXPECT_EQ(metres.cells[i].vertices, inches.cells[i].vertices);
}

TEST(FilledHole, RefusesWhatIsNoHole) {
  const MeshData<2> mesh = pin_on_block(1., 0.25);
  EXPECT_THROW(with_filled_hole(mesh, "no such surface"), std::invalid_argument);
  EXPECT_THROW(with_filled_hole(mesh, ""), std::invalid_argument);
}

}  // namespace
}  // namespace geneva::mesh::test
