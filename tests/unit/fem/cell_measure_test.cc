#include "fem/discretisation/cell_measure.h"

#include <deal.II/grid/grid_generator.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace geneva::fem::test {
namespace {

template <int dim>
double measure_of(const std::vector<dealii::Point<dim>>& corners) {
  dealii::Triangulation<dim> triangulation;
  dealii::GridGenerator::general_cell(triangulation, corners);
  return cell_measure<dim>(triangulation.begin_active());
}

TEST(CellMeasure, IsTheAreaOfAQuadrilateral) {
  // Half of the cross product of the diagonals (3, 2) and (-2, 2).
  EXPECT_NEAR(measure_of<2>({{0., 0.}, {2., 0.}, {0., 2.}, {3., 2.}}), 5., 1e-14);
}

TEST(CellMeasure, IsTheVolumeOfATaperedBlock) {
  // A frustum of a pyramid with the squares 2 x 2 and 1 x 1 at a distance of 3.
  EXPECT_NEAR(measure_of<3>({{0., 0., 0.},
                             {2., 0., 0.},
                             {0., 2., 0.},
                             {2., 2., 0.},
                             {0., 0., 3.},
                             {1., 0., 3.},
                             {0., 1., 3.},
                             {1., 1., 3.}}),
              7., 1e-13);
}

TEST(CellMeasure, HoldsForCellsThatAreSmallBesideTheirDistance) {
  for (const double size : {1e-4, 1e-6, 1e-8}) {
    std::vector<dealii::Point<3>> corners;
    for (unsigned int i = 0; i < 8; ++i)
      corners.emplace_back(0.152 + size * (i & 1U), 0.071 + size * (i >> 1U & 1U),
                           0.525 + size * (i >> 2U));
    EXPECT_NEAR(measure_of<3>(corners) / std::pow(size, 3), 1., 1e-16 / size) << size;
  }
}

}  // namespace
}  // namespace geneva::fem::test
