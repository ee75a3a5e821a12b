#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/extrusion.h"
#include "tests/support/solving.h"
#include "tests/support/structured_mesh.h"

namespace geneva::fem {
namespace {

using geneva::test::error_of;
using geneva::test::LineContact;

/// The plane problem extruded, its ends held along z: the state of plane strain in 3-D.
Problem<3> in_space(const Problem<2>& plane) {
  Problem<3> problem;
  for (const Body<2>& body : plane.bodies) problem.bodies.push_back({body.name, body.material, {}});
  for (const Support<2>& support : plane.supports)
    problem.supports.push_back(
        {support.surface, {support.displacement[0], support.displacement[1], 0.}});
  problem.supports.push_back({"end", {std::nullopt, std::nullopt, 0.}});
  for (const RigidTie<2>& tie : plane.ties)
    problem.ties.push_back({tie.surface, {tie.direction[0], tie.direction[1], 0.}, tie.force});
  problem.pairs = plane.pairs;
  return problem;
}

/// A line contact with a half-width of R/9.5.
LineContact heavy_roller() {
  LineContact contact;
  contact.thickness = 2.5e-3;
  contact.force = 6250.;
  return contact;
}

/// For the pressure, and not for stresses away from it.
Settings contact_alone(const double accuracy) {
  Settings settings = geneva::test::with_accuracy(accuracy);
  settings.structural_accuracy.reset();
  return settings;
}

/// At 2 % accuracy both solutions may be 2 % off; they come as near as their refinement is alike.
TEST(LineContactInSpace, BetweenHeldEndsIsThatOfPlaneStrain) {
  const LineContact contact = heavy_roller();
  const mesh::Extrusion slice{{0., contact.thickness}, "end", "end"};
  const mesh::MeshData<3> mesh = extruded(geneva::test::mesh_of(contact), {slice, slice});
  const Settings settings = contact_alone(0.02);
  const Solution<3> solution = solve_contact(
      MPI_COMM_WORLD, mesh, in_space(geneva::test::problem_of(contact)), settings, {});
  const Solution<2> plane = geneva::test::solve(contact, settings);
  EXPECT_EQ(solution.stop.outcome, Outcome::converged);
  const double peak = solution.contacts[0].peak_pressure;
  EXPECT_NEAR(error_of(peak, geneva::test::peak_pressure(plane)), 0., 0.01);
  for (const LevelRecord& level : solution.history)
    for (const unsigned int iterations : level.linear_iterations) EXPECT_LT(iterations, 60U);
}

/// With the soft body's surface as the source.
TEST(LineContactInSpace, OfAStiffRollerOnASoftBlockIsThatOfPlaneStrain) {
  constexpr double ratio = 1e6;
  LineContact contact = heavy_roller();
  contact.block.youngs_modulus /= ratio;
  contact.force *= 2. / ratio;
  contact.block_is_source = true;
  const mesh::Extrusion slice{{0., contact.thickness}, "end", "end"};
  const mesh::MeshData<3> mesh = extruded(geneva::test::mesh_of(contact), {slice, slice});
  const Settings settings = contact_alone(0.02);
  const Solution<3> solution = solve_contact(
      MPI_COMM_WORLD, mesh, in_space(geneva::test::problem_of(contact)), settings, {});
  EXPECT_EQ(solution.stop.outcome, Outcome::converged);
  EXPECT_NEAR(error_of(solution.contacts[0].peak_pressure,
                       geneva::test::peak_pressure(geneva::test::solve(contact, settings))),
              0., 0.01);
}

/// Two rollers on a block that is held, of which one does not touch and is held, too.
TEST(LineContactInSpace, WithASecondPairThatStaysOpenIsThatOfThePlane) {
  const LineContact contact = heavy_roller();
  mesh::MeshData<2> plane = geneva::test::mesh_of(contact);
  const double R = contact.radius;
  geneva::test::add_ring(plane, "far",
                         {{2.5 * R, 1.1 * R},
                          geneva::test::equal_steps(0.5 * R, R, 2),
                          geneva::test::equal_steps(0., 2. * std::acos(-1.), 24),
                          "far core",
                          "far surface",
                          "",
                          ""});
  Problem<2> problem = geneva::test::problem_of(contact);
  problem.bodies.push_back({"far", contact.cylinder, {}});
  problem.supports.push_back({"far core", {0., 0.}});
  problem.pairs.push_back({"far surface", "top"});
  const mesh::Extrusion slice{{0., contact.thickness}, "end", "end"};
  const Settings settings = contact_alone(0.02);
  const Solution<3> solution = solve_contact(MPI_COMM_WORLD, extruded(plane, {slice, slice, slice}),
                                             in_space(problem), settings, {});
  EXPECT_EQ(solution.stop.outcome, Outcome::converged);
  EXPECT_EQ(solution.contacts[1].active_nodes, 0U);
  EXPECT_NEAR(error_of(solution.contacts[0].peak_pressure,
                       geneva::test::peak_pressure(geneva::test::solve(contact, settings))),
              0., 0.01);
}

/// Half of a roller and a block of equal length, 6 R: held along z on the plane of symmetry z = 0,
/// free at the other end.
Solution<3> flush_rollers(const LineContact& contact) {
  const double radius = contact.radius;
  const mesh::Extrusion half{{0., 1.2 * radius, 2.2 * radius, 3. * radius}, "end", ""};
  const mesh::MeshData<3> mesh = extruded(geneva::test::mesh_of(contact), {half, half});
  return solve_contact(MPI_COMM_WORLD, mesh, in_space(geneva::test::problem_of(contact)),
                       contact_alone(0.05), {});
}

/// Maximum magnitudes of the strains along the pin and across the contact.
struct MaximumStrains {
  double along = 0.;
  double across = 0.;
};

MaximumStrains strains_in_middle_third(const Solution<3>& solution, const double length) {
  MaximumStrains maximum;
  for (const auto& cell : post::cell_stresses(solution)) {
    if (cell.centre[2] > length / 6.) continue;
    const Material& material = solution.problem.bodies[cell.body].material;
    const double trace = dealii::trace(cell.stress);
    const auto strain = [&](const unsigned int i) {
      return std::abs(
          ((1. + material.poissons_ratio) * cell.stress[i][i] - material.poissons_ratio * trace) /
          material.youngs_modulus);
    };
    maximum.along = std::max(maximum.along, strain(2));
    maximum.across = std::max(maximum.across, strain(1));
  }
  maximum.along = dealii::Utilities::MPI::max(maximum.along, MPI_COMM_WORLD);
  maximum.across = dealii::Utilities::MPI::max(maximum.across, MPI_COMM_WORLD);
  return maximum;
}

TEST(LineContactInSpace, OfEqualLengthIsInPlaneStrainInItsMiddleThird) {
  LineContact contact = heavy_roller();
  contact.force *= 3. * contact.radius / contact.thickness;
  contact.thickness = 3. * contact.radius;
  const Solution<3> solution = flush_rollers(contact);
  EXPECT_EQ(solution.stop.outcome, Outcome::converged);
  const MaximumStrains strains = strains_in_middle_third(solution, 6. * contact.radius);
  EXPECT_LT(strains.along, 0.02 * strains.across);
  EXPECT_GT(strains.along, 0.);
}

}  // namespace
}  // namespace geneva::fem
