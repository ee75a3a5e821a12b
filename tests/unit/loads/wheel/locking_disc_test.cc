#include "loads/wheel/locking_disc.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <optional>

#include "loads/design/johnson.h"
#include "loads/motion/external_geneva.h"
#include "loads/motion/internal_geneva.h"
#include "loads/pi.h"
#include "loads/wheel/internal_outline.h"
#include "loads/wheel/outline_shapes.h"
#include "loads/wheel/solid_part.h"
#include "tests/unit/loads/random_values.h"

namespace geneva::loads {
namespace {

using test::between;

GenevaDimensions external_wheel(const int stations, const std::optional<double> locking_radius) {
  GenevaDimensionsInput input{};
  input.stations = stations;
  input.wheel_diameter = 1.;
  input.locking_radius = locking_radius;
  return complete_dimensions(input);
}

InternalDimensions internal_wheel(const int stations) {
  InternalDimensionsInput input{};
  input.stations = stations;
  input.wheel_diameter = 1.;
  return complete_internal_dimensions(input);
}

/// A disc with its driver's pin on +x, and its wheel at a driver angle.
struct Pair {
  Outline disc;
  Outline wheel;
  CommonDimensions sizes;
  SlotSide side;
  Mechanism mechanism;
};

Pair external_pair(const int stations, const std::optional<double> locking_radius = std::nullopt) {
  const GenevaDimensions sizes = external_wheel(stations, locking_radius);
  return {locking_disc(sizes, SlotSide::outside, {0.}).value().outline, wheel_outline(sizes), sizes,
          SlotSide::outside, external_geneva(stations, sizes.centre_distance)};
}

Pair internal_pair(const int stations) {
  const InternalDimensions sizes = internal_wheel(stations);
  return {locking_disc(sizes, SlotSide::inside, {0.}).value().outline,
          internal_wheel_outline(sizes), sizes, SlotSide::inside,
          internal_geneva(stations, sizes.centre_distance)};
}

double radius_of(const Segment& arc) {
  return std::hypot(arc.start.x - arc.centre.x, arc.start.y - arc.centre.y);
}

/// How deep a point lies in the disc, which is its circle less the cut-out, negative outside.
double depth_in_disc(const Pair& pair, const Point& point) {
  double depth = pair.sizes.locking_radius - std::hypot(point.x, point.y);
  for (const Segment& segment : pair.disc.loops.front()) {
    if (segment.surface != "cut-out") continue;
    const double outside =
        std::hypot(point.x - segment.centre.x, point.y - segment.centre.y) - radius_of(segment);
    depth = std::min(depth, segment.clockwise ? outside : -outside);
  }
  return depth;
}

/// Points of the wheel's boundary, seen from the driver.
std::vector<Point> wheel_points(const Pair& pair, const double driver_angle) {
  const double axis_x = pair.sizes.centre_distance;
  const double driver = pair.side == SlotSide::outside ? pi - driver_angle : driver_angle;
  const double turn = pair.mechanism.motion(driver_angle).wheel_angle.value;
  std::vector<Point> points;
  const Outline wheel = placed(pair.wheel, {turn, {0., 0.}});
  for (const Loop& loop : wheel.loops)
    for (const Segment& segment : loop)
      points.push_back(rotated({segment.start.x - axis_x, segment.start.y}, -driver));
  return points;
}

/// @param steps by default at other instants than those that the cut-out was made with
double deepest_of_wheel(const Pair& pair, const int steps = 997) {
  double deepest = -1.;
  for (int i = 0; i <= steps; ++i) {
    const double angle =
        pair.mechanism.entry + (pair.mechanism.exit - pair.mechanism.entry) * i / steps;
    for (const Point& point : wheel_points(pair, angle))
      deepest = std::max(deepest, depth_in_disc(pair, point));
  }
  return deepest;
}

/// Half the angle that the cut-out takes out of the rim.
double half_cut(const Outline& disc) {
  const Point corner = disc.loops.front().front().end;
  return std::atan2(corner.y, corner.x);
}

TEST(LockingDisc, LocksUntilThePinIsInItsSlot) {
  for (const int stations : {3, 4, 5, 6, 8, 12, 24})
    EXPECT_NEAR(half_cut(external_pair(stations).disc), pi / 2. - pi / stations, 1e-12);
  for (const int stations : {3, 4, 5, 6})
    EXPECT_NEAR(half_cut(internal_pair(stations).disc), pi / 2. + pi / stations, 1e-12);
}

TEST(LockingDisc, IsCutWiderWhereTheTipsNeedIt) {
  const InternalDimensions sizes = internal_wheel(12);
  const LockingDisc disc = locking_disc(sizes, SlotSide::inside, {0.}).value();
  EXPECT_GT(disc.half_cut, half_engagement(sizes, SlotSide::inside) + degree);
  EXPECT_NEAR(half_cut(disc.outline), disc.half_cut, 1e-12);
}

TEST(LockingDisc, OfFewStationsIsCutAlongTheCircleAboutTheWheelsAxis) {
  for (const int stations : {4, 5, 6}) {
    const Pair pair = external_pair(stations);
    const Segment& cut = pair.disc.loops.front().front();
    EXPECT_NEAR(cut.centre.x, pair.sizes.centre_distance, 1e-12);
    EXPECT_NEAR(cut.centre.y, 0., 1e-12);
    EXPECT_GT(radius_of(cut), pair.sizes.wheel_diameter / 2.);
  }
}

TEST(LockingDisc, LetsTheWheelPass) {
  constexpr double rounding = 1e-6;  // of the wheel's diameter; between the instants looked at
  for (const int stations : {3, 4, 5, 6, 7, 8, 10, 12, 16, 24}) {
    EXPECT_LT(deepest_of_wheel(external_pair(stations)), rounding) << stations;
    EXPECT_LT(deepest_of_wheel(internal_pair(stations)), rounding) << stations;
  }
}

RC_GTEST_PROP(LockingDisc, OfAnyRadiusLetsTheWheelPass, ()) {
  const int stations = test::uniform(4, 13);
  const double crank = 0.5 * std::tan(pi / stations);
  const Pair pair = external_pair(stations, between(0.45, 0.6) * crank);
  RC_ASSERT(deepest_of_wheel(pair) < 1e-6);
}

TEST(LockingDisc, LeavesNoCornerWhereATipCrossesItsCircleFurtherOut) {
  const double crank = 0.5 * std::tan(pi / 12);
  const Pair pair = external_pair(12, 0.4565 * crank);
  EXPECT_GT(half_cut(pair.disc), half_engagement(pair.sizes, pair.side) + 1e-3 * degree);
  constexpr int steps = 20000;
  EXPECT_LT(deepest_of_wheel(pair, steps), 1e-7);
}

TEST(LockingDisc, HasACutOutForEachPin) {
  const GenevaDimensions sizes = external_wheel(6, std::nullopt);
  const Outline one = locking_disc(sizes, SlotSide::outside, {0.}).value().outline;
  const Outline two = locking_disc(sizes, SlotSide::outside, {0., pi}).value().outline;
  const double whole = pi * sizes.locking_radius * sizes.locking_radius;
  const double cut = whole - area_moments(one).area;
  EXPECT_NEAR(whole - area_moments(two).area, 2. * cut, 1e-12 * whole);
  EXPECT_FALSE(locking_disc(sizes, SlotSide::outside, {0., 2. * pi / 3., 4. * pi / 3.}));
}

}  // namespace
}  // namespace geneva::loads
