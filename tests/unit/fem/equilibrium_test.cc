#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "fem/active_set_iteration.h"
#include "fem/contact/result.h"
#include "fem/contact/zone.h"
#include "fem/contact_problem.h"
#include "fem/equilibrium.h"
#include "tests/support/line_contact.h"
#include "tests/unit/fem/discretisation.h"
#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {
namespace {

using dealii::Tensor;
using geneva::test::LineContact;

/// A load so heavy that the contact is wide on the coarse mesh: about R/2 to either side.
LineContact heavy(const bool block_is_source) {
  LineContact contact;
  contact.force = 2e6;
  contact.cells_around = 40;
  contact.turn = 0.3;
  contact.block_cell = 0.21;
  contact.shift = 0.17;
  contact.block_is_source = block_is_source;
  return contact;
}

/// A contact problem solved on its coarse mesh, with everything that a Solution does not keep.
struct CoarseSolution {
  explicit CoarseSolution(const LineContact& contact)
      : mesh(mesh_of(contact)),
        problem(problem_of(contact)),
        scales(scales_of(problem, mesh)),
        grid(geneva::test::enlarged(mesh, 1. / scales.length)),
        level(make_level(*grid.dof_handler, mesh, scaled(problem, scales), scales, origins)) {
    Vector guess(level.owned, MPI_COMM_WORLD);
    auto solved =
        solve_level(*grid.dof_handler, level, guess, {}, [](unsigned int, unsigned int) {});
    if (solved) state.emplace(std::move(*solved));
  }

