#include "fem/contact/surface_strain.h"

#include <deal.II/base/index_set.h>
#include <gtest/gtest.h>

#include "tests/unit/fem/flat_pair.h"

namespace geneva::fem::test {
namespace {

/// Displacement along x by place, of the source a parabola, of the target a line; across anything.
Vector displacement(const ContactInterface<2>& interface) {
  Vector u(dealii::complete_index_set(1100), MPI_COMM_SELF);
  for (const SurfaceNode<2>& node : interface.source.nodes) {
    const double x = node.position[0];
    u(node.dofs[0]) = 0.1 * x + 0.2 * x * x;
    u(node.dofs[1]) = std::cos(5. * x);
  }
  for (const SurfaceNode<2>& node : interface.target.nodes) {
    u(node.dofs[0]) = 0.3 - 0.4 * node.position[0];
    u(node.dofs[1]) = std::sin(3. * node.position[0]);
  }
  return u;
}

TEST(SurfaceStrain, OfAParabolaIsExactBetweenTheEnds) {
  const ContactInterface<2> interface = flat_pair(8);
  const auto strains = surface_strains(interface, displacement(interface));
  ASSERT_EQ(strains.size(), interface.rows.size());
  for (std::size_t i = 1; i + 1 < strains.size(); ++i) {
    const double x = interface.source.nodes[interface.rows[i].node].position[0];
    EXPECT_NEAR(strains[i].source, 0.1 + 0.4 * x, 1e-12) << x;
  }
}

TEST(SurfaceStrain, OfTheTargetIsThatOfWhatTheSourceMeets) {
  const ContactInterface<2> interface = flat_pair(8);
  const auto strains = surface_strains(interface, displacement(interface));
  for (std::size_t i = 2; i + 2 < strains.size(); ++i)
    EXPECT_NEAR(strains[i].target, -0.4, 1e-12) << i;
}

TEST(SurfaceStrain, IsOfTheFirstOrderAtTheEnds) {
  double before = 0.;
  for (const unsigned int n : {8U, 16U, 32U}) {
    const ContactInterface<2> interface = flat_pair(n);
    const double error = surface_strains(interface, displacement(interface)).front().source - 0.1;
    const double x = interface.source.nodes[interface.rows.front().node].position[0];
    const double off = std::abs(error - 0.4 * x);
    EXPECT_NEAR(off, 0.2 / n, 1e-12);
    if (before > 0.) {
      EXPECT_NEAR(before / off, 2., 1e-9);
    }
    before = off;
  }
}

TEST(SurfaceStrain, OfARigidMotionIsNone) {
  const ContactInterface<2> interface = flat_pair(8);
  Vector u(dealii::complete_index_set(1100), MPI_COMM_SELF);
  for (const auto* const surface : {&interface.source, &interface.target})
    for (const SurfaceNode<2>& node : surface->nodes) {
      u(node.dofs[0]) = 2.;
      u(node.dofs[1]) = 0.01 * node.position[0] - 3.;
    }
  for (const SurfaceStrain& strain : surface_strains(interface, u)) {
    EXPECT_NEAR(strain.source, 0., 1e-13);
    EXPECT_NEAR(strain.target, 0., 1e-13);
  }
}

}  // namespace
}  // namespace geneva::fem::test
