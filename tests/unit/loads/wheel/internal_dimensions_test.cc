#include "loads/wheel/internal_dimensions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "loads/design/johnson.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

using test::expect_refused;

InternalDimensionsInput size_of(int stations, double wheel_diameter) {
  InternalDimensionsInput input{};
  input.stations = stations;
  input.wheel_diameter = wheel_diameter;
  return input;
}

/// A wheel of 100 mm with Johnson's proportions: r = 50, c = 70.7107, farthest pin 120.7107, pin
/// and slot 15, slot depth 78.2107, rim radius 143.2107 and locking radius 35 (all mm).
InternalDimensions four_stations() { return complete_internal_dimensions(size_of(4, 0.1)); }

/// A few roundings of lengths of 0.2 m.
constexpr double length_rounding = 1e-15;

TEST(InternalDimensions, DefaultsAreAcceptedForEveryNumberOfStations) {
  for (int n = 3; n <= 24; ++n)
    for (const double diameter : {1e-3, 0.1, 5.})
      EXPECT_NO_THROW(complete_internal_dimensions(size_of(n, diameter))) << n << ' ' << diameter;
}

TEST(InternalDimensions, ShareSizeAndProportionsWithTheExternalWheel) {
  for (int n = 3; n <= 24; ++n) {
    GenevaDimensionsInput external_input{};
    external_input.stations = n;
    external_input.wheel_diameter = 0.1;
    const GenevaDimensions external = complete_dimensions(external_input);
    const InternalDimensions wheel = complete_internal_dimensions(size_of(n, 0.1));
    for (double CommonDimensions::*const member :
         {&CommonDimensions::wheel_diameter, &CommonDimensions::crank_radius,
          &CommonDimensions::centre_distance, &CommonDimensions::pin_diameter,
          &CommonDimensions::thickness, &CommonDimensions::slot_width,
          &CommonDimensions::locking_radius, &CommonDimensions::pin_core_radius})
      EXPECT_EQ(wheel.*member, external.*member) << n;
  }
}

TEST(InternalDimensions, DefaultSlotBottomIsCentredAtThePinsFarthestPosition) {
  for (int n = 3; n <= 24; ++n) {
    InternalDimensionsInput input = size_of(n, 0.1);
    input.slot_clearance = 2e-4;
    const InternalDimensions wheel = complete_internal_dimensions(input);
    EXPECT_NEAR(slot_bottom_centre(wheel), wheel.centre_distance + wheel.crank_radius,
                length_rounding)
        << n;
  }
}

TEST(InternalDimensions, DefaultRimLeavesAWebOverTheSlots) {
  const InternalDimensions wheel = four_stations();
  const double deepest = 0.1 / std::sqrt(2.) + 0.05 + 0.0075;
  EXPECT_NEAR(wheel.slot_depth, deepest - 0.05, length_rounding);
  EXPECT_NEAR(wheel.rim_radius, deepest + 0.015, length_rounding);
  InternalDimensionsInput deeper = size_of(4, 0.1);
  deeper.slot_depth = 0.08;
  EXPECT_NEAR(complete_internal_dimensions(deeper).rim_radius, 0.05 + 0.08 + 0.015,
              length_rounding);
}

TEST(InternalDimensions, SizeFollowsFromCrankOrCentreDistance) {
  InternalDimensionsInput from_crank{};
  from_crank.stations = 4;
  from_crank.crank_radius = 0.05;
  EXPECT_NEAR(complete_internal_dimensions(from_crank).wheel_diameter, 0.1, length_rounding);
  from_crank.centre_distance = 0.07;
  expect_refused([&] { complete_internal_dimensions(from_crank); },
                 {"2 of wheel diameter", "exactly one"});
}

TEST(InternalDimensions, RefusesWhatNoKindOfWheelMayHave) {
  InternalDimensions wheel = four_stations();
  wheel.stations = 25;
  expect_refused([&] { check(wheel); }, {"number of stations is 25", "3 to 24"});
  wheel = four_stations();
  wheel.crank_radius = 0.049;
  expect_refused([&] { check(wheel); }, {"crank radius is 49 mm", "50 mm", "change"});
  wheel = four_stations();
  wheel.pin_diameter = 0.0152;
  expect_refused([&] { check(wheel); }, {"pin diameter is 15.2 mm", "slot width 15 mm"});
  wheel = four_stations();
  wheel.pin_core_radius = 0.0075;
  expect_refused([&] { check(wheel); },
                 {"pin core radius is 7.5 mm", "inside the pin of radius 7.5 mm"});
}

TEST(InternalDimensions, RefusesLengthsThatAreNotPositiveAndFinite) {
  InternalDimensions wheel = four_stations();
  wheel.rim_radius = std::numeric_limits<double>::infinity();
  expect_refused([&] { check(wheel); }, {"rim radius is inf mm", "finite"});
  wheel.rim_radius = -0.1;
  expect_refused([&] { check(wheel); }, {"rim radius is -100 mm", "positive"});
  wheel = four_stations();
  wheel.slot_depth = std::nan("");
  expect_refused([&] { check(wheel); }, {"slot depth is nan mm", "finite"});
}

TEST(InternalDimensions, RefusesSlotThatDoesNotReachThePinsFarthestPosition) {
  InternalDimensions wheel = four_stations();
  wheel.slot_depth = 0.078;
  expect_refused([&] { check(wheel); },
                 {"slot depth is 78 mm", "120.711 mm", "at least 78.2107 mm", "deeper"});
}

TEST(InternalDimensions, RefusesSlotsThatRunIntoEachOther) {
  InternalDimensionsInput input = size_of(4, 0.1);
  input.slot_width = 0.071;  // 100 sin 45 deg = 70.7107
  expect_refused(
      [&] { complete_internal_dimensions(input); },
      {"slot width is 71 mm", "70.7107 mm apart", "inner rim of diameter 100 mm", "narrower"});
}

TEST(InternalDimensions, RefusesSlotThroughTheRim) {
  InternalDimensions wheel = four_stations();
  wheel.rim_radius = 0.1282;  // the slots reach 120.7107 + 7.5
  expect_refused([&] { check(wheel); },
                 {"rim radius is 128.2 mm", "slots reach 128.211 mm", "larger"});
  wheel.rim_radius = 0.1283;
  EXPECT_NO_THROW(check(wheel));
}

TEST(InternalDimensions, RefusesLockingArcThatMissesTheInnerRim) {
  InternalDimensions wheel = four_stations();
  wheel.locking_radius = 0.0207;
  expect_refused([&] { check(wheel); },
                 {"locking radius is 20.7 mm", "misses the inner rim", "20.7107 mm", "larger"});
}

TEST(InternalDimensions, LockingArcMayReachAlmostToTheSlotsWalls) {
  InternalDimensions wheel = four_stations();
  const double limit = 0.05 - 0.0075;
  wheel.locking_radius = limit * (1. + 1e-9);
  expect_refused([&] { check(wheel); },
                 {"locking radius is 42.5 mm", "slot of width 15 mm", "42.5 mm", "smaller"});
  wheel.locking_radius = limit * (1. - 1e-9);
  EXPECT_NO_THROW(check(wheel));
}

}  // namespace
}  // namespace geneva::loads
