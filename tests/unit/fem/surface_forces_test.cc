#include "fem/surface_forces.h"

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
  std::vector<CellSystem> cells(4);
  cells[0].dofs = {0, 1};
  cells[1].dofs = {4, 5};
  cells[2].dofs = {2, 3};
  cells[3].dofs = {6, 7};
  const ForcedUnknowns forced = forced_unknowns({0, 1}, cells, hanging);
  EXPECT_EQ(forced.dofs, (std::vector<dealii::types::global_dof_index>{0, 1}));
  ASSERT_EQ(forced.cells.size(), 2U);
  EXPECT_EQ(forced.cells[0].index, 0U);
  EXPECT_EQ(forced.cells[0].shares.size(), 2U);
  EXPECT_EQ(forced.cells[1].index, 2U);
  ASSERT_EQ(forced.cells[1].shares.size(), 1U);
  EXPECT_EQ(forced.cells[1].shares[0].of, 1U);
  EXPECT_EQ(forced.cells[1].shares[0].in, 0U);
  EXPECT_EQ(forced.cells[1].shares[0].share, 0.5);
  EXPECT_TRUE(forced_unknowns({}, cells, hanging).cells.empty());
}

}  // namespace
}  // namespace geneva::fem::test
