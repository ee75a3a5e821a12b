#include "loads/pin/pin_beam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

constexpr double youngs_modulus = 2e11;
constexpr double nu = 0.3;

PinBeam cantilever() { return {5e-3, 8e-3, 2e-3, 3e-3, false, youngs_modulus, nu}; }

double inertia(const double d) { return pi * std::pow(d, 4) / 64.; }

double shear_stiffness(const double d) {
  return 6. * (1. + nu) / (7. + 6. * nu) * youngs_modulus / (2. * (1. + nu)) * pi * d * d / 4.;
}

/// Midpoint rule over the beam: turn and deflection from the moment and shear force at each place.
BeamBending integrated(const PinBeam& pin, const double force) {
  const double a = pin.root_gap;
  const double b = a + pin.thickness;
  const double w = force / pin.thickness;
  const double tip = b + pin.overhang;
  const int steps = 200000;
  const double h = tip / steps;
  BeamBending sum{};
  double turn = 0.;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) * h;
    const double from = std::clamp(s, a, b);
    const double moment = w * ((b * b - from * from) / 2. - s * (b - from));
    const double shear = w * (b - from);
    const double curvature = moment / (youngs_modulus * inertia(pin.diameter));
    sum.tip_deflection += h * (turn + h * curvature / 2. + shear / shear_stiffness(pin.diameter));
    turn += h * curvature;
    if (s < (a + b) / 2.) sum.slope = turn;
  }
  return sum;
}

TEST(PinBeam, CantileverIsTheIntegralOfItsCurvatureAndShear) {
  const BeamBending bending = beam_bending(cantilever(), 1000.);
  const BeamBending expected = integrated(cantilever(), 1000.);
  EXPECT_NEAR(bending.tip_deflection, expected.tip_deflection, 1e-8 * bending.tip_deflection);
  EXPECT_NEAR(bending.slope, expected.slope, 1e-4 * bending.slope) << "a step of the sum is 1e-5";
  EXPECT_NEAR(bending.root_moment, 1000. * 6e-3, 1e-12);
  EXPECT_NEAR(bending.root_stress, 6. / (inertia(5e-3) / 2.5e-3), 1e-3);
}

/// 4/3 of the mean: Q S/(I b) in the middle of a circle.
TEST(PinBeam, RootBearsTheWholeForceOrHalfOfItWithFourThirdsOfTheMeanShear) {
  PinBeam pin = cantilever();
  const double area = pi * 5e-3 * 5e-3 / 4.;
  EXPECT_NEAR(beam_bending(pin, 1000.).root_force, 1000., 1e-9);
  EXPECT_NEAR(beam_bending(pin, 1000.).root_shear, 4. / 3. * 1000. / area, 1e-3);
  pin.held_at_both_ends = true;
  EXPECT_NEAR(beam_bending(pin, 1000.).root_force, 500., 1e-9);
  EXPECT_NEAR(beam_bending(pin, 1000.).root_shear, 4. / 3. * 500. / area, 1e-3);
}

TEST(PinBeam, HollowOneHasTheMomentsOfARing) {
  PinBeam pin = cantilever();
  const BeamBending solid = beam_bending(pin, 1000.);
  pin.bore = 4e-3;
  const BeamBending hollow = beam_bending(pin, 1000.);
  EXPECT_NEAR(hollow.root_stress / solid.root_stress, 1. / (1. - std::pow(0.8, 4)), 1e-12);
  // Q S/(I b) with S = (d^3 - d_i^3)/12 and b = d - d_i.
  const double first = (std::pow(5e-3, 3) - std::pow(4e-3, 3)) / 12.;
  const double second = pi * (std::pow(5e-3, 4) - std::pow(4e-3, 4)) / 64.;
  EXPECT_NEAR(hollow.root_shear, 1000. * first / (second * 1e-3), 1e-6 * hollow.root_shear);
  EXPECT_GT(hollow.tip_deflection, solid.tip_deflection / (1. - std::pow(0.8, 4)));
  pin.bore = 5e-3;
  EXPECT_THROW(beam_bending(pin, 1000.), base::InputError) << "nothing is left";
}

TEST(PinBeam, LongCantileverUnderAForceAtItsTipDeflectsByFL3Over3EI) {
  PinBeam pin = cantilever();
  pin.thickness = 1e-9;
  pin.root_gap = 1.;
  pin.overhang = 0.;
  const double expected = 1. / (3. * youngs_modulus * inertia(5e-3)) + 1. / shear_stiffness(5e-3);
  EXPECT_NEAR(beam_bending(pin, 1.).tip_deflection, expected, 1e-6 * expected);
}

TEST(PinBeam, HeldAtBothEndsItHasTheTextbookLimits) {
  PinBeam pin = cantilever();
  pin.held_at_both_ends = true;
  pin.root_gap = 0.;
  const double L = pin.thickness;
  const double EI = youngs_modulus * inertia(pin.diameter);
  const double shear = L / (8. * shear_stiffness(pin.diameter));
  BeamBending bending = beam_bending(pin, 1000.);
  EXPECT_NEAR(bending.tip_deflection, 1000. * (L * L * L / (384. * EI) + shear), 1e-18);
  EXPECT_NEAR(bending.root_moment, 1000. * L / 12., 1e-12);
  EXPECT_EQ(bending.slope, 0.);
  pin.root_gap = 0.5;
  pin.thickness = 1e-9;
  bending = beam_bending(pin, 1.);
  EXPECT_NEAR(bending.root_moment, 1. / 8., 1e-8);
  const double expected = 1. / (192. * EI) + 1. / (4. * shear_stiffness(pin.diameter));
  EXPECT_NEAR(bending.tip_deflection, expected, 1e-6 * expected);
}

TEST(PinBeam, RefusesWhatIsNoBeam) {
  PinBeam pin = cantilever();
  pin.root_gap = -1e-3;
  test::expect_refused([&] { beam_bending(pin, 1.); }, {"root gap"});
  pin = cantilever();
  pin.diameter = 0.;
  test::expect_refused([&] { beam_bending(pin, 1.); }, {"pin diameter"});
  test::expect_refused([&] { beam_bending(cantilever(), 0.); }, {"pin force"});
}

}  // namespace
}  // namespace geneva::loads
