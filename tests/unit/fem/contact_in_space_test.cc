#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/active_set_iteration.h"
#include "fem/contact_problem.h"
#include "fem/resultants.h"
#include "fem/rigid_balance.h"
#include "fem/rigid_motion.h"
#include "mesh/extrusion.h"
#include "tests/support/refusal.h"
#include "tests/unit/fem/discretisation.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;
using dealii::Tensor;
using geneva::test::equal_steps;
using loads::test::expect_refused;

/// Two blocks of 2 x 1 x 2 m on each other whose meshes do not match; "upper" stands on "lower".
mesh::MeshData<3> blocks() {
  mesh::MeshData<2> plane = geneva::test::empty_mesh();
  geneva::test::add_rectangle(plane, "lower", equal_steps(0., 2., 3), equal_steps(-1., 0., 2),
                              {"bottom", "", "top of lower", "left"});
  geneva::test::add_rectangle(plane, "upper", equal_steps(0., 2., 2), equal_steps(0., 1., 1),
                              {"bottom of upper", "", "top", "left"});
  return extruded(plane,
                  {{equal_steps(0., 2., 2), "front", ""}, {{0., 0.7, 1.2, 2.}, "front", ""}});
}

/// Pressed on each other by 1e-3 of Young's modulus, free to expand sideways.
Problem<3> pressed(const mesh::MeshData<3>& mesh) {
  Problem<3> problem;
  for (const std::string& body : mesh.bodies) problem.bodies.push_back({body, {2., 0.3}, {}});
  problem.supports = {{"bottom", {std::nullopt, 0., std::nullopt}},
                      {"left", {0., std::nullopt, std::nullopt}},
                      {"front", {std::nullopt, std::nullopt, 0.}}};
  problem.loads = {{"top", 2e-3, {}}};
  return problem;
}

struct Solved {
  Level<3> level;
  LevelState state;
};

Solved solve(const mesh::MeshData<3>& mesh, const Problem<3>& problem, const std::string& source,
             const std::string& target, const Discretisation<3>& grid) {
  Problem<3> with_pair = problem;
  with_pair.pairs = {{source, target}};
  std::optional<SurfaceOrigins<3>> origins;
  Settings settings;
  settings.linear_tolerance = 1e-13;
  Level<3> level = make_level(*grid.dof_handler, mesh, with_pair, {1., 1.}, origins);
  Vector guess(level.owned, MPI_COMM_WORLD);
  auto state =
      solve_level(*grid.dof_handler, level, guess, settings, [](unsigned int, unsigned int) {});
  return {std::move(level), std::move(state.value())};
}

/// Refines the cells around a point of the lower block's upper side, which leaves hanging nodes.
void refine_in_part(Discretisation<3>& grid) {
  for (const auto& cell : grid.dof_handler->active_cell_iterators())
    if (cell->is_locally_owned() && cell->material_id() == 0 &&
        cell->center().distance(Point<3>(0.5, 0., 0.5)) < 0.7)
      cell->set_refine_flag();
  grid.triangulation->execute_coarsening_and_refinement();
  grid.dof_handler->distribute_dofs(grid.element);
}

TEST(ContactInSpace, TransmitsConstantPressureBetweenMeshesThatDoNotMatch) {
  const mesh::MeshData<3> mesh = blocks();
  for (const bool has_hanging_nodes : {false, true}) {
    Discretisation<3> grid(mesh, 1);
    if (has_hanging_nodes) refine_in_part(grid);
    const Solved solved = solve(mesh, pressed(mesh), "bottom of upper", "top of lower", grid);
    const ContactState& contact = solved.state.contacts.front();
    ASSERT_FALSE(contact.pressure.empty());
    for (const double pressure : contact.pressure)
      EXPECT_NEAR(pressure, 2e-3, 1e-9 * 2e-3) << has_hanging_nodes;
    for (const double gap : contact.gap) EXPECT_NEAR(gap, 0., 1e-12);
  }
}

