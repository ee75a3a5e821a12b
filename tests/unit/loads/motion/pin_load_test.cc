#include "loads/motion/pin_load.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "loads/motion/external_geneva.h"
#include "loads/motion/four_bar_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/motion/long_dwell_geneva.h"
#include "loads/motion/spherical_geneva.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/random_values.h"

namespace geneva::loads {
namespace {

using test::between;
using test::expect_refused;
using test::random_stations;

constexpr double centre_distance = 0.1;
constexpr WheelTrain inertia_only{2e-3, {1e-3, 0.}};

DrivenMechanism driven(int stations, double speed = 60., double acceleration = 0.) {
  const Mechanism mechanism = external_geneva(stations, centre_distance);
  const auto pins = engagements(mechanism, {0.});
  return {mechanism, pins, constant_acceleration(mechanism, pins, speed, acceleration)};
}

PinLoad load_at(const DrivenMechanism& mechanism, const WheelTrain& train, double angle) {
  return pin_load(mechanism.at_engaged_angle(angle), train);
}

double force(int stations, double angle) {
  return load_at(driven(stations), inertia_only, angle).force;
}

struct PeakForce {
  int stations;
  double excess;  // over the force at the peak of acceleration, percent
  double angle;   // before the line of centres, degrees
};

class PeakForceComesAfterPeakAcceleration : public testing::TestWithParam<PeakForce> {};

TEST_P(PeakForceComesAfterPeakAcceleration, ByTheListedAngleAndExcess) {
  const int n = GetParam().stations;
  const double angle = peak_force_angle(driven(n), inertia_only);
  const double excess =
      force(n, angle) / force(n, -ExternalGeneva(n).peak_acceleration_angle()) - 1.;
  EXPECT_NEAR(-angle / degree, GetParam().angle, 5.1e-5);  // half a unit of the last digit given
  EXPECT_NEAR(100. * excess, GetParam().excess, 5.1e-5);
  EXPECT_NEAR(peak_acceleration_angle(driven(n)), -ExternalGeneva(n).peak_acceleration_angle(),
              1e-7);
}

INSTANTIATE_TEST_SUITE_P(WithoutFriction, PeakForceComesAfterPeakAcceleration,
                         testing::Values(PeakForce{3, 1.7586, 4.1218}, PeakForce{4, 1.7234, 9.9436},
                                         PeakForce{5, 1.6660, 15.2749},
                                         PeakForce{6, 1.5959, 19.9649},
                                         PeakForce{8, 1.4408, 27.7628},
                                         PeakForce{10, 1.2854, 34.0110}),
                         [](const testing::TestParamInfo<PeakForce>& peak) {
                           return std::to_string(peak.param.stations) + "stations";
                         });

TEST(PinLoad, IsTheTorqueBalanceAtThePeakOfAcceleration) {
  const ExternalGeneva geneva(4);
  const double beta = geneva.peak_acceleration_angle();
  const PinLoad state = load_at(driven(4), {2e-3, {1e-3, 0.2}}, -beta);
  const double acceleration = 5.4070 * 3600.;
  const double arm = 0.2387 * centre_distance * std::sqrt(2.);  // k D, D = 2 c cos(45 deg)
  EXPECT_NEAR(state.driver_angle, -beta, 1e-14);
  EXPECT_NEAR(state.wheel_acceleration / acceleration, 1., 1e-5);  // digits of 5.4070
  EXPECT_NEAR(state.pin_distance / arm, 1., 2.5e-4);               // digits of 0.2387
  EXPECT_NEAR(state.force / ((3e-3 * acceleration + 0.2) / arm), 1., 3e-4);
  EXPECT_NEAR(state.wheel_speed, 60. * geneva.speed_ratio(-beta), 1e-12);
  EXPECT_LT(state.wheel_angle, 0.);
  EXPECT_LT(state.travel_speed, 0.) << "inwards";
  EXPECT_EQ(state.slip_speed, state.travel_speed) << "a pin without diameter";
}

TEST(PinLoad, CarriesNothingAtTheLineOfCentresWithoutFriction) {
  EXPECT_NEAR(force(6, 0.), 0., 1e-12);
}

TEST(PinLoad, ContainsTheDriversAcceleration) {
  // speed ratio 1 at the line of centres, pin at c/2
  EXPECT_NEAR(load_at(driven(6, 60., 500.), inertia_only, 0.).force, 3e-3 * 500. / 0.05, 1e-10);
}

TEST(PinLoad, ChangesTheWallWhereTheWheelSlowsDown) {
  for (int n = 3; n <= 24; ++n) {
    const double end = 90. * degree - 180. * degree / n;
    EXPECT_EQ(load_at(driven(n), inertia_only, -end).wall, Wall::driving) << n;
    EXPECT_EQ(load_at(driven(n), inertia_only, end).wall, Wall::braking) << n;
    // with friction the driving wall carries a little longer
    const WheelTrain rough{2e-3, {1e-3, 1e-3}};
    EXPECT_EQ(load_at(driven(n), rough, 1e-9).wall, Wall::driving) << n;
  }
}

TEST(PinLoad, ContainsTheExternalTorque) {
  WheelTrain train{0., {0., 0.3}};
  train.external_torque = 0.7;
  EXPECT_NEAR(load_at(driven(6), train, 0.).force, 1. / 0.05, 1e-10);
}

WheelTrain rough_train(double coefficient, double pin_diameter) {
  WheelTrain train = inertia_only;
  train.slot_friction = coefficient;
  train.pin_diameter = pin_diameter;
  return train;
}

/// Slot friction helps while the pin's surface moves inwards on the wall that carries and hinders
/// while it moves outwards. The surface turns back at -8.18 deg on the driving wall and at 8.18 deg
/// on the braking one (n = 4, d = 0.15 D), not at the line of centres.
TEST(PinLoad, HasTheArmOfSlotFriction) {
  const WheelTrain train = rough_train(0.1, 0.15 * std::sqrt(2.) * centre_distance);
  const double lever = 0.1 * train.pin_diameter / 2.;
  for (const double angle : {-40., -8.3, -8.1, -2., 2., 8.1, 8.3, 40.}) {
    const PinLoad smooth = load_at(driven(4), inertia_only, angle * degree);
    const PinLoad rough = load_at(driven(4), train, angle * degree);
    const bool is_inwards = angle < -8.1766 || (angle > 0. && angle < 8.1766);
    EXPECT_EQ(rough.wall, angle < 0. ? Wall::driving : Wall::braking) << angle;
    EXPECT_EQ(rough.slip_speed < 0., is_inwards) << angle;
    EXPECT_EQ(rough.slip_speed, angle < 0. ? rough.slip_driving : rough.slip_braking) << angle;
    const double arm = smooth.pin_distance + (is_inwards ? lever : -lever);
    EXPECT_NEAR(rough.force * arm, smooth.force * smooth.pin_distance, 1e-12) << angle;
  }
}

/// Johnson's optimum wheel (Example 1, unrounded) about its maximum force: the surface slides
/// with 14.55 in/s, the axis with 75.09 in/s.
TEST(PinLoad, KnowsTheSlipOfJohnsonsWheelAtMaximumForce) {
  const double diameter = 4.53;  // in; speeds in in/s
  const Mechanism mechanism = external_geneva(4, diameter / std::sqrt(2.));
  const auto pins = engagements(mechanism, {0.});
  const DrivenMechanism johnson(mechanism, pins, constant_speed(mechanism, pins, 20. * pi));
  WheelTrain train{0.00707686, {0.00460658, 0.}};
  train.pin_diameter = 0.15 * diameter;
  const PinLoad load = load_at(johnson, train, peak_force_angle(johnson, train));
  EXPECT_NEAR(load.driver_angle / degree, -9.9436, 5.1e-5);
  EXPECT_NEAR(load.force, 234.570, 2e-3);
  train.load.friction_moment = 2.;
  const PinLoad loaded = load_at(johnson, train, peak_force_angle(johnson, train));
  EXPECT_NEAR(loaded.driver_angle / degree, -9.9336, 5.1e-5);
  const PinLoad there = load_at(johnson, train, -9.94 * degree);
  EXPECT_NEAR(there.slip_speed, -14.55, 1e-2);
  EXPECT_NEAR(there.travel_speed, -75.09, 1e-2);
  const std::vector<std::array<double, 3>> rows{// angle, force, slip on the wall that carries
                                                {-45., 21.247, -120.967},
                                                {-20., 145.354, -75.812},
                                                {-5., 178.872, 28.132},
                                                {0., 2.132, 72.884},
                                                {20., -142.335, 75.812}};
  for (const auto& [angle, force_there, slip] : rows) {
    const PinLoad at = load_at(johnson, train, angle * degree);
    EXPECT_NEAR(at.force, force_there, 1.1e-3) << angle;
    EXPECT_NEAR(at.slip_speed, slip, 5.1e-4) << angle;
  }
}

/// Wherever the force changes its wall, friction is that of the wall that carries: the balance
/// holds with it, and with that of no other wall.
TEST(PinLoad, HasOneWallThatAgreesWithItsOwnFriction) {
  for (const double moment : {-0.4, -0.02, 0.02, 0.4}) {
    WheelTrain train = rough_train(0.6, 0.02);
    train.external_torque = moment;
    for (int step = -176; step < 180; ++step) {
      const double angle = 0.25 * step;
      const MotionState state = driven(4, 5.).at_engaged_angle(angle * degree);
      const PinLoad load = pin_load(state, train);
      int solutions = 0;
      for (const Wall wall : {Wall::driving, Wall::braking}) {
        const double slip =
            surface_speed(state.slot_position, state.pin_turn, train.pin_diameter, wall);
        const double arm = load.pin_distance - (slip > 0. ? 0.006 : slip < 0. ? -0.006 : 0.);
        const double there = load.moment / arm;
        const bool agrees = (there > 0.) == (wall == Wall::driving) && there != 0.;
        if (!agrees) continue;
        ++solutions;
        EXPECT_EQ(load.wall, wall) << angle;
        EXPECT_NEAR(load.force, there, 1e-12 * std::abs(there)) << angle;
        EXPECT_EQ(load.slip_speed, slip) << angle;
      }
      EXPECT_EQ(solutions, 1) << angle;
    }
  }
}

/// The maximum force lies where friction turns from helping to hindering, on the hindering side.
TEST(PeakForceAngle, IsOnTheGreaterSideOfAJumpOfFriction) {
  const WheelTrain train = rough_train(0.1, 0.15 * std::sqrt(2.) * centre_distance);
  const double angle = peak_force_angle(driven(4), train);
  EXPECT_NEAR(angle / degree, -8.1766, 5.1e-5);
  const double peak = load_at(driven(4), train, angle).force;
  double sampled = 0.;
  for (int step = -44900; step < 45000; ++step)
    sampled = std::max(sampled, load_at(driven(4), train, 1e-3 * step * degree).force);
  EXPECT_GE(peak, sampled);
  EXPECT_NEAR(peak, sampled, 1e-4 * peak) << "a thousandth of a degree away";
  EXPECT_LT(load_at(driven(4), train, angle - 1e-9).force, 0.98 * peak);
}

WheelTrain roller_train(double bore_diameter, double friction) {
  WheelTrain train{2e-3, {1e-3, 0.2}};
  train.pin_diameter = 0.02;
  train.roller = RollerBore{bore_diameter, friction};
  return train;
}

TEST(Roller, DoesNotSlideOnTheWallButInItsBore) {
  WheelTrain fixed = roller_train(0.008, 0.);
  fixed.roller.reset();
  for (const double angle : {-40., -8., 0.01, 30.}) {
    const PinLoad rolling = load_at(driven(4), roller_train(0.008, 0.1), angle * degree);
    const PinLoad sliding = load_at(driven(4), fixed, angle * degree);
    EXPECT_EQ(rolling.slip_speed, 0.);
    EXPECT_EQ(rolling.slip_driving, 0.);
    EXPECT_EQ(rolling.slip_braking, 0.);
    EXPECT_EQ(rolling.travel_speed, sliding.travel_speed);
    EXPECT_EQ(sliding.bore_speed, 0.);
    EXPECT_NEAR(rolling.bore_speed, 0.4 * std::abs(sliding.slip_speed), 1e-15);
  }
}

/// The roller as a body of its own: it turns so that its material point at the wall stands still on
/// the wheel, its stud turns with the carrier, and the moment of the bore works against the turning
/// of the one on the other. The force along the wall that this asks for is the program's.
TEST(Roller, IsTurnedByTheWallAgainstTheFrictionOfItsBore) {
  const WheelTrain train = roller_train(0.008, 0.25);
  for (const double angle : {-43., -20., -3., 4., 25., 40.}) {
    const PinLoad load = load_at(driven(4), train, angle * degree);
    const double side = load.force > 0. ? 1. : -1.;
    // counter-clockwise, as seen from the wheel: u' - side (d/2) spin = 0 at the wall
    const double spin = side * load.travel_speed / 0.01;
    const double stud = -load.pin_turn_speed;
    const double bore_moment = 0.25 * std::abs(load.force) * 0.004;
    EXPECT_NEAR(load.bore_speed, std::abs(spin - stud) * 0.004, 1e-15);
    // moments on the roller: the bore's, and the wall's force at side d/2
    const double from_bore = spin > stud ? -bore_moment : bore_moment;
    const double on_roller = from_bore / (side * 0.01);  // along the slot
    const double on_wheel = -on_roller;
    EXPECT_NEAR(load.force * load.pin_distance - side * 0.01 * on_wheel, load.moment,
                1e-12 * std::abs(load.moment))
        << angle;
    EXPECT_NEAR(std::abs(on_wheel), friction_along_wall(train) * std::abs(load.force), 1e-12);
  }
}

/// What the driver gives is what the wheel gets and what slides away in the bore.
TEST(Roller, PowerOfTheDriverIsThatOfTheWheelAndOfTheBore) {
  const WheelTrain train = roller_train(0.012, 0.2);
  for (const double angle : {-43., -20., -3., 4., 25., 40.}) {
    const PinLoad load = load_at(driven(4), train, angle * degree);
    const double to_wheel = load.moment * load.wheel_speed;
    const double lost = 0.2 * std::abs(load.force) * load.bore_speed;
    // the stud takes the wall's force at the pin's axis, and the moment of the bore
    const double side = load.force > 0. ? 1. : -1.;
    const double along = (load.force * load.pin_distance - load.moment) / (side * 0.01);
    const double theta = load.driver_angle;
    const double phi = load.wheel_angle;
    const double crank = centre_distance * std::sin(pi / 4.);
    const double velocity[2] = {crank * load.driver_speed * std::sin(theta),
                                crank * load.driver_speed * std::cos(theta)};
    const double force_on_roller[2] = {load.force * -std::sin(phi) + along * std::cos(phi),
                                       load.force * std::cos(phi) + along * std::sin(phi)};
    const double spin = side * load.travel_speed / 0.01;
    const double moment_on_roller =
        (spin > -load.pin_turn_speed ? -1. : 1.) * 0.2 * std::abs(load.force) * 0.006;
    const double from_driver = force_on_roller[0] * velocity[0] + force_on_roller[1] * velocity[1] +
                               moment_on_roller * -load.driver_speed;
    EXPECT_NEAR(from_driver, to_wheel + lost, 1e-10 * std::abs(from_driver)) << angle;
  }
}

TEST(Roller, IsRefusedWithABoreThatCannotBe) {
  expect_refused([] { check(roller_train(0.02, 0.1), driven(4)); },
                 {"bore diameter of the roller is 20 mm", "less than", "20 mm"});
  expect_refused([] { check(roller_train(0., 0.1), driven(4)); }, {"bore diameter of the roller"});
  expect_refused([] { check(roller_train(0.01, -0.1), driven(4)); },
                 {"coefficient of bore friction is -0.1"});
  expect_refused([] { check(roller_train(0.01, 11.), driven(6)); },
                 {"coefficient of bore friction is 11", "roller of 20 mm jams", "below 10"});
  EXPECT_NO_THROW(check(roller_train(0.01, 9.9), driven(6)));
}

/// The forces on driver and wheel at the point of contact, and their power: what the driver gives
/// is what the wheel gets and what slides away. The bodies turn about their own axes, and do not
/// penetrate each other.
TEST(PinLoad, PowerOfTheDriverIsThatOfTheWheelAndOfFriction) {
  WheelTrain train{2e-3, {1e-3, 0.2}};
  train.slot_friction = 0.15;
  train.pin_diameter = 0.02;
  for (const double angle : {-55., -20., -12., -3., 4., 12., 25., 50.}) {
    const PinLoad load = load_at(driven(6), train, angle * degree);
    // The wheel's axis is the origin, the driver's at (c, 0); the wheel turns counter-clockwise.
    const double phi = load.wheel_angle;
    const double along[2] = {std::cos(phi), std::sin(phi)};
    const double normal[2] = {-std::sin(phi), std::cos(phi)};
    const double side = load.force > 0. ? 1. : -1.;
    const double x = load.pin_distance * along[0] + side * 0.01 * normal[0];
    const double y = load.pin_distance * along[1] + side * 0.01 * normal[1];
    const double wheel[2] = {-load.wheel_speed * y, load.wheel_speed * x};
    const double driver[2] = {load.driver_speed * y, -load.driver_speed * (x - centre_distance)};
    const double slide[2] = {driver[0] - wheel[0], driver[1] - wheel[1]};
    EXPECT_NEAR(slide[0] * normal[0] + slide[1] * normal[1], 0., 1e-12) << "no penetration";
    EXPECT_NEAR(slide[0] * along[0] + slide[1] * along[1], load.slip_speed, 1e-12) << angle;
    const double friction = 0.15 * std::abs(load.force) * (load.slip_speed > 0. ? 1. : -1.);
    const double f[2] = {load.force * normal[0] + friction * along[0],
                         load.force * normal[1] + friction * along[1]};
    const double to_wheel = f[0] * wheel[0] + f[1] * wheel[1];
    const double from_driver = f[0] * driver[0] + f[1] * driver[1];
    const double lost = friction * (slide[0] * along[0] + slide[1] * along[1]);
    EXPECT_GT(lost, 0.) << "friction gives no work, at " << angle;
    EXPECT_NEAR(to_wheel, load.moment * load.wheel_speed, 1e-10 * std::abs(to_wheel)) << angle;
    EXPECT_NEAR(from_driver, to_wheel + lost, 1e-10 * std::abs(from_driver)) << angle;
  }
}

/// Gauss-Legendre integral with five points in each of many intervals.
double integral(const std::function<double(double)>& f, double begin, double end) {
  constexpr double points[] = {0., 0.5384693101056831, 0.9061798459386640};
  constexpr double weights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  constexpr int intervals = 400;
  const double half = (end - begin) / (2. * intervals);
  double sum = 0.;
  for (int i = 0; i < intervals; ++i) {
    const double middle = begin + (2. * i + 1.) * half;
    sum += weights[0] * f(middle);
    for (int k = 1; k < 3; ++k)
      sum += weights[k] * (f(middle - points[k] * half) + f(middle + points[k] * half));
  }
  return sum * half;
}

std::vector<DrivenMechanism> every_mechanism() {
  std::vector<DrivenMechanism> all;
  const double c = centre_distance;
  for (const Mechanism& mechanism :
       {external_geneva(5, c), internal_geneva(5, c), spherical_geneva(5, 1.2, c),
        long_dwell_geneva(5, c, 0.05, SprocketLine::along_line_of_centres),
        long_dwell_geneva(5, c, 0.05, SprocketLine::across_line_of_centres),
        four_bar_geneva(5, {{0., 0.}, {0.1, 0.}, 0.04, 0.12, 0.12, 0.12, pi / 2.}, Assembly::open,
                        {150. * degree, std::nullopt})
            .mechanism}) {
    const auto pins = engagements(mechanism, {0.});
    all.emplace_back(mechanism, pins, constant_speed(mechanism, pins, 20.));
    all.emplace_back(mechanism, pins, constant_acceleration(mechanism, pins, 20., 50.));
    for (const MotionLaw law : {MotionLaw::harmonic, MotionLaw::cycloidal})
      all.emplace_back(mechanism, pins, law_on_carrier(mechanism, pins, law, 0.1));
  }
  for (const MotionLaw law : {MotionLaw::harmonic, MotionLaw::cycloidal}) {
    const Mechanism mechanism = external_geneva(5, c);
    const auto pins = engagements(mechanism, {0.});
    all.emplace_back(mechanism, pins,
                     law_on_cross(mechanism, PlaneGeneva::external, c, pins, law, 0.1));
  }
  return all;
}

/// Time at which the moment on the wheel changes its sign for the first time; the begin if it does
/// not.
double wall_change(const DrivenMechanism& mechanism, const WheelTrain& train) {
  const TimedEngagement& engagement = mechanism.engagements().front();
  const auto moment = [&](double time) { return pin_load(mechanism.at_time(time), train).moment; };
  constexpr int intervals = 1000;
  const double step = (engagement.end - engagement.begin) / intervals;
  for (int i = 0; i + 1 < intervals; ++i) {
    double before = engagement.begin + step * i;
    double after = before + step;
    if ((moment(before) > 0.) == (moment(after) > 0.)) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = (before + after) / 2.;
      ((moment(middle) > 0.) == (moment(before) > 0.) ? before : after) = middle;
    }
    return before;
  }
  return engagement.begin;
}

/// Work of the pin's normal force and friction against the change of kinetic energy, the work of
/// friction and of the external torque. The force comes from the torque balance, the speed from the
/// mechanism; the work is taken to the middle of the engagement, where the wheel is fast.
TEST(Energy, WorkOfThePinIsKineticEnergyAndFriction) {
  WheelTrain train{2e-3, {1e-3, 0.2}};
  train.external_torque = 0.1;
  train.slot_friction = 0.1;
  train.pin_diameter = 0.01;
  for (const DrivenMechanism& mechanism : every_mechanism()) {
    const TimedEngagement& engagement = mechanism.engagements().front();
    std::vector<double> times{engagement.begin};
    for (const double joint : mechanism.joints(engagement)) times.push_back(joint);
    for (const SlipReversal& reversal : slip_reversals(mechanism.mechanism(), train.pin_diameter))
      times.push_back(mechanism.drive().time_at(reversal.driver_angle));
    times.push_back(wall_change(mechanism, train));
    times.push_back(engagement.end);
    std::sort(times.begin(), times.end());
    const auto power = [&](double time) {
      const MotionState state = mechanism.at_time(time);
      const PinLoad load = pin_load(state, train);
      const double friction = train.slot_friction * load.force * train.pin_diameter / 2. *
                              state.friction_lever * (load.slip_speed > 0. ? -1. : 1.);
      return (load.force * load.pin_distance + friction) * load.wheel_speed;
    };
    double work = 0.;
    double scale = 0.;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      const double part = integral(power, times[i], times[i + 1]);
      const MotionState from = mechanism.at_time(times[i]);
      const MotionState to = mechanism.at_time(times[i + 1]);
      const double kinetic = 0.5 * 3e-3 *
                             (to.wheel_angle.first * to.wheel_angle.first -
                              from.wheel_angle.first * from.wheel_angle.first);
      const double dissipated = 0.3 * (to.wheel_angle.value - from.wheel_angle.value);
      scale = std::max(scale, std::abs(kinetic) + dissipated);
      EXPECT_NEAR(part, kinetic + dissipated, 1e-8 * scale) << mechanism.mechanism().name;
      work += part;
    }
    EXPECT_NEAR(work, 0.3 * 2. * pi / 5., 1e-8 * scale)
        << mechanism.mechanism().name << ": the wheel rests before and after";
  }
}

