#include "fem/discretisation/cell_parts.h"

#include <deal.II/grid/grid_generator.h>
#include <gtest/gtest.h>

#include <vector>

namespace geneva::fem::test {
namespace {

using dealii::Point;

template <int dim>
CellParts<dim> parts_of_block(const Point<dim>& far) {
  dealii::Triangulation<dim> triangulation;
  dealii::GridGenerator::hyper_rectangle(triangulation, Point<dim>(), far);
  return parts_of<dim>(triangulation.begin_active());
}

TEST(CellParts, OfACubeIsTheCube) {
  const CellParts<3> parts = parts_of_block(Point<3>(2., 2., 2.));
  ASSERT_EQ(parts.centres.size(), 1U);
  EXPECT_NEAR(parts.centres[0].distance(Point<3>(1., 1., 1.)), 0., 1e-15);
  EXPECT_NEAR(parts.measure, 8., 1e-14);
}

TEST(CellParts, OfALongCellAreCubesOneBehindTheOther) {
  const CellParts<3> parts = parts_of_block(Point<3>(1., 1., 4.));
  ASSERT_EQ(parts.centres.size(), 4U);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(parts.centres[i].distance(Point<3>(0.5, 0.5, 0.5 + i)), 0., 1e-15);
  EXPECT_NEAR(parts.measure, 1., 1e-15);
}

TEST(CellParts, OfAFlatCellAreInBothLongDirections) {
  const CellParts<3> parts = parts_of_block(Point<3>(3., 1., 2.));
  EXPECT_EQ(parts.centres.size(), 6U);
  EXPECT_NEAR(parts.measure, 1., 1e-15);
  Point<3> middle;
  for (const Point<3>& centre : parts.centres) middle += centre / 6.;
  EXPECT_NEAR(middle.distance(Point<3>(1.5, 0.5, 1.)), 0., 1e-15);
}

TEST(CellParts, AreEightAlongAnAxisAtMost) {
  const CellParts<2> parts = parts_of_block(Point<2>(1., 100.));
  EXPECT_EQ(parts.centres.size(), 8U);
  EXPECT_NEAR(parts.measure, 12.5, 1e-13);
}

TEST(CellParts, OfASkewedCellLieAlongIt) {
  dealii::Triangulation<2> triangulation;
  dealii::GridGenerator::general_cell(
      triangulation, std::vector<Point<2>>{{0., 0.}, {2., 2.}, {-0.5, 0.5}, {1.5, 2.5}});
  const CellParts<2> parts = parts_of<2>(triangulation.begin_active());
  ASSERT_EQ(parts.centres.size(), 4U);
  EXPECT_NEAR(parts.centres[0].distance(Point<2>(0., 0.5)), 0., 1e-15);
  EXPECT_NEAR(parts.centres[3].distance(Point<2>(1.5, 2.)), 0., 1e-15);
  EXPECT_NEAR(parts.measure, 0.5, 1e-15);
}

}  // namespace
}  // namespace geneva::fem::test