TEST(ContactInSpace, ForcesOfBothSidesCancel) {
  const mesh::MeshData<3> mesh = blocks();
  Discretisation<3> grid(mesh, 1);
  refine_in_part(grid);
  Problem<3> problem = pressed(mesh);
  problem.bodies[1].force.uniform = {4e-4, -1e-3, -3e-4};
  const Solved solved = solve(mesh, problem, "bottom of upper", "top of lower", grid);
  const ContactInterface<3>& interface = solved.level.interfaces.front();
  const auto force_on = [&](const Surface<3>& surface) {
    Tensor<1, 3> sum;
    for (const SurfaceNode<3>& node : surface.nodes)
      for (unsigned int c = 0; c < 3; ++c)
        if (solved.level.held.count(node.dofs[c]) == 0) sum[c] += solved.state.forces(node.dofs[c]);
    return sum;
  };
  double resultant = 0.;
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    resultant += interface.rows[i].weight * solved.state.contacts[0].pressure[i];
  EXPECT_NEAR(force_on(interface.source)[1], resultant, 1e-10 * resultant);
  EXPECT_NEAR(force_on(interface.target)[1], -resultant, 1e-10 * resultant);
}

/// The upper block slides on the lower one, pushed by its weight. With aggregates of both bodies'
/// nodes the second mesh takes 1.5 times as many as the first.
TEST(ContactInSpace, TakesHardlyMoreIterationsOnFineMeshesThanOnCoarseOnes) {
  const mesh::MeshData<3> mesh = blocks();
  Problem<3> problem = pressed(mesh);
  problem.bodies[1].force.uniform = {4e-4, -1e-3, -3e-4};
  std::vector<unsigned int> iterations;
  for (const unsigned int refinements : {2U, 3U}) {
    const Discretisation<3> grid(mesh, refinements);
    const Solved solved = solve(mesh, problem, "bottom of upper", "top of lower", grid);
    iterations.push_back(solved.state.linear_iterations.back());
  }
  EXPECT_LT(iterations[1], 1.25 * iterations[0]);
}

TEST(ContactInSpace, ReactionsBalanceLoadsAndTheirMoments) {
  Solution<3> solution;
  solution.mesh = blocks();
  solution.problem = pressed(solution.mesh);
  solution.problem.bodies[1].force.uniform = {4e-4, -1e-3, -3e-4};
  solution.scales = {1., 1.};
  Discretisation<3> grid(solution.mesh, 1);
  refine_in_part(grid);
  const Solved solved =
      solve(solution.mesh, solution.problem, "bottom of upper", "top of lower", grid);
  solution.triangulation = std::move(grid.triangulation);
  solution.dof_handler = std::move(grid.dof_handler);
  solution.element = std::make_unique<dealii::FESystem<3>>(dealii::FE_Q<3>(1), 3);
  const AppliedLoad<3> load = applied_load(solution, solved.level);
  EXPECT_NEAR(load.force[1], -2e-3 * 4. - 1e-3 * 4., 1e-15);
  Tensor<1, 3> force({load.force[0], load.force[1], load.force[2]});
  Tensor<1, 3> moment = load.moment;
  for (const Reaction<3>& reaction : reactions(solution, solved.level, solved.state)) {
    force += Tensor<1, 3>({reaction.force[0], reaction.force[1], reaction.force[2]});
    moment += reaction.moment;
  }
  EXPECT_NEAR(force.norm(), 0., 1e-12);
  EXPECT_NEAR(moment.norm(), 0., 1e-12);
}

