#include "fem/linear/constraints.h"

#include <gtest/gtest.h>

#include <deal.II/dofs/dof_tools.h>

#include <cmath>

#include "fem/discretisation/boundary.h"
#include "tests/support/refusal.h"
#include "tests/unit/fem/discretisation.h"
#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {
namespace {

using geneva::test::equal_steps;
using loads::test::expect_refused;

mesh::MeshData<2> square() {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_rectangle(mesh, "square", equal_steps(0., 1., 4), equal_steps(0., 1., 4),
                              {"bottom", "right", "top", "left"});
  return mesh;
}

/// Boundary of a square with 16 edges.
struct Square {
  mesh::MeshData<2> mesh = square();
  Discretisation<2> grid{mesh};
  Boundary<2> boundary = gather_boundary(*grid.dof_handler, mesh.circles, 1.);
};

std::map<global_dof_index, ConstraintLine> by_dof(const std::vector<ConstraintLine>& lines) {
  std::map<global_dof_index, ConstraintLine> map;
  for (const ConstraintLine& line : lines) map.emplace(line.dof, line);
  return map;
}

TEST(IndexOf, FindsNamesAndThrowsForOthers) {
  EXPECT_EQ(mesh::index_of({"", "pin", "bore"}, "bore"), 2U);
  EXPECT_THROW(mesh::index_of({"", "pin"}, "Pin"), std::out_of_range);
}

TEST(Supports, HoldTheComponentsThatHaveAValue) {
  const Square square;
  const auto lines =
      support_lines(square.boundary, {{"bottom", {std::nullopt, 0.25}}}, square.mesh.surfaces);
  ASSERT_EQ(lines.size(), 5U);
  const auto map = by_dof(lines);
  for (const BoundaryNode<2>& node : square.boundary.nodes) {
    EXPECT_EQ(map.count(node.dofs[0]), 0U);
    EXPECT_EQ(map.count(node.dofs[1]), node.position[1] == 0. ? 1U : 0U);
  }
  for (const ConstraintLine& line : lines) {
    EXPECT_TRUE(line.entries.empty());
    EXPECT_EQ(line.inhomogeneity, 0.25);
  }
}

TEST(Supports, MayMeetWhereTheyAgree) {
  const Square square;
  const auto lines = support_lines(
      square.boundary, {{"bottom", {0., 0.}}, {"left", {0., std::nullopt}}}, square.mesh.surfaces);
  EXPECT_EQ(lines.size(), 10U + 4U) << "the corner is held once";
}

TEST(Supports, ThatContradictEachOtherAreRefusedByName) {
  const Square square;
  expect_refused(
      [&] {
        support_lines(square.boundary, {{"bottom", {0., 0.}}, {"left", {1e-6, std::nullopt}}},
                      square.mesh.surfaces);
      },
      {"'left'", "different displacement", "common node"});
}

/// A displacement vector on every rank that satisfies the tie, from an arbitrary master.
std::map<global_dof_index, double> tied(const TieLines& tie, const double master) {
  std::map<global_dof_index, double> values{{tie.master, master}};
  for (const ConstraintLine& line : tie.lines) {
    double value = line.inhomogeneity;
    for (const auto& [dof, coefficient] : line.entries) {
      EXPECT_EQ(dof, tie.master);
      value += coefficient * master;
    }
    EXPECT_TRUE(values.emplace(line.dof, value).second) << "constrained twice";
  }
  return values;
}

TEST(RigidTie, MovesAsOneAlongItsDirectionOnly) {
  const Square square;
  for (const std::array<double, 2>& direction :
       {std::array{0., -1.}, std::array{1., 0.}, std::array{0.6, 0.8}, std::array{-0.8, 0.6}}) {
    const RigidTie<2> tie{"top", direction, 7.};
    const TieLines lines = tie_lines(square.boundary, tie, square.mesh.surfaces);
    EXPECT_EQ(lines.lines.size(), 2U * 5U - 1U);
    const auto values = tied(lines, 0.3);
    const unsigned int leading = std::abs(direction[0]) > std::abs(direction[1]) ? 0 : 1;
    const double way = 0.3 / direction[leading];
    for (const BoundaryNode<2>& node : square.boundary.nodes)
      for (unsigned int c = 0; c < 2; ++c) {
        const auto value = values.find(node.dofs[c]);
        ASSERT_EQ(value != values.end(), node.position[1] == 1.);
        if (value == values.end()) continue;
        EXPECT_NEAR(value->second, way * direction[c], 1e-15);
      }
    // The master's force does the work of the tie's: force times way.
    EXPECT_NEAR(lines.master_force * 0.3, 7. * way, 1e-14);
  }
}

TEST(Constraints, HangingNodesAreTheMeansOfTheirNeighbours) {
  mesh::MeshData<2> mesh = square();
  Discretisation<2> grid(mesh);
  for (const auto& cell : grid.triangulation->active_cell_iterators())
    if (cell->is_locally_owned() && cell->center()[0] < 0.5) cell->set_refine_flag();
  grid.triangulation->execute_coarsening_and_refinement();
  grid.dof_handler->distribute_dofs(grid.element);
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(*grid.dof_handler, relevant);
  const auto constraints = make_constraints(hanging_nodes(*grid.dof_handler, relevant), {});
  unsigned int hanging = 0;
  for (const auto dof : grid.dof_handler->locally_owned_dofs())
    if (constraints.is_constrained(dof)) {
      ++hanging;
      const auto* entries = constraints.get_constraint_entries(dof);
      ASSERT_NE(entries, nullptr);
      ASSERT_EQ(entries->size(), 2U);
      for (const auto& [other, weight] : *entries) EXPECT_EQ(weight, 0.5);
    }
  EXPECT_EQ(dealii::Utilities::MPI::sum(hanging, MPI_COMM_WORLD), 2U * 4U);
}

TEST(Constraints, LinesMayReferToOtherConstrainedUnknowns) {
  const Square square;
  const auto& nodes = square.boundary.nodes;
  std::vector<ConstraintLine> lines{{nodes[0].dofs[0], {{nodes[1].dofs[0], 2.}}, 1.},
                                    {nodes[1].dofs[0], {{nodes[2].dofs[0], 3.}}, 5.}};
  dealii::IndexSet all(square.grid.dof_handler->n_dofs());
  all.add_range(0, square.grid.dof_handler->n_dofs());
  const auto constraints = make_constraints(hanging_nodes(*square.grid.dof_handler, all), lines);
  EXPECT_EQ(constraints.get_inhomogeneity(nodes[0].dofs[0]), 2. * 5. + 1.);
  const auto* entries = constraints.get_constraint_entries(nodes[0].dofs[0]);
  ASSERT_NE(entries, nullptr);
  ASSERT_EQ(entries->size(), 1U);
  EXPECT_EQ(entries->front().first, nodes[2].dofs[0]);
  EXPECT_EQ(entries->front().second, 6.);
}

}  // namespace
}  // namespace geneva::fem::test
