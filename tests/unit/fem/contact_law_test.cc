#include "fem/contact/contact_law.h"

#include <gtest/gtest.h>

namespace geneva::fem::test {
namespace {

constexpr ContactRounding exact{0., 0.};

TEST(Frictionless, ClosesWhereBodiesOverlapAndOpensUnderTension) {
  const Frictionless<2> law;
  EXPECT_EQ(law.next_status({NodeStatus::open, {1e-3, 0.}, {0., 0.}}, exact), NodeStatus::open);
  EXPECT_EQ(law.next_status({NodeStatus::open, {-1e-3, 0.}, {0., 0.}}, exact), NodeStatus::slip);
  EXPECT_EQ(law.next_status({NodeStatus::slip, {0., 0.}, {1., 0.}}, exact), NodeStatus::slip);
  EXPECT_EQ(law.next_status({NodeStatus::slip, {0., 0.}, {-1., 0.}}, exact), NodeStatus::open);
}

TEST(Frictionless, KeepsTheStatusWithinTheRounding) {
  const Frictionless<2> law;
  const ContactRounding rounding{1e-3, 1e-2};
  EXPECT_EQ(law.next_status({NodeStatus::open, {-0.9e-3, 0.}, {0., 0.}}, rounding),
            NodeStatus::open);
  EXPECT_EQ(law.next_status({NodeStatus::slip, {0., 0.}, {-0.9e-2, 0.}}, rounding),
            NodeStatus::slip);
}

TEST(Frictionless, DoesNotCareForSlip) {
  const Frictionless<3> law;
  for (const NodeStatus status : {NodeStatus::open, NodeStatus::slip})
    EXPECT_EQ(law.next_status({status, {-0.1, 7., -3.}, {2., 0., 0.}}, exact), NodeStatus::slip);
}

/// Gap 0 and no friction where closed, no traction where open: as many equations as unknowns.
TEST(Frictionless, EquationsAreThoseOfTheStatus) {
  const Frictionless<3> law;
  const auto closed = law.equations({NodeStatus::slip, {0.1, 0.2, 0.3}, {4., 5., 6.}});
  EXPECT_EQ(closed.residual, (Components<3>{0.1, 5., 6.}));
  EXPECT_EQ(closed.by_gap, (ContactEquations<3>::Matrix{{{1., 0., 0.}, {}, {}}}));
  EXPECT_EQ(closed.by_traction, (ContactEquations<3>::Matrix{{{}, {0., 1., 0.}, {0., 0., 1.}}}));
  const auto open = law.equations({NodeStatus::open, {0.1, 0.2, 0.3}, {4., 5., 6.}});
  EXPECT_EQ(open.residual, (Components<3>{4., 5., 6.}));
  EXPECT_EQ(open.by_gap, (ContactEquations<3>::Matrix{}));
}

/// The residual's change is by_gap d(gap) + by_traction d(traction), however large the step.
template <int dim>
void expect_linear(const NodeStatus status) {
  const Frictionless<dim> law;
  const NodeContact<dim> before{status, {0.1}, {2.}};
  NodeContact<dim> after = before;
  for (std::size_t i = 0; i < dim; ++i) {
    after.gap[i] += 0.5 + static_cast<double>(i);
    after.traction[i] -= 3. + static_cast<double>(i);
  }
  const auto equations = law.equations(before);
  const auto then = law.equations(after);
  for (std::size_t e = 0; e < dim; ++e) {
    double residual = equations.residual[e];
    for (std::size_t i = 0; i < dim; ++i)
      residual += equations.by_gap[e][i] * (after.gap[i] - before.gap[i]) +
                  equations.by_traction[e][i] * (after.traction[i] - before.traction[i]);
    EXPECT_DOUBLE_EQ(then.residual[e], residual);
  }
}

TEST(Frictionless, EquationsAreLinearAsLongAsTheStatusStays) {
  for (const NodeStatus status : {NodeStatus::open, NodeStatus::slip}) {
    expect_linear<2>(status);
    expect_linear<3>(status);
  }
}

}  // namespace
}  // namespace geneva::fem::test