/// The upper block, 2 x 1 x 2, under a body force (x, -1, z): the resultant leaves its underside
/// where x or z is 2, and the cone of friction where the two together are mu.
TEST(RigidBalance, FindsWhetherABlockSlidesTipsOrStays) {
  const mesh::MeshData<3> mesh = blocks();
  const Discretisation<3> grid(mesh);
  const auto motion_under = [&](const double x, const double z, const double friction) {
    Problem<3> problem = pressed(mesh);
    problem.supports = {{"bottom", {0., 0., 0.}}};
    problem.loads.clear();
    problem.pairs = {{"bottom of upper", "top of lower"}};
    problem.pairs[0].friction.coefficient = friction;
    problem.bodies[1].force.uniform = {x, -1., z};
    std::optional<SurfaceOrigins<3>> origins;
    const Level<3> level = make_level(*grid.dof_handler, mesh, problem, {1., 1.}, origins);
    return unresisted_motion(*grid.dof_handler, level, problem);
  };
  EXPECT_FALSE(motion_under(0., 0., 0.));
  EXPECT_FALSE(motion_under(1.9, -1.9, 5.));
  EXPECT_FALSE(motion_under(0.35, -0.35, 0.5));
  const auto tipping = motion_under(0., 2.1, 5.);
  ASSERT_TRUE(tipping);
  EXPECT_EQ(tipping->what, "body 'upper' can rotate about x freely");
  EXPECT_TRUE(tipping->is_rotation);
  const auto sliding = motion_under(0.6, 0., 0.5);
  ASSERT_TRUE(sliding);
  EXPECT_EQ(sliding->what, "body 'upper' can move along x freely");
  EXPECT_FALSE(sliding->is_rotation);
  EXPECT_TRUE(motion_under(0.37, 0.37, 0.5));
}

TEST(ContactInSpace, FindsTheBodyThatIsFreeToMove) {
  const mesh::MeshData<3> mesh = blocks();
  const Discretisation<3> grid(mesh);
  const auto level_of = [&](const Problem<3>& problem) {
    std::optional<SurfaceOrigins<3>> origins;
    return make_level(*grid.dof_handler, mesh, problem, {1., 1.}, origins);
  };
  Problem<3> problem = pressed(mesh);
  problem.pairs = {{"bottom of upper", "top of lower"}};
  EXPECT_NO_THROW(check_rigid_motions(level_of(problem), problem));
  problem.supports.pop_back();
  expect_refused([&] { check_rigid_motions(level_of(problem), problem); },
                 {"can move along z freely", "do not hold it"});
  problem.supports = {{"front", {0., 0., 0.}}};
  EXPECT_NO_THROW(check_rigid_motions(level_of(problem), problem));
}

TEST(NestedIterationInSpace, RefinesTheContactZoneEvenlyAndKeepsAConstantPressure) {
  const mesh::MeshData<3> mesh = blocks();
  Problem<3> problem = pressed(mesh);
  problem.pairs = {{"bottom of upper", "top of lower"}};
  Settings settings;
  settings.linear_tolerance = 1e-13;
  const Solution<3> solution = solve_contact(MPI_COMM_WORLD, mesh, problem, settings, {});
  EXPECT_EQ(solution.stop.outcome, Outcome::converged);
  ASSERT_GE(solution.history.size(), 2U);
  EXPECT_GT(solution.history.back().active_nodes, solution.history.front().active_nodes);
  const ContactResult<3>& contact = solution.contacts.front();
  EXPECT_NEAR(contact.peak_pressure, 2e-3, 1e-9 * 2e-3);
  EXPECT_NEAR(contact.force[1], 2e-3 * 4., 1e-9);
  EXPECT_EQ(contact.active_nodes, contact.nodes.size());
  EXPECT_EQ(contact.source_circle, -1);
  const Tensor<1, 3> moment = contact.moment;  // about the origin, of a force through (1, y, 1)
  EXPECT_NEAR(
      (moment - dealii::cross_product_3d(Tensor<1, 3>({1., 0., 1.}), Tensor<1, 3>({0., 8e-3, 0.})))
          .norm(),
      0., 1e-9);
}

}  // namespace
}  // namespace geneva::fem::test
