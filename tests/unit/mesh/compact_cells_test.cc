#include "mesh/compact_cells.h"

#include <gtest/gtest.h>

#include "tests/support/structured_mesh.h"

namespace geneva::mesh {
namespace {

/// A block of one layer of cells, 1 wide each and so deep, whose upper side is "top".
MeshData<2> layer(const unsigned int columns, const double depth) {
  MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_rectangle(mesh, "block", geneva::test::equal_steps(0., columns, columns),
                              {-depth, 0.}, {"", "", "top", ""});
  return mesh;
}

std::size_t cells_of_a_column(const unsigned int columns, const double depth) {
  return with_compact_cells(layer(columns, depth), {"top"}).cells.size() / columns;
}

TEST(CompactCells, AreAsDeepAsLong) {
  EXPECT_EQ(cells_of_a_column(10, 1.4), 1U);
  EXPECT_EQ(cells_of_a_column(10, 5.), 5U);
  EXPECT_EQ(cells_of_a_column(10, 29.), 29U);
}

TEST(CompactCells, AreNotCutIntoManyPiecesWhereTheMeshIsLarge) {
  EXPECT_EQ(cells_of_a_column(10, 1000.), 64U);
  EXPECT_EQ(cells_of_a_column(200, 1000.), 8U);
}

}  // namespace
}  // namespace geneva::mesh
