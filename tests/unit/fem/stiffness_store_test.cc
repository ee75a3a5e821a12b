#include "fem/stiffness_store.h"

#include <gtest/gtest.h>

#include <set>

#include "fem/hanging_vertices.h"
#include "mesh/extrusion.h"
#include "tests/unit/fem/discretisation.h"

namespace geneva::fem::test {
namespace {

constexpr double pi = 3.14159265358979323846;

mesh::MeshData<3> pipe() {
  mesh::MeshData<2> ring = geneva::test::empty_mesh();
  geneva::test::add_ring(
      ring, "pipe",
      {{0., 0.}, {1., 2.}, geneva::test::equal_steps(0., 2. * pi, 8), "", "outside", "", ""});
  return extruded(ring, {{{0., 1.}, "", ""}});
}

/// Refines the coarsest cells on one side of the plane z = 0.5.
void refine_side(Discretisation<3>& grid, const bool above) {
  for (const auto& cell : grid.triangulation->active_cell_iterators())
    if (cell->is_locally_owned() && cell->level() == 1 && (cell->center()[2] > 0.5) == above)
      cell->set_refine_flag();
  grid.triangulation->execute_coarsening_and_refinement();
  grid.dof_handler->distribute_dofs(grid.element);
}

/// A pipe that turns, with pressure on its outside.
Problem<3> turning_pipe() {
  Problem<3> problem;
  problem.bodies.push_back({"pipe", {2., 0.3}, {{1., 2., 3.}, {4., 5., 6.}}});
  problem.loads.push_back({"outside", 0.7, {0., 0., 0.}});
  return problem;
}

std::set<dealii::CellId> own_cells(const Discretisation<3>& grid) {
  std::set<dealii::CellId> cells;
  for (const auto& cell : grid.triangulation->active_cell_iterators())
    if (cell->is_locally_owned()) cells.insert(cell->id());
  return cells;
}

/// One number for each cell of this rank, in place of its stiffness.
StiffnessStore<3> numbers(const Discretisation<3>& grid) {
  StiffnessStore<3> store;
  for (const auto& cell : grid.triangulation->active_cell_iterators())
    if (cell->is_locally_owned()) {
      dealii::FullMatrix<double> number(1);
      number(0, 0) = cell->center()[0];
      store.keep(cell, number);
    }
  return store;
}

TEST(StiffnessStore, HasTheMatricesOfTheCellsThatAreNotRefined) {
  Discretisation<3> grid(pipe(), 1);
  const std::set<dealii::CellId> before = own_cells(grid);
  StiffnessStore<3> store = numbers(grid);
  refine_side(grid, true);
  for (const auto& cell : grid.triangulation->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const auto number = store.take(cell);
    ASSERT_EQ(number.has_value(), before.count(cell->id()) > 0);
    if (number) {
      EXPECT_EQ((*number)(0, 0), cell->center()[0]);
    }
    EXPECT_FALSE(store.take(cell).has_value());
  }
}

TEST(StiffnessStore, HasNothingForACellWhoseVertexHasMoved) {
  const Discretisation<3> grid(pipe(), 1);
  StiffnessStore<3> store = numbers(grid);
  for (const auto& cell : grid.triangulation->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->vertex(7)[1] += 1e-12;
    EXPECT_FALSE(store.take(cell).has_value());
    break;
  }
}

TEST(StoredStiffness, GivesTheSystemsThatIntegrationGives) {
  const mesh::MeshData<3> mesh = pipe();
  Discretisation<3> grid(mesh, 1);
  refine_side(grid, true);
  const auto moved = close_gaps(*grid.triangulation);
  StiffnessStore<3> stored = stored_stiffness(
      *grid.dof_handler, cell_systems(*grid.dof_handler, turning_pipe(), mesh.surfaces));
  put_back(*grid.triangulation, moved);
  refine_side(grid, false);  // the vertices that were moved hang no more
  close_gaps(*grid.triangulation);
  const auto systems =
      cell_systems(*grid.dof_handler, turning_pipe(), mesh.surfaces, std::move(stored));
  const auto integrated = cell_systems(*grid.dof_handler, turning_pipe(), mesh.surfaces);
  ASSERT_EQ(systems.size(), integrated.size());
  for (std::size_t i = 0; i < systems.size(); ++i) {
    EXPECT_EQ(systems[i].stiffness, integrated[i].stiffness);
    EXPECT_EQ(systems[i].load, integrated[i].load);
    EXPECT_EQ(systems[i].dofs, integrated[i].dofs);
  }
}

}  // namespace
}  // namespace geneva::fem::test
