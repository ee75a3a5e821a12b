#include "fem/discretisation/numbering.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "discretisation.h"

namespace geneva::fem {
namespace {

using test::Discretisation;
using Dof = dealii::types::global_dof_index;

/// Along one side, before and after refinement.
constexpr int n_coarse_cells = 3;
constexpr int n_refinements = 4;
constexpr int n_cells = n_coarse_cells << n_refinements;

Discretisation<2> square() {
  const auto steps = geneva::test::equal_steps(0., 1., n_coarse_cells);
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_rectangle(mesh, "square", steps, steps, {"", "", "", ""});
  Discretisation<2> grid(mesh);
  grid.triangulation->refine_global(n_refinements);
  grid.dof_handler->distribute_dofs(grid.dof_handler->get_fe());
  return grid;
}

/// Maximum difference of the numbers of a cell's nodes, as far as they are this rank's.
Dof maximum_distance(const dealii::DoFHandler<2>& dof_handler) {
  const dealii::IndexSet& owned = dof_handler.locally_owned_dofs();
  Dof result = 0;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    std::vector<Dof> nodes;
    for (const unsigned int vertex : cell->vertex_indices())
      if (owned.is_element(cell->vertex_dof_index(vertex, 0)))
        nodes.push_back(cell->vertex_dof_index(vertex, 0) / 2);
    if (nodes.empty()) continue;
    const auto [least, maximum] = std::minmax_element(nodes.begin(), nodes.end());
    result = std::max(result, *maximum - *least);
  }
  return result;
}

TEST(NumberByNeighbours, NumbersNodesOfACellCloseToEachOther) {
  const Discretisation<2> grid = square();
  const Dof before = maximum_distance(*grid.dof_handler);
  number_by_neighbours(*grid.dof_handler);
  // From a corner on, the nodes that are k cells away are 2 k + 1.
  const Dof farthest = 2 * (2 * n_cells + 1);
  EXPECT_LT(maximum_distance(*grid.dof_handler), farthest);
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1) {
    EXPECT_GT(before, farthest);
  }
}

TEST(NumberByNeighbours, LeavesEachRankItsUnknownsAndThoseOfANodeTogether) {
  Discretisation<2> grid = square();
  const dealii::IndexSet owned = grid.dof_handler->locally_owned_dofs();
  number_by_neighbours(*grid.dof_handler);
  EXPECT_TRUE(grid.dof_handler->locally_owned_dofs() == owned);
  std::vector<bool> is_met(grid.dof_handler->n_dofs(), false);
  for (const auto& cell : grid.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const unsigned int vertex : cell->vertex_indices()) {
      const Dof first = cell->vertex_dof_index(vertex, 0);
      EXPECT_EQ(first % 2, 0U);
      EXPECT_EQ(cell->vertex_dof_index(vertex, 1), first + 1);
      is_met[first] = true;
    }
  }
  for (const Dof dof : owned) EXPECT_TRUE(dof % 2 == 1 || is_met[dof]);
}

}  // namespace
}  // namespace geneva::fem
