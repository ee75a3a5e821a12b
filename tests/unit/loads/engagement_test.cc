#include "loads/engagement.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "loads/pi.h"
#include "random_values.h"
#include "refusal.h"

namespace geneva::loads {
namespace {

using test::between;
using test::expect_refused;
using test::random_stations;

constexpr double degree = pi / 180.;
constexpr double centre_distance = 0.1;
constexpr double wheel_inertia = 2e-3;
constexpr WheelLoad inertia_only{1e-3, 0.};
constexpr DriverMotion steady{60., 0.};

double force(const ExternalGeneva& geneva, double angle) {
  return pin_load(geneva, centre_distance, steady, wheel_inertia, inertia_only, angle).force;
}

struct PeakForce {
  int stations;
  double excess;  // over the force at the peak of acceleration, percent
  double angle;   // before the line of centres, degrees
};

class PeakForceComesBeforePeakAcceleration : public testing::TestWithParam<PeakForce> {};

TEST_P(PeakForceComesBeforePeakAcceleration, ByTheListedAngleAndExcess) {
  const ExternalGeneva geneva(GetParam().stations);
  const double angle =
      peak_force_angle(geneva, centre_distance, steady, wheel_inertia, inertia_only);
  const double excess =
      force(geneva, angle) / force(geneva, -geneva.peak_acceleration_angle()) - 1.;
  EXPECT_NEAR(-angle / degree, GetParam().angle, 5.1e-5);  // half a unit of the last digit given
  EXPECT_NEAR(100. * excess, GetParam().excess, 5.1e-5);
}

INSTANTIATE_TEST_SUITE_P(WithoutFriction, PeakForceComesBeforePeakAcceleration,
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
  const WheelLoad load{1e-3, 0.2};
  const double beta = geneva.peak_acceleration_angle();
  const PinLoad state = pin_load(geneva, centre_distance, steady, wheel_inertia, load, -beta);
  const double acceleration = 5.4070 * 3600.;
  const double arm = 0.2387 * centre_distance * std::sqrt(2.);  // k D, D = 2 c cos(45 deg)
  EXPECT_EQ(state.driver_angle, -beta);
  EXPECT_NEAR(state.wheel_acceleration / acceleration, 1., 1e-5);  // digits of 5.4070
  EXPECT_NEAR(state.pin_distance / arm, 1., 2.5e-4);               // digits of 0.2387
  EXPECT_NEAR(state.force / ((3e-3 * acceleration + 0.2) / arm), 1., 3e-4);
  EXPECT_NEAR(state.wheel_speed, 60. * geneva.speed_ratio(-beta), 1e-12);
  EXPECT_LT(state.wheel_angle, 0.);
}

TEST(PinLoad, CarriesNothingAtTheLineOfCentresWithoutFriction) {
  EXPECT_NEAR(force(ExternalGeneva(6), 0.), 0., 1e-12);
}

TEST(PinLoad, ContainsTheDriversAcceleration) {
  const ExternalGeneva geneva(6);  // speed ratio 1 at the line of centres, pin at c/2
  const PinLoad state = pin_load(geneva, 0.1, {60., 500.}, 2e-3, {1e-3, 0.}, 0.);
  EXPECT_NEAR(state.force, 3e-3 * 500. / 0.05, 1e-10);
}

TEST(PinLoad, IsGivenAtBothEndsOfTheEngagement) {
  for (int n = 3; n <= 24; ++n) {
    const ExternalGeneva geneva(n);
    const double end = 90. * degree - 180. * degree / n;
    EXPECT_GT(force(geneva, -end), 0.) << n;
    EXPECT_LT(force(geneva, end), 0.) << n;
  }
}

TEST(PinLoad, RefusesAnglesBeyondTheEngagement) {
  expect_refused([] { force(ExternalGeneva(6), -61. * degree); },
                 {"driver angle is -61 deg", "6 stations", "from -60 deg to 60 deg", "choose"});
  expect_refused([] { force(ExternalGeneva(6), std::nan("")); }, {"driver angle is nan deg"});
}

TEST(PinLoad, RefusesDriverAtRestOrBackwards) {
  expect_refused(
      [] {
        pin_load(ExternalGeneva(6), 0.1, {0., 0.}, wheel_inertia, inertia_only, 0.);
      },
      {"driver speed is 0 rad/s", "positive"});
}

TEST(PinLoad, RefusesCentreDistanceThatIsNotPositive) {
  expect_refused([] { pin_load(ExternalGeneva(6), -0.1, steady, wheel_inertia, inertia_only, 0.); },
                 {"centre distance is -100 mm", "positive"});
}

TEST(PeakForceAngle, RefusesWheelWithoutInertia) {
  expect_refused([] { peak_force_angle(ExternalGeneva(6), 0.1, steady, 0., inertia_only); },
                 {"wheel inertia is 0 kg m^2", "positive"});
}

TEST(PeakForceAngle, TendsToTheLineOfCentresWhenFrictionPrevails) {
  // F ~ M_f/x, greatest where x is least; the inertia's share shifts it by about its size, 1e-9
  const double angle =
      peak_force_angle(ExternalGeneva(6), 0.1, {1e-3, 0.}, wheel_inertia, {1e-3, 10.});
  EXPECT_NEAR(angle, 0., 1e-8);
}

TEST(PeakForceAngle, IsAtEntryWhenTheDriverBrakesHard) {
  // a = omega^2 tan(alpha) > 0 at entry, where the driver's braking does not act yet
  const ExternalGeneva geneva(6);
  EXPECT_EQ(peak_force_angle(geneva, 0.1, {10., -1e4}, wheel_inertia, inertia_only),
            -geneva.engagement_angle());
}

RC_GTEST_PROP(PinLoadProperty, ForceIsPositiveBeforeTheLineOfCentres, ()) {
  const ExternalGeneva geneva(random_stations());
  const WheelLoad load{between(0., 1.), between(0., 10.)};
  const double angle = -between(1e-3, 1.) * geneva.engagement_angle();
  const PinLoad state =
      pin_load(geneva, between(1e-2, 1.), {between(1., 100.), 0.}, between(1e-5, 1.), load, angle);
  RC_ASSERT(state.force > 0.);
}

RC_GTEST_PROP(PinLoadProperty, NoForceExceedsThatOfThePeakForceAngle, ()) {
  const ExternalGeneva geneva(random_stations());
  const WheelLoad load{between(0., 1e-2), between(0., 10.)};
  const DriverMotion motion{between(1., 100.), between(-1000., 1000.)};
  const double peak = peak_force_angle(geneva, centre_distance, motion, wheel_inertia, load);
  const auto force_at = [&](double angle) {
    return pin_load(geneva, centre_distance, motion, wheel_inertia, load, angle).force;
  };
  const double angle = between(-1., 1.) * geneva.engagement_angle();
  // a rounding of the two terms of the moment, which may cancel
  const double rounding = 1e-12 * (std::abs(force_at(peak)) + std::abs(force_at(angle)));
  RC_ASSERT(force_at(angle) <= force_at(peak) + rounding);
}

RC_GTEST_PROP(PinLoadProperty, PowerOfThePinForceIsThatOfTheWheel, ()) {
  // The pin's velocity across the slot is x dphi/dt: force times it is moment times wheel speed.
  // Independent check of the arm: component of the pin's velocity omega r normal to the slot.
  const ExternalGeneva geneva(random_stations());
  const double angle = between(-1., 1.) * geneva.engagement_angle();
  const PinLoad state =
      pin_load(geneva, centre_distance, steady, wheel_inertia, {1e-3, 0.5}, angle);
  const double crank = centre_distance * geneva.crank_ratio();
  const double across = steady.speed * crank * std::cos(angle + state.wheel_angle);
  RC_ASSERT(std::abs(across - state.pin_distance * state.wheel_speed) <
            1e-12 * steady.speed * crank);
}

}  // namespace
}  // namespace geneva::loads