TEST(PinLoad, HasTheFrictionOfMotionForwardsAtTheEndsOfAnEngagement) {
  // The wheel's speed is 0 there but for roundings of either sign.
  constexpr double friction = 5.;
  constexpr WheelTrain with_friction{2e-3, {1e-3, friction}};
  constexpr double inside = 1e-7;
  for (int i = 0; i < 200; ++i) {
    const Mechanism mechanism = spherical_geneva(3 + i % 10, 0.3 + 0.0125 * i, 0.1);
    const auto pins = engagements(mechanism, {0.});
    const DrivenMechanism moving(mechanism, pins, constant_speed(mechanism, pins, 40.));
    for (const double end : {mechanism.entry, mechanism.exit}) {
      // The other sign would change the moment by twice the friction.
      EXPECT_NEAR(load_at(moving, with_friction, end).moment,
                  load_at(moving, with_friction, (1. - inside) * end).moment, 1e-4 * friction)
          << i << " at " << end;
    }
  }
}

TEST(PinLoad, RefusesAnglesBeyondTheEngagement) {
  expect_refused([] { force(6, -61. * degree); },
                 {"driver angle is -61 deg", "6 stations", "from -60 deg to 60 deg", "choose"});
  expect_refused([] { force(6, std::nan("")); }, {"driver angle is nan deg"});
  expect_refused([] { pin_load(driven(6).at_time(0.05), inertia_only); }, {"the wheel rests"});
}

