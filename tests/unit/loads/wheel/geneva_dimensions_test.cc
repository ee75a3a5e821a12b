#include "loads/wheel/geneva_dimensions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "loads/design/johnson.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

using test::expect_refused;

/// A wheel of 100 mm with Johnson's proportions: r = 50, c = 70.7107, nearest pin 20.7107, pin and
/// slot 15, slot depth 36.7893, bore 6.60534 and locking radius 35 (all mm).
GenevaDimensions four_stations() {
  GenevaDimensionsInput input{};
  input.stations = 4;
  input.wheel_diameter = 0.1;
  return complete_dimensions(input);
}

GenevaDimensionsInput size_of(int stations, double wheel_diameter) {
  GenevaDimensionsInput input{};
  input.stations = stations;
  input.wheel_diameter = wheel_diameter;
  return input;
}

/// A few roundings of lengths of 0.1 m.
constexpr double length_rounding = 1e-15;

TEST(GenevaDimensions, DefaultsAreAcceptedForEveryNumberOfStations) {
  for (int n = 3; n <= 24; ++n)
    for (const double diameter : {1e-3, 0.1, 5.})
      EXPECT_NO_THROW(complete_dimensions(size_of(n, diameter))) << n << ' ' << diameter;
}

TEST(GenevaDimensions, SizeFollowsFromAnyOneOfDiameterCrankAndCentreDistance) {
  const GenevaDimensions from_diameter = complete_dimensions(size_of(5, 0.1));
  GenevaDimensionsInput from_crank{};
  from_crank.stations = 5;
  from_crank.crank_radius = from_diameter.crank_radius;
  GenevaDimensionsInput from_centres{};
  from_centres.stations = 5;
  from_centres.centre_distance = from_diameter.centre_distance;
  EXPECT_NEAR(complete_dimensions(from_crank).wheel_diameter, 0.1, length_rounding);
  EXPECT_NEAR(complete_dimensions(from_centres).wheel_diameter, 0.1, length_rounding);
}

TEST(GenevaDimensions, DefaultsFollowJohnsonsProportions) {
  const GenevaDimensions wheel = four_stations();
  EXPECT_NEAR(wheel.crank_radius, 0.05, length_rounding);
  EXPECT_NEAR(wheel.centre_distance, 0.1 / std::sqrt(2.), length_rounding);
  EXPECT_NEAR(wheel.pin_diameter, 0.015, length_rounding);
  EXPECT_NEAR(wheel.thickness, 0.015, length_rounding);
  EXPECT_NEAR(wheel.locking_radius, 0.035, length_rounding);
  EXPECT_NEAR(wheel.slot_width, 0.015, length_rounding);
  EXPECT_NEAR(wheel.pin_core_radius, 0.00375, length_rounding);
  EXPECT_NEAR(wheel.bore_radius, (0.1 / std::sqrt(2.) - 0.05 - 0.0075) / 2., length_rounding);
}

TEST(GenevaDimensions, DefaultSlotBottomIsCentredAtThePinsNearestPosition) {
  for (int n = 3; n <= 24; ++n) {
    GenevaDimensionsInput input = size_of(n, 0.1);
    input.slot_clearance = 2e-4;
    const GenevaDimensions wheel = complete_dimensions(input);
    EXPECT_NEAR(slot_bottom_centre(wheel), wheel.centre_distance - wheel.crank_radius,
                length_rounding)
        << n;
  }
}

TEST(GenevaDimensions, ClearanceWidensTheSlot) {
  GenevaDimensionsInput input = size_of(6, 0.1);
  input.slot_clearance = 1e-4;
  const GenevaDimensions wheel = complete_dimensions(input);
  EXPECT_NEAR(wheel.slot_width - wheel.pin_diameter, 1e-4, length_rounding);
}

TEST(GenevaDimensions, RefusesNoSize) {
  GenevaDimensionsInput input{};
  input.stations = 4;
  expect_refused([&] { complete_dimensions(input); },
                 {"0 of wheel diameter, crank radius and centre distance", "exactly one", "give"});
}

