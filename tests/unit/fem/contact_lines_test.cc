#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "fem/contact/conditions.h"
#include "tests/unit/fem/flat_pair.h"

namespace geneva::fem::test {
namespace {

/// gap_j(u) = 0 solved for the component with the maximum share of the normal.
TEST(ContactLines, CloseTheGapOfEveryActiveNode) {
  const double slope = 0.3;
  ContactInterface<2> interface;
  interface.source = underside({0., 1., 2.5}, 1.);
  interface.target = upper_side({-1., 0.4, 3.}, slope);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  interface.status = {slip, open, slip};
  std::set<global_dof_index> held;
  const ContactLines contact = contact_lines(interface, held);
  EXPECT_TRUE(contact.are_equal);
  const auto& lines = contact.displacement;
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(held.size(), 2U);
  // Any displacement that satisfies the line has no gap at its row.
  const auto displacement = [](const global_dof_index dof) { return std::sin(double(dof)); };
  for (std::size_t i = 0; i < 2; ++i) {
    const ContactRow<2>& row = interface.rows[2 * i];
    const SurfaceNode<2>& node = interface.source.nodes[row.node];
    ASSERT_EQ(lines[i].dof, node.dofs[1]) << "the normal points along y more than along x";
    double solved = lines[i].inhomogeneity;
    for (const auto& [dof, coefficient] : lines[i].entries)
      solved += coefficient * displacement(dof);
    dealii::Tensor<1, 2> change = row.weight * dealii::Point<2>(displacement(node.dofs[0]), solved);
    for (const auto& [target, coupling] : row.coupling)
      for (unsigned int c = 0; c < 2; ++c)
        change[c] -= coupling * displacement(interface.target.nodes[target].dofs[c]);
    EXPECT_NEAR(row.initial_gap + row.frame.normal * change, 0., 1e-13)
        << "a dozen products of size 1";
  }
}

TEST(ContactLines, LeaveHeldComponentsAlone) {
  ContactInterface<2> interface;
  interface.source = underside({0., 1.}, 1.);
  interface.target = upper_side({-1., 2.}, 0.3);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  interface.status = {slip, slip};
  const auto& dofs_of_first = interface.source.nodes[0].dofs;
  const auto& dofs_of_second = interface.source.nodes[1].dofs;
  std::set<global_dof_index> held{dofs_of_first[1], dofs_of_second[0], dofs_of_second[1]};
  const auto lines = contact_lines(interface, held).displacement;
  ASSERT_EQ(lines.size(), 1U) << "nothing is left to move the second node";
  EXPECT_EQ(lines[0].dof, dofs_of_first[0]);
}

/// Value that a line gives its dof in a field.
double solved(const ConstraintLine& line, const std::function<double(global_dof_index)>& field) {
  double value = line.inhomogeneity;
  for (const auto& [dof, coefficient] : line.entries) value += coefficient * field(dof);
  return value;
}

/// D u_j - sum_k M_jk u_k of a field in which lines give their dofs.
dealii::Tensor<1, 2> relative(const ContactInterface<2>& interface, const ContactRow<2>& row,
                              const std::vector<ConstraintLine>& lines) {
  const auto field = [](const global_dof_index dof) { return std::sin(double(dof)); };
  dealii::Tensor<1, 2> result;
  for (unsigned int c = 0; c < 2; ++c) {
    const auto dof = interface.source.nodes[row.node].dofs[c];
    double value = field(dof);
    for (const ConstraintLine& line : lines)
      if (line.dof == dof) value = solved(line, field);
    result[c] = row.weight * value;
    for (const auto& [target, coupling] : row.coupling)
      result[c] -= coupling * field(interface.target.nodes[target].dofs[c]);
  }
  return result;
}

ContactInterface<2> tilted_pair() {
  ContactInterface<2> interface;
  interface.source = underside({0., 1., 2.5}, 1.);
  interface.target = upper_side({-1., 0.4, 3.}, 0.3);
  interface.rows = mortar_rows(interface.source, interface.target, plane_data());
  interface.sliding.assign(3, {0., 1.});
  return interface;
}

/// p (n - mu t) does no work on the virtual displacements, and the gap closes.
TEST(ContactLines, WithFrictionVirtualDisplacementsAreAcrossTheTraction) {
  const double friction = 0.4;
  ContactInterface<2> interface = tilted_pair();
  interface.status.assign(3, slip);
  interface.law = std::make_shared<const Sliding<2>>(friction);
  std::set<global_dof_index> held;
  const ContactLines lines = contact_lines(interface, held);
  EXPECT_FALSE(lines.are_equal);
  ASSERT_EQ(lines.virtual_displacement.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const ContactRow<2>& row = interface.rows[i];
    EXPECT_EQ(lines.displacement[i].dof, lines.virtual_displacement[i].dof);
    EXPECT_NEAR(row.initial_gap + row.frame.normal * relative(interface, row, lines.displacement),
                0., 1e-13);
    const auto traction = row.frame.normal - friction * row.frame.tangents[0];
    EXPECT_NEAR(traction * relative(interface, row, lines.virtual_displacement), 0., 1e-13);
  }
}

TEST(ContactLines, NodesThatStickFollowTheTarget) {
  ContactInterface<2> interface = tilted_pair();
  interface.status = {NodeStatus::stick, open, NodeStatus::stick};
  interface.law = std::make_shared<const Coulomb<2>>(0.1);
  std::set<global_dof_index> held;
  const ContactLines lines = contact_lines(interface, held);
  EXPECT_TRUE(lines.are_equal);
  ASSERT_EQ(lines.displacement.size(), 4U);
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    const ContactRow<2>& row = interface.rows[i];
    const auto left = relative(interface, row, lines.displacement);
    EXPECT_NEAR(row.initial_gap + row.frame.normal * left, 0., 1e-13);
    EXPECT_NEAR(row.frame.tangents[0] * left, 0., 1e-13);
  }
}

}  // namespace
}  // namespace geneva::fem::test