TEST(WheelTrain, IsRefusedWithNegativeValuesOrAJammedPin) {
  const auto checked = [](WheelTrain train) { check(train, driven(6)); };
  expect_refused([&] { checked({-1., {0., 0.}}); }, {"wheel inertia is -1 kg m^2"});
  expect_refused([&] { checked({1., {-1., 0.}}); }, {"load inertia is -1"});
  expect_refused([&] { checked({1., {1., -2.}}); }, {"friction moment is -2 N m"});
  expect_refused(
      [&] {
        checked({1., {1., 0.}, 0., 12., 0.02});
      },
      {"coefficient of slot friction is 12", "jams", "must be below 5"});
  EXPECT_NO_THROW(checked({1., {1., 0.}, 0., 4.9, 0.02}));
}

TEST(PeakForceAngle, TendsToTheLineOfCentresWhenFrictionPrevails) {
  // F ~ M_f/x, maximum where x is least; the inertia's share shifts it by about its size, 1e-9,
  // and a flat maximum is found to the root of a rounding
  EXPECT_NEAR(peak_force_angle(driven(6, 1e-3), {2e-3, {1e-3, 10.}}), 0., 1e-7);
}

TEST(PeakForceAngle, IsFoundAtAnyDeceleration) {
  // In two of these two thousand motions times next to the end of the engagement are rounded up.
  constexpr double speed = 87.128614;
  const WheelTrain train{2e-3, {2.28773e-3, 0.}};
  for (int i = 0; i < 2000; ++i) {
    const double deceleration = (.088 - 4e-7 * i) * speed * speed;
    EXPECT_NO_THROW(peak_force_angle(driven(3, speed, -deceleration), train)) << i;
  }
}