TEST(GenevaDimensions, RefusesTwoSizes) {
  GenevaDimensionsInput input = size_of(4, 0.1);
  input.crank_radius = 0.05;
  expect_refused([&] { complete_dimensions(input); }, {"2 of wheel diameter", "exactly one"});
}

TEST(GenevaDimensions, RefusesBothSlotWidthAndClearance) {
  GenevaDimensionsInput input = size_of(4, 0.1);
  input.slot_width = 0.0152;
  input.slot_clearance = 0.0002;
  expect_refused([&] { complete_dimensions(input); },
                 {"slot width 15.2 mm", "slot clearance 0.2 mm", "give one"});
}

TEST(GenevaDimensions, RefusesNegativeClearance) {
  GenevaDimensionsInput input = size_of(4, 0.1);
  input.slot_clearance = -1e-4;
  expect_refused([&] { complete_dimensions(input); }, {"slot clearance is -0.1 mm", "negative"});
}

TEST(GenevaDimensions, RefusesStationsOutOfRange) {
  GenevaDimensions wheel = four_stations();
  wheel.stations = 2;
  expect_refused([&] { check(wheel); }, {"number of stations is 2", "3 to 24"});
}

TEST(GenevaDimensions, RefusesEveryLengthThatIsNotPositiveAndFinite) {
  struct Length {
    const char* name;
    double GenevaDimensions::*member;
  };
  const Length lengths[] = {{"wheel diameter", &GenevaDimensions::wheel_diameter},
                            {"crank radius", &GenevaDimensions::crank_radius},
                            {"centre distance", &GenevaDimensions::centre_distance},
                            {"pin diameter", &GenevaDimensions::pin_diameter},
                            {"thickness", &GenevaDimensions::thickness},
                            {"slot width", &GenevaDimensions::slot_width},
                            {"slot depth", &GenevaDimensions::slot_depth},
                            {"locking radius", &GenevaDimensions::locking_radius},
                            {"bore radius", &GenevaDimensions::bore_radius},
                            {"pin core radius", &GenevaDimensions::pin_core_radius}};
  for (const Length& length : lengths) {
    const std::string name = length.name;
    GenevaDimensions wheel = four_stations();
    wheel.*length.member = -3e-3;
    expect_refused([&] { check(wheel); }, {name + " is -3 mm", "must be positive", "greater than"});
    wheel.*length.member = 0.;
    expect_refused([&] { check(wheel); }, {name + " is 0 mm"});
    wheel.*length.member = std::numeric_limits<double>::quiet_NaN();
    expect_refused([&] { check(wheel); }, {name + " is nan mm", "finite"});
    wheel.*length.member = std::numeric_limits<double>::infinity();
    expect_refused([&] { check(wheel); }, {name + " is inf mm", "finite"});
  }
}

TEST(GenevaDimensions, RefusesCrankRadiusThatDoesNotBelongToTheWheel) {
  GenevaDimensions wheel = four_stations();
  wheel.crank_radius = 0.049;
  expect_refused([&] { check(wheel); }, {"crank radius is 49 mm", "50 mm", "change"});
}

TEST(GenevaDimensions, RefusesCentreDistanceThatDoesNotBelongToTheWheel) {
  GenevaDimensions wheel = four_stations();
  wheel.centre_distance = 0.071;
  expect_refused([&] { check(wheel); }, {"centre distance is 71 mm", "70.7106781 mm", "change"});
}

TEST(GenevaDimensions, RefusesPinWiderThanSlot) {
  GenevaDimensions wheel = four_stations();
  wheel.pin_diameter = 0.0152;
  expect_refused([&] { check(wheel); },
                 {"pin diameter is 15.2 mm", "slot width 15 mm", "slot of at least"});
}

TEST(GenevaDimensions, RefusesCoreThatFillsThePin) {
  GenevaDimensions wheel = four_stations();
  wheel.pin_core_radius = 0.0075;
  expect_refused([&] { check(wheel); },
                 {"pin core radius is 7.5 mm", "inside the pin of radius 7.5 mm", "smaller"});
}

