#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/refusal.h"
#include "tests/support/solving.h"
#include "tests/support/structured_mesh.h"

namespace geneva::test {
namespace {

const double pi = std::acos(-1.);
const fem::Material steel{2e11, 0.3};

/// A sphere on a block, both as bodies of revolution.
mesh::MeshData<2> sphere_on_block(const double R) {
  mesh::MeshData<2> mesh = empty_mesh();
  add_ring(mesh, "sphere",
           {{0., R},
            equal_steps(0.25 * R, R, 3),
            equal_steps(-pi / 2., pi / 2., 12),
            "core",
            "sphere",
            "axis",
            "axis"});
  add_rectangle(mesh, "block", equal_steps(0., 4. * R, 9), equal_steps(-4. * R, 0., 9),
                {"bottom", "", "top", "axis"});
  return mesh;
}

fem::Problem<2> sphere_on_block_problem(const double force, const fem::Material& material = steel) {
  fem::Problem<2> problem;
  problem.plane = fem::PlaneKind::axisymmetric;
  problem.bodies = {{"sphere", material, {}}, {"block", material, {}}};
  problem.supports = {{"axis", {0., std::nullopt}}, {"bottom", {0., 0.}}};
  problem.ties = {{"core", {0., -1.}, force}};
  problem.pairs = {{"sphere", "top"}};
  return problem;
}

/// K. L. Johnson, Contact Mechanics, 1985, Eq. 4.22 (radius) and 4.24 (peak pressure).
///
/// R/a = 54: the half-spaces of Hertz neglect (a/R)^2 = 3e-4. The ring of radius h about the axis
/// carries the weight h^2, so that the pressure there is twice as uncertain as in a plane: 1 %.
TEST(JohnsonContactMechanics, Eq422And424SphereOnBlock) {
  const double R = 0.01;
  const double force = 100.;
  const mesh::MeshData<2> mesh = sphere_on_block(R);
  for (const auto& [nu, block_is_source] :
       {std::pair{0.3, false}, std::pair{0.3, true}, std::pair{0.4999, false}}) {
    fem::Problem<2> problem = sphere_on_block_problem(force, {2e11, nu});
    const auto exact =
        loads::hertz_point(force, R, loads::contact_modulus({2e11, nu}, {2e11, nu}), nu);
    if (block_is_source) problem.pairs = {{"top", "sphere"}};
    const fem::Solution<2> solution = solve(mesh, problem);
    EXPECT_EQ(solution.stop.outcome, fem::Outcome::converged);
    const fem::ContactResult<2>& contact = solution.contacts[0];
    EXPECT_NEAR(error_of(contact.peak_pressure, exact.peak_pressure), 0., 0.01) << contact.source;
    EXPECT_NEAR(error_of(contact.half_width, exact.contact_radius), 0., 0.02) << contact.source;
    EXPECT_NEAR(std::abs(contact.force[1]), force, 1e-8 * force);
    EXPECT_TRUE(contact.symmetric);
    const auto form = post::closed_form(solution, contact);
    ASSERT_TRUE(form && form->point);
    EXPECT_NEAR(error_of(form->peak_pressure(), exact.peak_pressure), 0., 1e-8);
  }
}

/// The contact is a tenth of the sphere's radius wide: the pressure turns by 6 deg, and what it
/// adds up to along the radius is 6 % of the load, which no support carries.
TEST(Resultant, OfASphereIsItsAxialLoad) {
  const double R = 0.01;
  const double force = std::pow(0.1, 3) * R * R / 0.75 *
                       loads::contact_modulus({2e11, 0.3}, {2e11, 0.3});  // Johnson, Eq. 4.22
  for (const bool block_is_source : {false, true}) {
    fem::Problem<2> problem = sphere_on_block_problem(force);
    if (block_is_source) problem.pairs = {{"top", "sphere"}};
    const fem::Solution<2> solution = solve(sphere_on_block(R), problem);
    const fem::ContactResult<2>& contact = solution.contacts[0];
    EXPECT_NEAR(error_of(contact.half_width, 0.1 * R), 0., 0.05);
    EXPECT_NEAR(fem::magnitude(contact.force), force, 1e-8 * force);
    if (block_is_source) {
      EXPECT_GT(std::abs(contact.lateral_force[0]), 0.02 * force) << "the target's normals turn";
    }
    const auto form = post::closed_form(solution, contact);
    ASSERT_TRUE(form);
    EXPECT_NEAR(form->force, force, 1e-8 * force);
  }
}

/// The maximum shear below a circle grows as Poisson's ratio falls: it is in the body with the
/// smaller one, and that of the closed form is meant there.
TEST(SphereOnBlock, HasItsMaximumShearInTheBodyWithTheSmallerPoissonsRatio) {
  const double R = 0.01;
  fem::Problem<2> problem = sphere_on_block_problem(100.);
  problem.bodies = {{"sphere", {2e11, 0.1}, {}}, {"block", {2e11, 0.4}, {}}};
  const fem::Solution<2> solution = solve(sphere_on_block(R), problem);
  const post::ContactAnalysis<2> analysis = post::analyse(solution).contacts[0];
  ASSERT_TRUE(analysis.hertz);
  EXPECT_NEAR(error_of(analysis.max_shear.value, analysis.hertz->max_shear()), 0., 0.02);
  EXPECT_NEAR(error_of(analysis.max_shear_depth, analysis.hertz->max_shear_depth()), 0., 0.03);
}

/// The node on the axis stands for next to nothing and may carry less than its neighbour: the
/// radius is still that from the axis to the free end, on coarse meshes as well.
TEST(ContactRadius, IsCountedFromTheAxisOnEveryMesh) {
  const double R = 0.01;
  for (const double force : {1e-4, 1., 100.})
    for (const bool block_is_source : {false, true}) {
      fem::Problem<2> problem = sphere_on_block_problem(force);
      if (block_is_source) problem.pairs = {{"top", "sphere"}};
      unsigned int meshes = 0;
      const auto check = [&](const fem::Solution<2>& solution) {
        const fem::ContactResult<2>& contact = solution.contacts[0];
        if (contact.active_nodes < 2) return;
        EXPECT_TRUE(contact.symmetric) << contact.source << ", " << contact.active_nodes;
        ++meshes;
      };
      solve_contact(MPI_COMM_WORLD, sphere_on_block(R), problem, fem::Settings(),
                    {{}, {}, check, {}});
      EXPECT_GE(meshes, 3U) << "the observer sees every mesh";
    }
}

/// A cylinder in a cup of nearly its own radius, the half to the right of the plane of symmetry:
/// the pressure turns by 60 deg and presses the halves apart, which the plane takes.
TEST(Resultant, OfAHalfModelLeavesOutWhatItsPlaneOfSymmetryTakes) {
  const double R = 0.01;
  const double cup = 1.001 * R;
  const double force = 1e5;
  mesh::MeshData<2> mesh = empty_mesh();
  add_ring(mesh, "cylinder",
           {{0., R},
            equal_steps(0.25 * R, R, 3),
            equal_steps(-pi / 2., pi / 2., 12),
            "core",
            "cylinder",
            "plane",
            "plane"});
  add_ring(mesh, "cup",
           {{0., cup},
            equal_steps(cup, 3. * R, 4),
            equal_steps(-pi / 2., 0., 7),
            "cup",
            "outside",
            "plane",
            ""});
  fem::Problem<2> problem;
  problem.thickness = 0.02;
  problem.bodies = {{"cylinder", steel, {}}, {"cup", steel, {}}};
  problem.supports = {{"plane", {0., std::nullopt}}, {"outside", {0., 0.}}};
  problem.ties = {{"core", {0., -1.}, force}};
  for (const bool cup_is_source : {false, true}) {
    problem.pairs = {{"cylinder", "cup"}};
    if (cup_is_source) problem.pairs = {{"cup", "cylinder"}};
    const fem::Solution<2> solution = solve(mesh, problem, with_accuracy(0.02));
    const fem::ContactResult<2>& contact = solution.contacts[0];
    EXPECT_NEAR(fem::magnitude(contact.force), force, 1e-8 * force) << contact.source;
    EXPECT_GT(fem::magnitude(contact.lateral_force), 0.1 * force);
    const auto form = post::closed_form(solution, contact);
    ASSERT_TRUE(form);
    EXPECT_NEAR(form->force, 2. * force, 1e-8 * force) << "of the whole";
  }
}

/// Two cylinders under a block, 6 R apart.
/// @param depth of the right one below the left one [R]
mesh::MeshData<2> two_cylinders(const double R, const double depth) {
  mesh::MeshData<2> mesh = empty_mesh();
  for (const double side : {-1., 1.}) {
    const std::string name = side < 0. ? "left" : "right";
    add_ring(mesh, name,
             {{3. * side * R, side < 0. ? -R : -R - depth * R},
              equal_steps(0.25 * R, R, 3),
              equal_steps(0., 2. * pi, 24),
              name + " core",
              name,
              "",
              ""});
  }
  add_rectangle(mesh, "block", equal_steps(-6. * R, 6. * R, 24), equal_steps(0., 4. * R, 8),
                {"under", "", "lid", ""});
  return mesh;
}

/// The cylinders held at their cores, the block pressed down.
fem::Problem<2> two_cylinders_problem(const LineContact& one) {
  fem::Problem<2> problem;
  problem.thickness = one.thickness;
  problem.bodies = {{"left", steel, {}}, {"right", steel, {}}, {"block", steel, {}}};
  problem.supports = {{"left core", {0., 0.}}, {"right core", {0., 0.}}};
  problem.ties = {{"lid", {0., -1.}, 2. * one.force}};
  problem.pairs = {{"left", "under"}, {"right", "under"}};
  return problem;
}

/// Each carries half the load. One changes the other's contact by the curvature that its load gives
/// the block's surface, of the order (b/6 R)^2.
TEST(JohnsonContactMechanics, Eq445TwoContactsShareTheLoad) {
  const LineContact one;
  const fem::Solution<2> solution =
      solve(two_cylinders(one.radius, 0.), two_cylinders_problem(one));
  ASSERT_EQ(solution.contacts.size(), 2U);
  for (const fem::ContactResult<2>& contact : solution.contacts) {
    EXPECT_NEAR(contact.force[1], -one.force, 1e-8 * one.force)
        << "a mirrored mesh, solved to 1e-10";
    EXPECT_NEAR(error_of(contact.peak_pressure, hertz(one).peak_pressure), 0., 0.005);
    EXPECT_NEAR(error_of(contact.half_width, hertz(one).half_width), 0., 0.02);
  }
  EXPECT_NEAR(solution.reactions[0].force[1], one.force, 1e-8 * one.force);
  EXPECT_NEAR(solution.reactions[1].force[1], one.force, 1e-8 * one.force);
}

/// The left one carries the whole load.
TEST(JohnsonContactMechanics, Eq445OneOfTwoContactsStaysOpen) {
  LineContact one;
  const fem::Solution<2> solution =
      solve(two_cylinders(one.radius, 0.05), two_cylinders_problem(one));
  EXPECT_EQ(solution.stop.outcome, fem::Outcome::converged);
  one.force *= 2.;
  ASSERT_EQ(solution.contacts.size(), 2U);
  EXPECT_NEAR(error_of(solution.contacts[0].peak_pressure, hertz(one).peak_pressure), 0., 0.005);
  EXPECT_EQ(solution.contacts[1].active_nodes, 0U);
  EXPECT_EQ(solution.contacts[1].peak_pressure, 0.);
}

/// Cylinders pressed on a block that is held, one with a hundredth of the other's force: its peak
/// is a tenth. The estimate is that of the maximum pressure.
TEST(JohnsonContactMechanics, Eq445OfTwoContactsOneIsLightlyLoaded) {
  LineContact one;
  fem::Problem<2> problem = two_cylinders_problem(one);
  problem.supports = {{"lid", {0., 0.}}};
  problem.ties = {{"left core", {0., 1.}, one.force}, {"right core", {0., 1.}, 0.01 * one.force}};
  const fem::Solution<2> solution = solve(two_cylinders(one.radius, 0.), problem);
  EXPECT_EQ(solution.stop.outcome, fem::Outcome::converged);
  ASSERT_EQ(solution.contacts.size(), 2U);
  EXPECT_NEAR(error_of(solution.contacts[0].peak_pressure, hertz(one).peak_pressure), 0., 0.005);
  one.force *= 0.01;
  EXPECT_NEAR(error_of(solution.contacts[1].peak_pressure, hertz(one).peak_pressure), 0., 0.05);
}

/// Three blocks on top of each other between frictionless planes, on meshes that match nowhere,
/// under a constant pressure.
mesh::MeshData<2> three_blocks(const std::vector<double>& middle_columns) {
  mesh::MeshData<2> mesh = empty_mesh();
  add_rectangle(mesh, "low", equal_steps(0., 3., 5), equal_steps(0., 1., 2),
                {"bottom", "", "low top", "side"});
  add_rectangle(mesh, "middle", middle_columns, {1., 1.4, 2.},
                {"middle under", "", "middle top", "side"});
  add_rectangle(mesh, "high", equal_steps(0., 3., 7), equal_steps(2., 3., 3),
                {"high under", "", "lid", "side"});
  return mesh;
}

/// Blocks under a pressure on their lid, between frictionless planes.
fem::Problem<2> three_blocks_problem(const double pressure, const double middle_stiffness,
                                     const bool upper_is_source) {
  fem::Problem<2> problem;
  problem.thickness = 0.2;
  problem.bodies = {
      {"low", steel, {}}, {"middle", {middle_stiffness * 2e11, 0.3}, {}}, {"high", steel, {}}};
  problem.supports = {{"side", {0., std::nullopt}}, {"bottom", {std::nullopt, 0.}}};
  problem.loads = {{"lid", pressure, {0., 0.}}};
  problem.pairs = {{"low top", "middle under"}, {"middle top", "high under"}};
  if (upper_is_source) problem.pairs = {{"middle under", "low top"}, {"high under", "middle top"}};
  return problem;
}

/// Expects the pressure at every node of every contact.
void expect_uniform_pressure(const fem::Solution<2>& solution, const double pressure) {
  for (const fem::ContactResult<2>& contact : solution.contacts) {
    EXPECT_EQ(contact.active_nodes, contact.nodes.size());
    for (const fem::ContactNode<2>& node : contact.nodes)
      EXPECT_NEAR(error_of(node.pressure, pressure), 0., 1e-10) << contact.source;
  }
}

/// The patch test of contact: R. L. Taylor and P. Papadopoulos, On a patch test for contact
/// problems in two dimensions (1991). The state is in the finite-element space, so that only the
/// solver's tolerance is left.
TEST(TaylorPapadopoulos, ContactPatchTestOnMeshesThatDoNotMatch) {
  const double pressure = 3e6;
  fem::Settings settings;
  settings.linear_tolerance = 1e-13;
  for (const bool upper_is_source : {false, true})
    for (const double stiffness : {1., 0.1}) {
      const fem::Solution<2> solution =
          solve(three_blocks({0., 0.5, 1.1, 1.7, 2.2, 3.}),
                three_blocks_problem(pressure, stiffness, upper_is_source), settings);
      EXPECT_EQ(solution.stop.outcome, fem::Outcome::converged);
      expect_uniform_pressure(solution, pressure);
      for (const post::CellStress<2>& cell : post::cell_stresses(solution)) {
        // Free to expand to one side, held in the thickness: uniaxial compression.
        EXPECT_NEAR(cell.stress.in_plane[1][1], -pressure, 1e-9 * pressure);
        EXPECT_NEAR(cell.stress.in_plane[0][0], 0., 1e-9 * pressure);
        EXPECT_NEAR(cell.stress.in_plane[0][1], 0., 1e-9 * pressure);
        EXPECT_NEAR(cell.stress.out_of_plane, -0.3 * pressure, 1e-9 * pressure);
      }
      EXPECT_LT(post::analyse(solution).equilibrium.force_residual, 1e-10);
      EXPECT_LT(post::analyse(solution).equilibrium.moment_residual, 1e-10);
      const double force = std::abs(solution.contacts[0].force[1]);
      EXPECT_LT(std::abs(solution.contact_couple), 1e-10 * force * solution.scales.length)
          << "either body feels the pressure at the same place";
    }
}

/// Neighbouring columns of which one is 4.5 times as wide: cells that share a vertex differ by one
/// level at most, so that these edges cannot be made even, and the refinement has to leave them.
TEST(Refinement, EndsOnMeshesThatCannotBeMadeEven) {
  fem::Settings settings;
  settings.linear_tolerance = 1e-13;
  const fem::Solution<2> solution = solve(three_blocks({0., 0.45, 1.1, 1.3, 2.2, 3.}),
                                          three_blocks_problem(3e6, 1., false), settings);
  EXPECT_EQ(solution.stop.outcome, fem::Outcome::converged);
  EXPECT_LT(solution.history.back().dofs, 10000U);
  expect_uniform_pressure(solution, 3e6);
}

TEST(Limits, OfLevelsIsSaidAndTheSolutionIsOfUse) {
  fem::Settings settings;
  settings.max_levels = 6;
  const fem::Solution<2> solution = solve(LineContact(), settings);
  EXPECT_EQ(solution.stop.outcome, fem::Outcome::refinement_limit);
  EXPECT_EQ(solution.stop.limit, 6.);
  EXPECT_GT(solution.error_estimate, settings.accuracy);
  EXPECT_LE(solution.history.size(), 7U);
  ASSERT_EQ(solution.contacts.size(), 1U);
  EXPECT_NEAR(solution.contacts[0].force[1], LineContact().force, 1e-8 * LineContact().force);
  const post::Results<2> results = post::analyse(solution);
  EXPECT_TRUE(results.contacts[0].hertz.has_value());
  EXPECT_LT(results.equilibrium.force_residual, 1e-8);
}

TEST(Limits, OfUnknownsIsSaidAndKept) {
  fem::Settings settings;
  settings.max_dofs = 2000;
  const fem::Solution<2> solution = solve(LineContact(), settings);
  EXPECT_EQ(solution.stop.outcome, fem::Outcome::dof_limit);
  EXPECT_EQ(solution.stop.limit, 2000.);
  EXPECT_GT(solution.stop.needed, 2000.);
  EXPECT_LE(solution.history.back().dofs, 2000U);
  EXPECT_GE(solution.dof_handler->n_dofs(), solution.history.back().dofs)
      << "a mesh that came out too large is not solved, and shows the one before";
  EXPECT_GT(solution.error_estimate, settings.accuracy);
  EXPECT_TRUE(post::analyse(solution).contacts[0].hertz.has_value());
}

TEST(Limits, OfMemoryIsSaid) {
  fem::Settings settings;
  settings.max_memory = 1e6;
  const fem::Solution<2> solution = solve(LineContact(), settings);
  EXPECT_EQ(solution.stop.outcome, fem::Outcome::memory_limit);
  EXPECT_EQ(solution.stop.limit, 1e6);
  EXPECT_GT(solution.stop.needed, 1e6);
  EXPECT_EQ(solution.history.size(), 1U);
}

TEST(Limits, OfActiveSetStepsIsAnErrorWhereNoMeshWasSolved) {
  fem::Settings settings;
  settings.max_active_set_steps = 1;
  LineContact contact;
  contact.force = 2e6;  // more than one node touches on the first mesh
  try {
    solve(contact, settings);
    ADD_FAILURE() << "was not refused";
  } catch (const fem::NotConverged& error) {
    EXPECT_EQ(error.stop.outcome, fem::Outcome::active_set_limit);
    EXPECT_EQ(error.stop.limit, 1.);
    EXPECT_GT(error.stop.unknowns, 100U);
  }
}

TEST(Limits, TheLastGoodMeshStandsWhereTheActiveSetDoesNotSettle) {
  fem::Settings settings;
  settings.max_active_set_steps = 1;
  const fem::Solution<2> solution = solve(LineContact(), settings);
  EXPECT_EQ(solution.stop.outcome, fem::Outcome::active_set_limit);
  EXPECT_EQ(solution.stop.limit, 1.);
  ASSERT_FALSE(solution.history.empty());
  ASSERT_EQ(solution.contacts.size(), 1U);
  EXPECT_NEAR(solution.contacts[0].force[1], LineContact().force, 1e-8 * LineContact().force);
  EXPECT_EQ(solution.contacts[0].active_nodes, solution.history.back().active_nodes);
  EXPECT_LT(post::analyse(solution).equilibrium.force_residual, 1e-8);
}

/// A punch with square edges: K. L. Johnson, 1985, section 2.8 (rigid, Eq. 2.64) and 5.1 (elastic).
TEST(JohnsonContactMechanics, Sec51PressureAtASharpEdgeIsCalledUnbounded) {
  mesh::MeshData<2> mesh = empty_mesh();
  add_rectangle(mesh, "punch", equal_steps(-1., 1., 6), equal_steps(0., 2., 6),
                {"face", "", "lid", ""});
  add_rectangle(mesh, "block", equal_steps(-5., 5., 21), equal_steps(-5., 0., 10),
                {"bottom", "", "top", ""});
  fem::Problem<2> problem;
  problem.bodies = {{"punch", steel, {}}, {"block", steel, {}}};
  problem.supports = {{"bottom", {0., 0.}}};
  problem.ties = {{"lid", {0., -1.}, 1e6}};
  problem.pairs = {{"face", "top"}};
  const fem::Solution<2> solution = solve(mesh, problem);
  EXPECT_EQ(solution.stop.outcome, fem::Outcome::unbounded_pressure);
  EXPECT_FALSE(post::closed_form(solution, solution.contacts[0]).has_value());
}

/// Whether the solver fails or finds the contact open depends on the round-off in a system that
/// has no solution: both say what to check.
TEST(Refusals, ALoadThatPullsTheBodiesApart) {
  LineContact contact;
  contact.force = -100.;
  loads::test::expect_refused([&] { solve(contact); },
                              {"contact pair 'cylinder -> top'", "check the", "load"});
}

}  // namespace
}  // namespace geneva::test