RC_GTEST_PROP(PinLoadProperty, ForceIsPositiveBeforeTheLineOfCentres, ()) {
  const int n = random_stations();
  const WheelTrain train{between(1e-5, 1.), {between(0., 1.), between(0., 10.)}};
  const DrivenMechanism mechanism = driven(n, between(1., 100.));
  RC_ASSERT(load_at(mechanism, train, between(1e-3, 1.) * mechanism.mechanism().entry).force > 0.);
}

RC_GTEST_PROP(PinLoadProperty, NoForceExceedsThatOfThePeakForceAngle, ()) {
  WheelTrain train{2e-3, {between(0., 1e-2), between(0., 10.)}};
  train.slot_friction = between(0., 0.5);
  train.pin_diameter = between(0., 0.02);
  const double speed = between(1., 100.);
  const DrivenMechanism mechanism =
      driven(random_stations(), speed, between(-.2, .2) * speed * speed);
  const double peak = peak_force_angle(mechanism, train);
  const double angle = between(-1., 1.) * mechanism.mechanism().exit;
  const double at_peak = load_at(mechanism, train, peak).force;
  RC_ASSERT(load_at(mechanism, train, angle).force <= at_peak + 1e-9 * std::abs(at_peak));
}

}  // namespace
}  // namespace geneva::loads
