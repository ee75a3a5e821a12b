#include <gtest/gtest.h>

#include "mesh/extrusion.h"
#include "tests/support/solving.h"

namespace geneva::fem {
namespace {

using geneva::test::error_of;
using geneva::test::LineContact;

/// The plane problem drawn out, its ends held along z: the state of plane strain in space.
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

/// At 2 % accuracy both solutions may be 2 % off; they come as near as their refinement is alike.
TEST(LineContactInSpace, BetweenHeldEndsIsThatOfPlaneStrain) {
  const LineContact contact = heavy_roller();
  const mesh::Extrusion slice{{0., contact.thickness}, "end", "end"};
  const mesh::MeshData<3> mesh = extruded(geneva::test::mesh_of(contact), {slice, slice});
  const Settings settings = geneva::test::with_accuracy(0.02);
  const Solution<3> solution = solve_contact(
      MPI_COMM_WORLD, mesh, in_space(geneva::test::problem_of(contact)), settings, {});
  const Solution<2> plane = geneva::test::solve(contact, settings);
  EXPECT_EQ(solution.outcome, Outcome::converged) << solution.message;
  const double peak = solution.contacts[0].peak_pressure;
  EXPECT_NEAR(error_of(peak, geneva::test::peak_pressure(plane)), 0., 0.01);
  for (const LevelRecord& level : solution.history)
    for (const unsigned int iterations : level.linear_iterations) EXPECT_LT(iterations, 60U);
}

}  // namespace
}  // namespace geneva::fem