  mesh::MeshData<2> mesh;
  Problem<2> problem;
  Scales scales;
  Discretisation<2> grid;
  std::optional<SurfaceOrigins<2>> origins;
  Level<2> level;
  std::optional<LevelState> state;
};

/// Sum of the forces at the nodes of a surface: the force that acts on it beside the known loads.
Tensor<1, 2> force_on(const CoarseSolution& solution, const Surface<2>& surface) {
  Tensor<1, 2> sum;
  for (const SurfaceNode<2>& node : surface.nodes)
    for (unsigned int c = 0; c < 2; ++c) sum[c] += solution.state->forces(node.dofs[c]);
  return sum * solution.scales.force();
}

/// Conjugate gradients stop at 1e-10 of the load: forces agree to a small multiple of it.
constexpr double solver_tolerance = 1e-9;

void ignore_steps(unsigned int /*step*/, unsigned int /*iterations*/) {}

Equilibrium<2> equilibrium_of(const LineContact& contact) {
  const mesh::MeshData<2> mesh = mesh_of(contact);
  const Problem<2> problem = problem_of(contact);
  return {MPI_COMM_WORLD, mesh, problem, scales_of(problem, mesh)};
}

void expect_same_pressures(const LevelState& one, const LevelState& other) {
  const auto& pressure = one.contacts.front().pressure;
  const double peak = *std::max_element(pressure.begin(), pressure.end());
  ASSERT_GT(peak, 0.);
  for (std::size_t i = 0; i < pressure.size(); ++i)
    EXPECT_NEAR(other.contacts.front().pressure[i], pressure[i], solver_tolerance * peak);
}

TEST(Equilibrium, IsWhereASolveThatStartsFromItEnds) {
  Equilibrium<2> equilibrium = equilibrium_of(heavy(false));
  State<2> state = equilibrium.at_rest();
  const auto first = std::get<LevelState>(equilibrium.advance(state, {}, {}, ignore_steps));
  state = equilibrium.end_of_instant(std::move(state), first);
  const auto second = std::get<LevelState>(equilibrium.advance(state, {}, {}, ignore_steps));
  EXPECT_EQ(second.linear_iterations.size(), 1U);
  expect_same_pressures(first, second);
}

TEST(Equilibrium, IsTheSameByTheLibrarysSolver) {
  Settings settings;
  settings.linear_solver = LinearSolver::own;
  Equilibrium<2> equilibrium = equilibrium_of(heavy(false));
  const auto own =
      std::get<LevelState>(equilibrium.advance(equilibrium.at_rest(), {}, settings, ignore_steps));
  settings.linear_solver = LinearSolver::library;
  Equilibrium<2> other = equilibrium_of(heavy(false));
  expect_same_pressures(
      own, std::get<LevelState>(other.advance(other.at_rest(), {}, settings, ignore_steps)));
}

Solved not_converged() { return Stop{Outcome::linear_solver}; }

/// By which solvers a solution is tried, in which ours never converges and the library's always.
std::vector<LinearSolver> tried(const LinearSolver chosen) {
  Settings settings;
  settings.linear_solver = chosen;
  std::vector<LinearSolver> solvers;
  with_fallback(settings, [&](const Settings& with) -> Solved {
    solvers.push_back(with.linear_solver);
    if (with.linear_solver == LinearSolver::library) return LevelState{};
    return not_converged();
  });
  return solvers;
}

TEST(LinearSolvers, TheLibrarysTakesOverWhereOursDoesNotConvergeUnlessOneIsChosen) {
  using Solvers = std::vector<LinearSolver>;
  EXPECT_EQ(tried(LinearSolver::automatic),
            (Solvers{LinearSolver::automatic, LinearSolver::library}));
  EXPECT_EQ(tried(LinearSolver::own), Solvers{LinearSolver::own});
  EXPECT_EQ(tried(LinearSolver::library), Solvers{LinearSolver::library});
}

TEST(LinearSolvers, OnlyAFailureOfTheLinearSolverIsTriedAgain) {
  for (const bool is_solved : {true, false}) {
    int n_tries = 0;
    const Solved result = with_fallback({}, [&](const Settings&) -> Solved {
      ++n_tries;
      if (is_solved) return LevelState{};
      return Stop{Outcome::active_set_limit};
    });
    EXPECT_EQ(n_tries, 1);
    EXPECT_EQ(std::holds_alternative<LevelState>(result), is_solved);
  }
}

TEST(LinearSolvers, TheResultOfTheSecondTryStands) {
  EXPECT_EQ(
      std::get<Stop>(with_fallback({}, [](const Settings&) { return not_converged(); })).outcome,
      Outcome::linear_solver);
}

/// Without friction the way there does not matter.
TEST(Equilibrium, DependsOnTheLoadOfItsInstantAlone) {
  const LineContact contact = heavy(false);
  Equilibrium<2> equilibrium = equilibrium_of(contact);
  State<2> state = equilibrium.at_rest();
  const Load half{{}, {}, {0.5}, {}};
  const auto at_half = std::get<LevelState>(equilibrium.advance(state, half, {}, ignore_steps));
  state = equilibrium.end_of_instant(std::move(state), at_half);
  const auto at_full = std::get<LevelState>(equilibrium.advance(state, {}, {}, ignore_steps));

  LineContact halved = contact;
  halved.force *= 0.5;
  Equilibrium<2> light = equilibrium_of(halved);
  expect_same_pressures(at_half,
                        std::get<LevelState>(light.advance(light.at_rest(), {}, {}, ignore_steps)));
  Equilibrium<2> anew = equilibrium_of(contact);
  expect_same_pressures(at_full,
                        std::get<LevelState>(anew.advance(anew.at_rest(), {}, {}, ignore_steps)));
}

/// Linear functions on the coarse cells are linear on their children.
TEST(Equilibrium, TakesADisplacementOverToAFinerMesh) {
  Equilibrium<2> equilibrium = equilibrium_of(heavy(false));
  State<2> state = equilibrium.at_rest();
  const auto found = std::get<LevelState>(equilibrium.advance(state, {}, {}, ignore_steps));
  const double maximum = found.displacement.linfty_norm();
  const auto unknowns = equilibrium.n_unknowns();
  equilibrium.mesh().triangulation->set_all_refine_flags();
  state = equilibrium.refine(found.displacement, std::move(state));
  EXPECT_GT(equilibrium.n_unknowns(), 3 * unknowns);
  EXPECT_DOUBLE_EQ(state.displacement.linfty_norm(), maximum);
  EXPECT_TRUE(std::holds_alternative<LevelState>(equilibrium.advance(state, {}, {}, ignore_steps)));
}

TEST(Equilibrium, SaysWhyItWasNotFound) {
  Equilibrium<2> equilibrium = equilibrium_of(heavy(false));
  Settings settings;
  settings.max_active_set_steps = 1;
  const auto result = equilibrium.advance(equilibrium.at_rest(), {}, settings, ignore_steps);
  ASSERT_TRUE(std::holds_alternative<Stop>(result));
  EXPECT_EQ(std::get<Stop>(result).outcome, Outcome::active_set_limit);
  EXPECT_EQ(std::get<Stop>(result).unknowns, equilibrium.n_unknowns());
}

TEST(ContactForces, OfBothSidesCancelAndCarryTheLoad) {
  for (const bool block_is_source : {false, true}) {
    const LineContact contact = heavy(block_is_source);
    const CoarseSolution solution(contact);
    ASSERT_TRUE(solution.state.has_value());
    const ContactInterface<2>& interface = solution.level.interfaces.front();
    ASSERT_GE(zone_intervals(interface).size(), 1U);
    const Tensor<1, 2> on_source = force_on(solution, interface.source);
    const Tensor<1, 2> on_target = force_on(solution, interface.target);
    EXPECT_LT((on_source + on_target).norm(), solver_tolerance * contact.force);
    EXPECT_NEAR(on_source[1], block_is_source ? -contact.force : contact.force,
                solver_tolerance * contact.force);

    const ContactResult<2> result = contact_result(solution.problem.pairs[0], interface,
                                                   solution.state->contacts[0], solution.scales);
    EXPECT_GE(result.active_nodes, 5U);
    for (unsigned int c = 0; c < 2; ++c)
      EXPECT_NEAR(result.force[c], on_source[c], solver_tolerance * contact.force)
          << "the pressure's resultant is the nodes' force";
  }
}

TEST(ContactForces, ActiveNodesAreClosedAndPressedInactiveOnesOpenAndFree) {
  for (const bool block_is_source : {false, true}) {
    const CoarseSolution solution(heavy(block_is_source));
    ASSERT_TRUE(solution.state.has_value());
    const ContactInterface<2>& interface = solution.level.interfaces.front();
    const ContactState& contact = solution.state->contacts.front();
    for (std::size_t i = 0; i < interface.rows.size(); ++i) {
      if (is_closed(interface.status[i])) {
        // Displacements of about 0.1 of the mesh's size, to the solver's tolerance.
        EXPECT_NEAR(contact.gap[i], 0., solver_tolerance);
        EXPECT_GE(contact.pressure[i], 0.);
      } else {
        EXPECT_GE(contact.gap[i], -solver_tolerance);
        EXPECT_EQ(contact.pressure[i], 0.);
      }
    }
  }
}

TEST(ContactForces, ThereIsNoFrictionAtAnyNode) {
  const CoarseSolution solution(heavy(true));
  ASSERT_TRUE(solution.state.has_value());
  const ContactInterface<2>& interface = solution.level.interfaces.front();
  for (const ContactRow<2>& row : interface.rows) {
    const SurfaceNode<2>& node = interface.source.nodes[row.node];
    const double along = -row.frame.normal[1] * solution.state->forces(node.dofs[0]) +
                         row.frame.normal[0] * solution.state->forces(node.dofs[1]);
    EXPECT_NEAR(along * solution.scales.force(), 0., solver_tolerance * 2e6);
  }
  const ContactState& contact = solution.state->contacts.front();
  const double peak = *std::max_element(contact.pressure.begin(), contact.pressure.end());
  for (const Tangential& friction : contact.friction) {
    EXPECT_NEAR(friction[0], 0., 1e-6 * peak) << "the forces' error over small areas";
    EXPECT_EQ(friction[1], 0.);
  }
}

/// Runs the nested iteration for a few levels.
Solution<2> solved(const LineContact& contact, const Problem<2>& problem) {
  Settings settings;
  settings.max_levels = 2;
  settings.linear_tolerance = 1e-13;
  return solve_contact(MPI_COMM_WORLD, mesh_of(contact), problem, settings, {});
}

TEST(Reactions, OfSupportAndTieAreTheLoad) {
  for (const bool block_is_source : {false, true}) {
    const LineContact contact = heavy(block_is_source);
    const Solution<2> solution = solved(contact, problem_of(contact));
    ASSERT_EQ(solution.reactions.size(), 2U);
    const Reaction<2>& support = solution.reactions[0];
    const Reaction<2>& tie = solution.reactions[1];
    const double tolerance = solver_tolerance * contact.force;
    EXPECT_EQ(support.surface, "bottom");
    EXPECT_NEAR(support.force[1], contact.force, tolerance);
    EXPECT_EQ(tie.surface, "core");
    EXPECT_NEAR(tie.force[1], -contact.force, tolerance);
    EXPECT_NEAR(support.force[0] + tie.force[0], 0., tolerance) << "both hold the bodies along x";
    EXPECT_EQ(solution.applied_force, (std::array<double, 2>{0., 0.}));
    const ContactResult<2>& result = solution.contacts[0];
    const double on_cylinder = block_is_source ? -1. : 1.;
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_NEAR(on_cylinder * result.force[c] + tie.force[c], 0., tolerance);
  }
}

TEST(Reactions, CarryBodyForcesAndSurfaceLoadsToo) {
  const LineContact contact = heavy(false);
  Problem<2> problem = problem_of(contact);
  problem.bodies[1].force.uniform = {1e9, -2e9};
  problem.bodies[1].force.rotation = {0.5, 0., 200.};
  problem.loads = {{"core", 1e8, {0., 0.}}, {"top", 0., {3e7, 0.}}};
  const Solution<2> solution = solved(contact, problem);
  const double volume = 0.08 * 0.04 * contact.thickness;
  // Euler force m alpha (y, -x) at the block's centre (0, -0.02 m); m = J over the square of the
  // radius of gyration about the origin.
  const double euler = 0.5 / (0.02 * 0.02 + (0.08 * 0.08 + 0.04 * 0.04) / 12.) * 200. * -0.02;
  const double tolerance = solver_tolerance * contact.force;
  EXPECT_NEAR(solution.applied_force[0], 1e9 * volume + 3e7 * 0.08 * contact.thickness + euler,
              tolerance);
  EXPECT_NEAR(solution.applied_force[1], -2e9 * volume, tolerance)
      << "pressure all around the core has no resultant";
  EXPECT_NEAR(solution.applied_moment, 0.02 * 1e9 * volume - 0.5 * 200., tolerance * 0.08);
  std::array<double, 2> sum = solution.applied_force;
  double moment = solution.applied_moment;
  for (const Reaction<2>& reaction : solution.reactions) {
    for (std::size_t c = 0; c < 2; ++c) sum[c] += reaction.force[c];
    moment += reaction.moment;
  }
  for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(sum[c], 0., tolerance);
  // The points of cylinder and block that meet are apart by the height of the chord's arc,
  // h^2/(8 R), off the normal by the contact's angle (0.5 at its ends), to either side.
  const double edge = 2. * pi * contact.radius / contact.cells_around / 4.;
  EXPECT_NEAR(moment, 0., contact.force * edge * edge / (8. * contact.radius) * 0.5);
}

/// A plane of symmetry without friction pulls across itself only, also where a tie meets it.
TEST(Reactions, OfAPlaneOfSymmetryHaveNoForceAlongIt) {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  const double R = 0.01;
  geneva::test::add_ring(mesh, "cylinder",
                         {{0., R},
                          {0.5 * R, 0.75 * R, R},
                          geneva::test::equal_steps(-pi / 2., pi / 2., 20),
                          "core",
                          "cylinder",
                          "plane",
                          "plane"});
  geneva::test::add_rectangle(mesh, "block", geneva::test::equal_steps(0., 4. * R, 20),
                              geneva::test::equal_steps(-4. * R, 0., 20),
                              {"bottom", "", "top", "plane"});
  LineContact contact = heavy(false);
  Problem<2> problem = problem_of(contact);
  problem.supports = {{"plane", {0., std::nullopt}}, {"bottom", {std::nullopt, 0.}}};
  Settings settings;
  settings.max_levels = 1;
  const Solution<2> solution = solve_contact(MPI_COMM_WORLD, mesh, problem, settings, {});
  ASSERT_EQ(solution.reactions.size(), 3U);
  const double tolerance = solver_tolerance * contact.force;
  EXPECT_NEAR(solution.reactions[0].force[1], 0., tolerance);
  EXPECT_NEAR(solution.reactions[1].force[0], 0., tolerance);
  EXPECT_NEAR(solution.reactions[1].force[1], contact.force, tolerance);
  EXPECT_NEAR(solution.reactions[2].force[1], -contact.force, tolerance);
}

/// A straight bar or tube without lateral contraction, pulled along y.
TEST(HeldTractions, BalanceAUniformLoad) {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_rectangle(mesh, "bar", {0.01, 0.02, 0.05}, {0., 0.03, 0.08},
                              {"foot", "", "top", ""});
  for (const PlaneKind plane :
       {PlaneKind::plane_strain, PlaneKind::plane_stress, PlaneKind::axisymmetric})
    for (const double thickness : {0.004, 3.}) {
      Problem<2> problem;
      problem.plane = plane;
      problem.thickness = thickness;
      problem.bodies = {{"bar", {200e9, 0.}, {}}};
      problem.supports = {{"foot", {0., 0.}}};
      problem.loads = {{"top", 0., {0., 3e7}}};
      Settings settings;
      settings.max_levels = 2;
      const Solution<2> solution = solve_contact(MPI_COMM_WORLD, mesh, problem, settings, {});
      ASSERT_FALSE(solution.held_tractions.empty());
      for (const auto& [dof, traction] : solution.held_tractions)
        EXPECT_NEAR(std::min(std::abs(traction), std::abs(traction + 3e7)), 0., 30.)
            << "none across the bar, and the load along it";
      double sum = 0.;
      for (const auto& [dof, traction] : solution.held_tractions) sum += traction;
      EXPECT_NEAR(sum / static_cast<double>(solution.held_tractions.size()), -1.5e7, 30.);
    }
}

/// Where it meets a plane of symmetry, which holds another component, too.
TEST(HeldTractions, OfACornerAreThoseOfTheSurfaceThatHoldsTheComponent) {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_rectangle(mesh, "bar", {0.01, 0.02, 0.05}, {0., 0.03, 0.08},
                              {"foot", "", "top", "middle"});
  Problem<2> problem;
  problem.thickness = 0.004;
  problem.bodies = {{"bar", {200e9, 0.}, {}}};
  problem.supports = {{"foot", {std::nullopt, 0.}}, {"middle", {0., std::nullopt}}};
  problem.loads = {{"top", 0., {0., 3e7}}};
  Settings settings;
  settings.max_levels = 1;
  const Solution<2> solution = solve_contact(MPI_COMM_WORLD, mesh, problem, settings, {});
  for (const auto& [dof, traction] : solution.held_tractions)
    EXPECT_NEAR(std::min(std::abs(traction), std::abs(traction + 3e7)), 0., 30.)
        << "the load along the bar, none across it";
}

}  // namespace
}  // namespace geneva::fem::test
