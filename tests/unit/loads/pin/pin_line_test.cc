#include "loads/pin/pin_line.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "loads/hertz.h"
#include "loads/pi.h"
#include "loads/pin/cylinder_kernel.h"
#include "loads/pin/pin_beam.h"
#include "loads/pin/strip_influence.h"

namespace geneva::loads::test {
namespace {

constexpr double inch = 0.0254;
constexpr double psi = 6894.757293168361;
constexpr double pound = 4.4482216152605;
constexpr double pin_force = 1033.732;  // [N], of Johnson's optimum wheel

/// Johnson's optimum wheel with its pin, held at one end.
PinLine johnson() {
  PinLine pin{};
  pin.pin = {30e6 * psi, 0.3};
  pin.wheel = pin.pin;
  pin.radius = 0.6795 / 2. * inch;
  pin.relative_radius = pin.radius;
  pin.clearance.wall_half = pin.radius;
  pin.clearance.lower_end = -pin.radius - 0.1 * inch;
  pin.clearance.upper_end = pin.radius + 0.15 * inch;
  pin.wheel_twist = 1.3e-6 / (pound * inch);
  return pin;
}

PinLine crowned() {
  PinLine pin = johnson();
  pin.clearance.profile = Crown{120. * inch};
  return pin;
}

PinLine tilted() {
  PinLine pin = johnson();
  pin.clearance.profile = Crown{80. * inch};
  pin.clearance.tilt = 0.1 * degree;
  return pin;
}

double force_of(const PinLineContact& contact) {
  double sum = 0.;
  for (const PinSection& section : contact.sections) sum += section.line_load * section.width;
  return sum;
}

/// By the trapezoidal rule over s = sin t, where the integrand is smooth and even at both ends of
/// t: A = (4/pi) int asinh(s/sin t) cos^2 t dt.
double influence_by_quadrature(const double s) {
  constexpr int n = 400000;
  double sum = 0.;
  for (int i = 0; i < n; ++i) {
    const double t = pi / 2. * (i + 0.5) / n;
    sum += std::asinh(s / std::sin(t)) * std::cos(t) * std::cos(t);
  }
  return 4. / pi * sum * pi / 2. / n;
}

TEST(StripInfluence, IsItsIntegral) {
  for (const double s : {0.02, 0.1, 0.5, 1., 2.9, 3.1, 10., 1000.})
    EXPECT_NEAR(strip_influence(s).value, influence_by_quadrature(s), 2e-6) << s;
  EXPECT_EQ(strip_influence(0.).value, 0.);
  EXPECT_EQ(strip_influence(-2.).value, -strip_influence(2.).value);
}

TEST(StripInfluence, HasItsDerivative) {
  for (const double s : {1e-5, 0.01, 0.3, 2., 2.999, 3.001, 20.}) {
    const double h = 1e-4 * s;
    EXPECT_NEAR(strip_influence(s).derivative,
                (strip_influence(s + h).value - strip_influence(s - h).value) / (2. * h),
                1e-5 * strip_influence(s).derivative)
        << s;
  }
}

/// scripts/cylinder_kernel gives these with 40 digits; 0.3 is none of the table's ratios.
TEST(CylinderKernel, IsInterpolatedBetweenPoissonsRatiosAndPlaces) {
  const CylinderKernel kernel(0.3);
  EXPECT_NEAR(kernel.integral(0.01), -0.004105792106, 1e-6);
  EXPECT_NEAR(kernel.integral(0.25), -0.1067643989, 1e-6);
  EXPECT_NEAR(kernel.integral(1.), -0.3513983973, 1e-6);
  EXPECT_NEAR(kernel.integral(3.), -0.6622032865, 1e-6);
  EXPECT_NEAR(kernel.integral(-16.), 1.14729218, 1e-6);
  EXPECT_NEAR(kernel.integral(200.) - kernel.integral(100.), -0.91 / pi * std::log(2.), 1e-12);
  EXPECT_EQ(kernel.integral(0.), 0.);
  EXPECT_NEAR(kernel.shear_factor(), 0.619329, 1e-6);
  EXPECT_THROW(CylinderKernel(-0.1), base::InputError);
}

/// Values made with 40 digits, not by the table.
TEST(CylinderKernel, OfATubeAndOfACylinderHeldAtItsCoreIsInterpolated) {
  const CylinderKernel core(0.3, PinInside::held_core, 0.42);
  EXPECT_NEAR(core.integral(0.2566291814), -0.147437591, 1e-4);
  EXPECT_NEAR(core.integral(2.7691127599), -0.749702607, 1e-4);
  EXPECT_NEAR(core.integral(13.7422596469), -1.213803136, 1e-4);
  EXPECT_NEAR(CylinderKernel(0.49, PinInside::held_core, 0.5).integral(1.0054641855), -0.473527006,
              2e-5);
  const CylinderKernel tube(0.3, PinInside::hollow, 0.45);
  EXPECT_NEAR(tube.integral(0.2566291814), 0.071580738, 1e-4);
  EXPECT_NEAR(tube.integral(7.5404643652), -0.294836405, 1e-4);
  EXPECT_NEAR(CylinderKernel(0.3, PinInside::hollow, 0.5).shear_factor(), 1.152189, 1e-6);
}

TEST(CylinderKernel, OfATubeWithoutABoreIsThatOfACylinder) {
  for (const double nu : {0., 0.2, 0.45}) {
    const CylinderKernel solid(nu);
    const CylinderKernel tube(nu, PinInside::hollow, 0.);
    EXPECT_NEAR(tube.shear_factor(), solid.shear_factor(), 1e-14);
    for (const double z : {0.05, 0.4, 1.7, 6., 30.})
      EXPECT_NEAR(tube.integral(z), solid.integral(z), 3e-5) << nu << ", " << z;
  }
}

TEST(CylinderKernel, KnowsThinTubesAndThinCoresNot) {
  EXPECT_THROW(CylinderKernel(0.3, PinInside::hollow, 0.75), base::InputError);
  EXPECT_THROW(CylinderKernel(0.3, PinInside::held_core, 0.05), base::InputError);
}

TEST(PinLine, OfAPinWithABoreIsThatOfASolidOneAsTheBoreCloses) {
  PinLine pin = crowned();
  const PinLineContact solid = pin_line_contact(pin, pin_force, 1e-4);
  pin.inner_radius = 1e-3 * pin.radius;
  const PinLineContact closing = pin_line_contact(pin, pin_force, 1e-4);
  EXPECT_NEAR(closing.peak_pressure / solid.peak_pressure, 1., 2e-5);
  EXPECT_NEAR(closing.deflection / solid.deflection, 1., 2e-5);
  pin.inner_radius = 0.6 * pin.radius;
  const PinLineContact tube = pin_line_contact(pin, pin_force, 1e-4);
  EXPECT_NEAR(tube.root_stress / solid.root_stress,
              tube.root_moment / solid.root_moment / (1. - std::pow(0.6, 4)), 1e-12);
  EXPECT_GT(tube.deflection, 1.1 * solid.deflection);
}

TEST(PinLine, HeldAtItsCoreIsSymmetricAndDoesNotBend) {
  PinLine pin = crowned();
  pin.hold = PinHold::core;
  pin.inner_radius = pin.radius / 2.;
  pin.clearance.lower_end = -pin.clearance.upper_end;
  const PinLineContact contact = pin_line_contact(pin, pin_force, 1e-4);
  EXPECT_NEAR(contact.peak_place, 0., 1e-9);
  EXPECT_EQ(contact.root_moment, 0.);
  EXPECT_EQ(contact.deflection, 0.);
}

/// A cantilever under a force in its middle: F a^3/(3 E I) + a F/(kappa G A) where it acts, and the
/// rest of its length turns with it.
TEST(PinLine, DeflectsAsACantileverUnderAShortContact) {
  PinLine pin = crowned();
  pin.clearance.profile = Crown{2. * inch};
  pin.clearance.upper_end = 20. * pin.radius;
  pin.clearance.lower_end = -10. * pin.radius;
  const PinLineContact contact = pin_line_contact(pin, pin_force, 1e-4);
  const double arm = pin.clearance.upper_end - contact.peak_place;
  const double area = pi * pin.radius * pin.radius;
  const double bending = pin.pin.youngs_modulus * area * pin.radius * pin.radius / 4.;
  const double shear = shear_coefficient(0.3) * pin.pin.youngs_modulus / 2.6 * area;
  const double turn = pin_force * arm * arm / (2. * bending);
  EXPECT_NEAR(contact.slope / turn, 1., 1e-3);
  EXPECT_NEAR(contact.deflection / (pin_force * (arm * arm * arm / (3. * bending) + arm / shear) +
                                    turn * (contact.peak_place - pin.clearance.lower_end)),
              1., 1e-3);
}

/// The pin is rigid, so that it does not bend, and the wheel's faces are far. Within 0.1 % from
/// axes of 7 to 1 on; the sections' loads are those of endless lines, what they lack falls with the
/// square of the axes' ratio.
TEST(PinLine, IsHertzsEllipseOnAHalfSpace) {
  for (const double ratio : {20., 30., 300., 3000., 30000.}) {
    PinLine pin = johnson();
    pin.pin.youngs_modulus *= 1e9;
    const double crown = ratio * pin.radius;
    const double modulus = contact_modulus(pin.pin, pin.wheel);
    const HertzEllipse hertz = hertz_ellipse(pin_force, crown, pin.radius, modulus);
    pin.clearance.profile = Crown{crown};
    pin.clearance.wall_half = 20. * hertz.semi_axis_long;
    pin.clearance.lower_end = -pin.clearance.wall_half;
    pin.clearance.upper_end = pin.clearance.wall_half;
    const PinLineContact contact = pin_line_contact(pin, pin_force, 1e-4);
    const double axes = hertz.semi_axis_long / hertz.semi_axis_short;
    EXPECT_NEAR(contact.peak_pressure / hertz.peak_pressure, 1., 1e-4 + 0.05 / (axes * axes))
        << axes;
    EXPECT_NEAR((contact.end - contact.begin) / 2. / hertz.semi_axis_long, 1., 0.003) << axes;
  }
}

/// The figures of finite elements on their finest meshes: 829.2 MPa, and 898.3 MPa and falling.
TEST(PinLine, IsThatOfFiniteElements) {
  const PinLineContact crown = pin_line_contact(crowned(), pin_force, 1e-4);
  EXPECT_NEAR(crown.peak_pressure, 829.2e6, 0.001 * 829.2e6);
  EXPECT_NEAR(crown.peak_place, 0.0133 * inch, 0.001 * inch);
  EXPECT_NEAR(crown.end - crown.begin, 0.369 * inch, 0.01 * 0.369 * inch);
  const PinLineContact tilt = pin_line_contact(tilted(), pin_force, 1e-4);
  EXPECT_NEAR(tilt.peak_pressure, 898.3e6, 0.0025 * 898.3e6);
  EXPECT_NEAR(tilt.peak_place, -0.1221 * inch, 0.01 * (tilt.end - tilt.begin));
  EXPECT_NEAR(tilt.root_stress, 4611. * psi, 0.002 * 4611. * psi);
}

TEST(PinLine, CarriesItsForceAndItsMoment) {
  for (const bool is_held_twice : {false, true}) {
    PinLine pin = tilted();
    pin.hold = is_held_twice ? PinHold::both_ends : PinHold::one_end;
    const PinLineContact contact = pin_line_contact(pin, pin_force, 1e-3);
    EXPECT_NEAR(force_of(contact), pin_force, 1e-9 * pin_force);
    double lever = 0.;
    for (const PinSection& section : contact.sections)
      lever += section.line_load * section.width * (pin.clearance.upper_end - section.place);
    if (is_held_twice)
      EXPECT_LT(contact.root_moment, 0.25 * lever);
    else
      EXPECT_NEAR(contact.root_moment, lever, 1e-12 * lever);
  }
}

/// A beam in the middle between its two ends under an even load.
TEST(PinLine, BendsBetweenTwoEndsAsABeam) {
  PinLine pin = johnson();
  pin.hold = PinHold::both_ends;
  pin.clearance.lower_end = -pin.clearance.upper_end;
  pin.clearance.profile = Crown{30. * inch};
  const PinLineContact contact = pin_line_contact(pin, pin_force, 1e-3);
  const double length = 2. * pin.clearance.upper_end;
  // Nearly a force in the middle: F L/8.
  EXPECT_NEAR(contact.root_moment, pin_force * length / 8., 0.05 * pin_force * length / 8.);
  EXPECT_NEAR(contact.peak_place, 0., 1e-9);
}

TEST(PinLine, DoesNotDependOnUnits) {
  const PinLineContact contact = pin_line_contact(tilted(), pin_force, 1e-3);
  PinLine pin = tilted();  // lengths by 1000, stresses by 1e-6: forces as they are
  pin.pin.youngs_modulus *= 1e-6;
  pin.wheel.youngs_modulus *= 1e-6;
  pin.radius *= 1e3;
  pin.relative_radius *= 1e3;
  pin.clearance.profile = Crown{80e3 * inch};
  pin.clearance.wall_half *= 1e3;
  pin.clearance.lower_end *= 1e3;
  pin.clearance.upper_end *= 1e3;
  pin.wheel_twist *= 1e-3;
  const PinLineContact other = pin_line_contact(pin, pin_force, 1e-3);
  EXPECT_NEAR(other.peak_pressure * 1e6, contact.peak_pressure, 1e-8 * contact.peak_pressure);
  EXPECT_NEAR(other.peak_place * 1e-3, contact.peak_place, 1e-7 * pin.radius * 1e-3);
}

TEST(PinLine, HeldAtBothEndsIsTheSameMirrored) {
  PinLine pin = tilted();
  pin.hold = PinHold::both_ends;
  pin.clearance.lower_end = -pin.clearance.upper_end;
  const PinLineContact one = pin_line_contact(pin, pin_force, 1e-3);
  pin.clearance.tilt *= -1.;
  const PinLineContact other = pin_line_contact(pin, pin_force, 1e-3);
  EXPECT_NEAR(other.peak_pressure, one.peak_pressure, 1e-8 * one.peak_pressure);
  EXPECT_NEAR(other.peak_place, -one.peak_place, 1e-8 * pin.radius);
  EXPECT_NEAR(other.begin, -one.end, 1e-8 * pin.radius);
}

/// Which is known by an estimate only.
TEST(PinLine, HardlyDependsOnTheWheelsTwistWhereItsContactEndsInside) {
  for (PinLine pin : {crowned(), tilted()}) {
    const double peak = pin_line_contact(pin, pin_force, 1e-4).peak_pressure;
    pin.wheel_twist = 0.;
    EXPECT_NEAR(pin_line_contact(pin, pin_force, 1e-4).peak_pressure, peak, 0.003 * peak);
  }
}

/// The load of the last twentieth of the length that finite elements find: 521 to 526 lbf/in.
TEST(PinLine, LoadsASharpEdgeAsFiniteElementsDo) {
  const PinLine pin = johnson();
  const PinLineContact contact = pin_line_contact(pin, pin_force, 1e-2);
  double last = 0.;
  for (const PinSection& section : contact.sections) {
    const double end = section.place + section.width / 2.;
    last += section.line_load * std::clamp(end - 0.9 * pin.clearance.wall_half, 0., section.width);
  }
  const double found = last / (0.1 * pin.clearance.wall_half) / (pound / inch);
  EXPECT_NEAR(found, 523.5, 0.03 * 523.5);
  EXPECT_EQ(contact.end, pin.clearance.wall_half);
}

/// Where the load leans to one side, a section's mean is not that at its edge. Finite elements find
/// 72 080 to 72 220 psi (doc/theory.md, 2.4).
TEST(PinLine, LoadsTheMiddleBetweenSharpEdgesAsFiniteElementsDo) {
  const PinLine pin = johnson();
  const PinLineContact contact = pin_line_contact(pin, pin_force, 1e-2);
  const double pressure = hertz_line(line_load_at(contact, 0.), pin.relative_radius,
                                     contact_modulus(pin.pin, pin.wheel))
                              .peak_pressure;
  EXPECT_NEAR(pressure, 72150. * psi, 0.002 * 72150. * psi);
}

/// A tilted load: straight between the middles of the sections, at their edges, too.
TEST(PinLine, KnowsTheLoadBetweenSections) {
  const PinLineContact contact = pin_line_contact(tilted(), pin_force, 1e-3);
  for (std::size_t i = 0; i + 1 < contact.sections.size(); ++i) {
    const PinSection& below = contact.sections[i];
    const PinSection& above = contact.sections[i + 1];
    const double edge = below.place + below.width / 2.;
    const double share = (edge - below.place) / (above.place - below.place);
    EXPECT_NEAR(line_load_at(contact, edge),
                (1. - share) * below.line_load + share * above.line_load,
                1e-9 * contact.peak_line_load);
    EXPECT_EQ(line_load_at(contact, below.place), below.line_load);
  }
}

TEST(PinLine, SaysHowFarOffItsSectionsAre) {
  for (const PinLine& pin : {crowned(), tilted()}) {
    const double limit = pin_line_contact(pin, pin_force, 2e-6).peak_pressure;
    for (const double accuracy : {1e-2, 1e-3, 2e-4}) {
      const PinLineContact contact = pin_line_contact(pin, pin_force, accuracy);
      EXPECT_LE(contact.error, accuracy);
      EXPECT_LE(std::abs(contact.peak_pressure / limit - 1.), contact.error);
    }
  }
}

double between(const double least, const double most) {
  return least + (most - least) * 1e-6 * *rc::gen::inRange(0, 1000001);
}

/// Any pin that a wheel may have: its sections carry the force, and none pulls.
RC_GTEST_PROP(PinLine, FindsTheBalanceOfAnyPin, ()) {
  PinLine pin = johnson();
  const double radius = pin.radius;
  pin.pin.poissons_ratio = between(0., 0.49);
  pin.wheel.poissons_ratio = between(0., 0.49);
  pin.wheel.youngs_modulus *= std::pow(10., between(-2., 1.));
  pin.clearance.wall_half = radius * std::pow(10., between(-0.5, 0.7));
  pin.clearance.lower_end = -pin.clearance.wall_half - radius * between(0., 2.);
  pin.clearance.upper_end = pin.clearance.wall_half + radius * between(0., 2.);
  pin.clearance.profile = Crown{radius * std::pow(10., between(1.7, 5.))};
  pin.clearance.tilt = between(-0.3, 0.3) * degree;
  pin.hold = *rc::gen::element(PinHold::one_end, PinHold::both_ends);
  pin.wheel_twist *= between(0., 3.);
  const double force = pin_force * std::pow(10., between(-2., 1.));
  const PinLineContact contact = pin_line_contact(pin, force, 1e-3);
  RC_ASSERT(std::abs(force_of(contact) / force - 1.) < 1e-8);
  for (const PinSection& section : contact.sections) RC_ASSERT(section.line_load >= 0.);
  RC_ASSERT(contact.begin < contact.end);
  RC_ASSERT(contact.peak_place >= contact.begin && contact.peak_place <= contact.end);
}

/// Finite elements find 326 to 328 ksi (doc/theory.md, 3.7), a grid of Love's rectangles 317 ksi.
TEST(PinLine, FindsThePeakAtARoundedEdge) {
  PinLine pin = johnson();
  pin.clearance.wall_edge = {EdgeBreak::Kind::rounded, 0.01 * inch};
  const PinLineContact known = pin_line_contact(pin, pin_force, 5e-4);
  EXPECT_EQ(peak_doubt(pin, known), PeakDoubt::reaches_edge);
  const PinLineContact contact = resolved_edges(pin, pin_force, known);
  EXPECT_EQ(peak_doubt(pin, contact), PeakDoubt::none);
  EXPECT_NEAR(contact.peak_pressure / psi, 326e3, 0.05 * 326e3);
  EXPECT_LE(std::abs(contact.peak_pressure / psi / 326e3 - 1.), expected_error(pin, contact));
  EXPECT_NEAR(std::abs(contact.peak_place), pin.clearance.wall_half - 0.01 * inch, 1e-3 * inch);
  EXPECT_NEAR(force_of(contact) / pin_force, 1., 1e-8);
  EXPECT_NEAR(peak_contact(pin, contact).peak_pressure, contact.peak_pressure,
              1e-12 * contact.peak_pressure);
}

TEST(PinLine, FindsTheSamePeakAtEitherRoundedEdge) {
  PinLine pin = johnson();
  pin.clearance.lower_end = -pin.clearance.upper_end;
  pin.hold = PinHold::both_ends;
  pin.clearance.wall_edge = {EdgeBreak::Kind::rounded, 0.02 * inch};
  double upper = 0.;
  for (const double tilt : {0.05, -0.05}) {
    pin.clearance.tilt = tilt * degree;
    const PinLineContact contact =
        resolved_edges(pin, pin_force, pin_line_contact(pin, pin_force, 5e-4));
    if (upper != 0.) {
      EXPECT_NEAR(contact.peak_pressure, upper, 1e-4 * upper);
    }
    upper = contact.peak_pressure;
  }
}

TEST(PinLine, LeavesAContactThatReachesNoRoundedEdge) {
  PinLine pin = crowned();
  pin.clearance.wall_edge = {EdgeBreak::Kind::rounded, 0.01 * inch};
  const PinLineContact contact = pin_line_contact(pin, pin_force, 1e-3);
  EXPECT_EQ(resolved_edges(pin, pin_force, contact).peak_pressure, contact.peak_pressure);
  const PinLine sharp = johnson();
  EXPECT_EQ(
      peak_doubt(sharp, resolved_edges(sharp, pin_force, pin_line_contact(sharp, pin_force, 1e-3))),
      PeakDoubt::reaches_edge);
}

double at(const double least, const double most, const int millionths) {
  return least + (most - least) * 1e-6 * millionths;
}

/// Newton's method went to and fro where a section was now far from another one and now near.
TEST(PinLine, FindsTheBalanceWhereASectionIsJustFarFromAnother) {
  PinLine pin = johnson();
  const double radius = pin.radius;
  pin.pin.poissons_ratio = at(0., 0.49, 802134);
  pin.wheel.poissons_ratio = at(0., 0.49, 674346);
  pin.wheel.youngs_modulus *= std::pow(10., at(-2., 1., 256917));
  pin.clearance.wall_half = radius * std::pow(10., at(-0.5, 0.7, 480748));
  pin.clearance.lower_end = -pin.clearance.wall_half;
  pin.clearance.upper_end = pin.clearance.wall_half + radius * at(0., 2., 44467);
  pin.clearance.profile = Crown{radius * std::pow(10., at(1.7, 5., 131903))};
  pin.clearance.tilt = at(-0.3, 0.3, 399763) * degree;
  pin.wheel_twist *= at(0., 3., 234900);
  const double force = pin_force * std::pow(10., at(-2., 1., 837894));
  EXPECT_NEAR(force_of(pin_line_contact(pin, force, 1e-3)) / force, 1., 1e-8);
}

TEST(PinLine, RefusesWhatItCannotCarry) {
  PinLine pin = johnson();
  EXPECT_THROW(pin_line_contact(pin, 0., 1e-3), base::InputError);
  pin.radius = -1.;
  EXPECT_THROW(pin_line_contact(pin, pin_force, 1e-3), base::InputError);
}

}  // namespace
}  // namespace geneva::loads::test
