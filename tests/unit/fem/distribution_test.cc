#include "fem/discretisation/distribution.h"

#include <deal.II/dofs/dof_tools.h>
#include <gtest/gtest.h>

#include "discretisation.h"

namespace geneva::fem {
namespace {

using test::Discretisation;

constexpr double tolerated_excess = 0.02;

/// A square of 24 x 24 cells.
Discretisation<2> square() {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_rectangle(mesh, "square", geneva::test::equal_steps(0., 1., 24),
                              geneva::test::equal_steps(0., 1., 24), {"", "", "", ""});
  return Discretisation<2>(mesh);
}

/// Flags the cells of the lower half, or every cell.
void flag(Discretisation<2>& grid, const bool only_below) {
  for (const auto& cell : grid.triangulation->active_cell_iterators())
    if (cell->is_locally_owned() && (!only_below || cell->center()[1] < 0.5))
      cell->set_refine_flag();
}

unsigned int n_flagged(const Discretisation<2>& grid) {
  unsigned int flagged = 0;
  for (const auto& cell : grid.triangulation->active_cell_iterators())
    if (cell->is_locally_owned() && cell->refine_flag_set()) ++flagged;
  return dealii::Utilities::MPI::sum(flagged, MPI_COMM_WORLD);
}

std::vector<dealii::CellId> own_cells(const Discretisation<2>& grid) {
  std::vector<dealii::CellId> cells;
  for (const auto& cell : grid.triangulation->active_cell_iterators())
    if (cell->is_locally_owned()) cells.push_back(cell->id());
  return cells;
}

test::Field<2> linear() {
  return [](const dealii::Point<2>& point) {
    return dealii::Tensor<1, 2>({1. + 2. * point[0] - point[1], 3. * point[1]});
  };
}

/// The linear field's values on this rank's cells.
Vector displacement(const Discretisation<2>& grid) {
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(*grid.dof_handler, relevant);
  Vector result(grid.dof_handler->locally_owned_dofs(), relevant, MPI_COMM_WORLD);
  for (const auto& cell : grid.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    std::vector<dealii::types::global_dof_index> dofs(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    const auto values = test::values_on(cell, linear());
    for (unsigned int i = 0; i < values.size(); ++i) result(dofs[i]) = values[i];
  }
  result.compress(dealii::VectorOperation::insert);
  result.update_ghost_values();
  return result;
}

double maximum_error(const Discretisation<2>& grid, const Vector& values) {
  double error = 0.;
  for (const auto& cell : grid.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    dealii::Vector<double> on_cell(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_values(values, on_cell);
    on_cell -= test::values_on(cell, linear());
    error = std::max(error, on_cell.linfty_norm());
  }
  return dealii::Utilities::MPI::max(error, MPI_COMM_WORLD);
}

TEST(DistributionForRefinement, GivesEachRankItsShareOfTheRefinedMesh) {
  Discretisation<2> grid = square();
  MeshFields fields{displacement(grid), {}};
  flag(grid, true);
  grid.triangulation->prepare_coarsening_and_refinement();
  distribute_for_refinement(*grid.triangulation, *grid.dof_handler, fields);
  grid.triangulation->execute_coarsening_and_refinement();
  const auto cells = dealii::Utilities::MPI::min_max_avg(
      static_cast<double>(grid.triangulation->n_locally_owned_active_cells()), MPI_COMM_WORLD);
  EXPECT_LE(cells.max, (1. + tolerated_excess) * cells.avg);
}

TEST(DistributionForRefinement, KeepsTheFlagsAndTheDisplacement) {
  Discretisation<2> grid = square();
  MeshFields fields{displacement(grid), {}};
  flag(grid, true);
  distribute_for_refinement(*grid.triangulation, *grid.dof_handler, fields);
  EXPECT_EQ(n_flagged(grid), 24 * 12);
  for (const auto& cell : grid.triangulation->active_cell_iterators())
    if (cell->is_locally_owned()) {
      EXPECT_EQ(bool(cell->refine_flag_set()), cell->center()[1] < 0.5);
    }
  EXPECT_LT(maximum_error(grid, fields.displacement), 1e-14);
}

TEST(DistributionForRefinement, LeavesCellsThatAreSharedEvenlyWhereTheyAre) {
  Discretisation<2> grid = square();
  MeshFields fields{displacement(grid), {}};
  flag(grid, false);
  const auto before = own_cells(grid);
  distribute_for_refinement(*grid.triangulation, *grid.dof_handler, fields);
  EXPECT_EQ(own_cells(grid), before);
}

}  // namespace
}  // namespace geneva::fem
