#include "fem/elasticity/surface_forces.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace geneva::fem::test {
namespace {

TEST(SurfaceForces, AreKnownAtTheirUnknownsOnly) {
  const SurfaceForces forces({2, 5}, {0.5, -1.});
  EXPECT_EQ(forces(2), 0.5);
  EXPECT_EQ(forces(5), -1.);
  for (const dealii::types::global_dof_index other : {0U, 3U, 7U})
    EXPECT_THROW((void)forces(other), std::out_of_range) << other;
}

TEST(ForcedUnknowns, HaveSharesInTheCellsOfNodesThatHangOnThem) {
  dealii::AffineConstraints<double> hanging;
  hanging.add_line(3);
  hanging.add_entry(3, 0, 0.5);
  hanging.add_entry(3, 6, 0.5);
  hanging.close();
  const CellSystems cells(
      {{0, 1}, {4, 5}, {2, 3}, {6, 7}},
      [](const std::size_t index) {
        dealii::FullMatrix<double> stiffness(2);
        for (unsigned int i = 0; i < 2; ++i)
          for (unsigned int j = 0; j < 2; ++j)
            stiffness(i, j) = 100. * static_cast<double>(index) + 10. * i + j;
        return stiffness;
      },
      [](const std::size_t index) {
        dealii::Vector<double> load(2);
        load[1] = 1. + static_cast<double>(index);
        return load;
      });
  using Dofs = CellSystems::Dofs;
  const ForcedUnknowns forced = forced_unknowns({0, 1}, cells, hanging);
  EXPECT_EQ(forced.dofs, (Dofs{0, 1}));
  ASSERT_EQ(forced.cells.size(), 2U);
  EXPECT_EQ(forced.cells[0].dofs, (Dofs{0, 1}));
  ASSERT_EQ(forced.cells[0].shares.size(), 2U);
  EXPECT_EQ(forced.cells[0].shares[1].in, 1U);
  EXPECT_EQ(forced.cells[0].shares[1].stiffness, (std::vector<double>{10., 11.}));
  EXPECT_EQ(forced.cells[0].shares[1].load, 1.);
  EXPECT_EQ(forced.cells[1].dofs, (Dofs{2, 3}));
  ASSERT_EQ(forced.cells[1].shares.size(), 1U) << "of the unknown that hangs";
  EXPECT_EQ(forced.cells[1].shares[0].in, 0U);
  EXPECT_EQ(forced.cells[1].shares[0].stiffness, (std::vector<double>{105., 105.5}));
  EXPECT_EQ(forced.cells[1].shares[0].load, 1.5);
  EXPECT_TRUE(forced_unknowns({}, cells, hanging).cells.empty());
}

}  // namespace
}  // namespace geneva::fem::test