TEST(GenevaDimensions, RefusesSlotTooShallowForThePin) {
  GenevaDimensions wheel = four_stations();
  wheel.slot_depth = 0.0365;  // needs 50 - 20.7107 + 7.5
  expect_refused([&] { check(wheel); },
                 {"slot depth is 36.5 mm", "20.7107 mm", "at least 36.7893 mm", "deeper"});
}

TEST(GenevaDimensions, RefusesSlotsThatRunIntoEachOther) {
  GenevaDimensions wheel = four_stations();
  // bottoms centred 10.5 mm from the axis lie 10.5 sqrt(2) = 14.85 mm apart, slots are 15 mm wide
  wheel.slot_depth = 0.047;
  expect_refused([&] { check(wheel); },
                 {"slot width is 15 mm", "14.8492 mm apart", "slot depth 47 mm", "narrower"});
}

TEST(GenevaDimensions, AcceptsSlotsThatAreJustClearOfEachOther) {
  GenevaDimensions wheel = four_stations();
  wheel.slot_depth = 0.0575 - 0.015 / std::sqrt(2.) - 1e-6;
  wheel.bore_radius = 1e-3;
  EXPECT_NO_THROW(check(wheel));
}

TEST(GenevaDimensions, RefusesSlotDeeperThanTheAxis) {
  GenevaDimensionsInput input = size_of(4, 0.1);
  input.slot_depth = 0.06;
  expect_refused([&] { complete_dimensions(input); }, {"slot depth 60 mm", "shallower"});
}

TEST(GenevaDimensions, RefusesSlotIntoBore) {
  GenevaDimensions wheel = four_stations();
  wheel.bore_radius = 0.0133;  // the slots' lowest points are 20.7107 - 7.5 from the axis
  expect_refused([&] { check(wheel); },
                 {"bore radius is 13.3 mm", "13.2107 mm", "make the bore smaller"});
}

TEST(GenevaDimensions, RefusesBoreThatIsAPoint) {
  GenevaDimensions wheel = four_stations();
  wheel.bore_radius = 0.99e-4 * wheel.wheel_diameter;
  expect_refused([&] { check(wheel); }, {"bore radius is", "at least 0.01 mm", "leave it out"});
  wheel.bore_radius = 1.01e-4 * wheel.wheel_diameter;
  EXPECT_NO_THROW(check(wheel));
}

TEST(GenevaDimensions, RefusesLockingArcThatMissesTheRim) {
  GenevaDimensions wheel = four_stations();
  wheel.locking_radius = 0.0207;  // the rim is 20.7107 mm from the arcs' centre
  expect_refused([&] { check(wheel); },
                 {"locking radius is 20.7 mm", "misses the rim", "20.7107 mm", "larger"});
}

TEST(GenevaDimensions, RefusesLockingArcIntoBore) {
  GenevaDimensions wheel = four_stations();
  wheel.bore_radius = 0.010;
  wheel.locking_radius = 0.061;  // less than 70.7107 - 10 is allowed
  expect_refused([&] { check(wheel); },
                 {"locking radius is 61 mm", "bore of radius 10 mm", "60.7107 mm", "smaller"});
}

TEST(GenevaDimensions, RefusesLockingArcIntoSlot) {
  GenevaDimensions wheel = four_stations();
  wheel.locking_radius = 0.045;
  expect_refused([&] { check(wheel); },
                 {"locking radius is 45 mm", "slot of width 15 mm", "smaller"});
}

TEST(GenevaDimensions, TipVanishesWhereLockingArcAndSlotWallMeetOnTheRim) {
  GenevaDimensions wheel = four_stations();
  const double x = std::sqrt(0.05 * 0.05 - 0.0075 * 0.0075);  // the wall's end is (x, 7.5 mm)
  // the arc's centre in the frame of the slot is (D/2, r)
  const double limit = std::hypot(0.05 - x, 0.05 - 0.0075);
  wheel.locking_radius = limit * (1. + 1e-9);
  expect_refused([&] { check(wheel); }, {"locking radius", "no tip is left at the rim"});
  wheel.locking_radius = limit * (1. - 1e-9);
  EXPECT_NO_THROW(check(wheel));
}

}  // namespace
}  // namespace geneva::loads
