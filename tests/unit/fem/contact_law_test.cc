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
void expect_linear(const ContactLaw<dim>& law, const NodeContact<dim>& before) {
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
    expect_linear<2>(Frictionless<2>(), {status, {0.1}, {2.}});
    expect_linear<3>(Frictionless<3>(), {status, {0.1}, {2.}});
  }
}

TEST(Sliding, OpensAndClosesAsWithoutFriction) {
  const Sliding<2> law(0.3);
  const Frictionless<2> frictionless;
  for (const NodeStatus status : {NodeStatus::open, NodeStatus::slip})
    for (const double sign : {-1., 1.}) {
      const NodeContact<2> node{status, {sign, 3.}, {sign, -2.}, {0., 1.}};
      EXPECT_EQ(law.next_status(node, exact), frictionless.next_status(node, exact));
    }
}

/// Friction is mu times the pressure against the sliding, in every direction.
TEST(Sliding, FrictionIsMuTimesThePressureAgainstTheSliding) {
  const Sliding<3> law(0.3);
  NodeContact<3> node{NodeStatus::slip, {0., 7., 7.}, {2., -0.36, 0.48}, {0., 0.6, -0.8}};
  for (const double residual : law.equations(node).residual) EXPECT_NEAR(residual, 0., 1e-16);
  node.traction[1] += 0.1;
  EXPECT_NEAR(law.equations(node).residual[1], 0.1, 1e-16);
}

TEST(Coulomb, SticksUpToMuTimesThePressure) {
  const Coulomb<3> law(0.5);
  const auto status = [&](const double friction) {
    return law.next_status({NodeStatus::stick, {}, {2., 0.6 * friction, -0.8 * friction}}, exact);
  };
  EXPECT_EQ(status(0.999), NodeStatus::stick);
  EXPECT_EQ(status(1.001), NodeStatus::slip);
  EXPECT_EQ(law.touching(), NodeStatus::stick);
  EXPECT_EQ(law.next_status({NodeStatus::open, {-1., 0., 0.}, {}}, exact), NodeStatus::stick);
  EXPECT_EQ(law.next_status({NodeStatus::stick, {}, {-1., 0., 0.}}, exact), NodeStatus::open);
}

TEST(Coulomb, SticksAgainWhereItWouldSlideBack) {
  const Coulomb<2> law(0.5);
  const Components<2> sliding{0., -1.};
  EXPECT_EQ(law.next_status({NodeStatus::slip, {0., -0.1}, {1., 0.5}, sliding}, exact),
            NodeStatus::slip);
  EXPECT_EQ(law.next_status({NodeStatus::slip, {0., 0.1}, {1., 0.5}, sliding}, exact),
            NodeStatus::stick);
}

TEST(Coulomb, SlidesAtOnceWhereItPassesFasterThanItCloses) {
  const Coulomb<2> law(0.5);
  const auto status = [&](const double slip) {
    return law.next_status({NodeStatus::open, {-1., slip}, {}}, exact);
  };
  EXPECT_EQ(status(0.49), NodeStatus::stick);
  EXPECT_EQ(status(-0.51), NodeStatus::slip);
  EXPECT_EQ(law.next_sliding({NodeStatus::open, {-1., -0.51}, {}}), (Components<2>{0., -1.}));
}

TEST(Coulomb, SlidesAgainstTheFrictionThatHeldItAndKeepsItsDirection) {
  const Coulomb<3> law(0.5);
  const auto first = law.next_sliding({NodeStatus::stick, {}, {1., 3., -4.}});
  EXPECT_NEAR(first[1], -0.6, 1e-15);
  EXPECT_NEAR(first[2], 0.8, 1e-15);
  const auto then = law.next_sliding({NodeStatus::slip, {0., 0.3, 0.4}, {1., 3., -4.}, first});
  EXPECT_EQ(then, first);
}

TEST(Coulomb, EquationsAreLinearAsLongAsTheStatusStays) {
  for (const NodeStatus status : {NodeStatus::open, NodeStatus::stick, NodeStatus::slip}) {
    expect_linear<2>(Coulomb<2>(0.3), {status, {0.1}, {2.}, {0., -1.}});
    expect_linear<3>(Coulomb<3>(0.3), {status, {0.1}, {2.}, {0., 0.6, 0.8}});
  }
}

}  // namespace
}  // namespace geneva::fem::test
