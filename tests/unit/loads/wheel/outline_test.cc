#include "loads/wheel/outline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "loads/design/johnson.h"
#include "loads/motion/external_geneva.h"
#include "loads/pi.h"
#include "tests/support/refusal.h"
#include "tests/unit/loads/random_values.h"
#include "tests/unit/loads/wheel/outline_shape.h"

namespace geneva::loads {
namespace {

using test::between;
using test::crosses_itself;
using test::distance;
using test::expect_closed;
using test::expect_refused;
using test::expect_ring;
using test::expect_smooth_wall;
using test::polygon;
using test::random_stations;

/// Exact formulas on shapes of size 1: a few dozen roundings.
constexpr double closed_form = 1e-14;

Segment line(Point start, Point end) { return {start, end, false, {0., 0.}, false, "side"}; }

Segment arc(Point start, Point end, Point centre, bool clockwise) {
  return {start, end, true, centre, clockwise, "arc"};
}

Loop circle(Point centre, double radius, bool clockwise, int arcs) {
  Loop loop;
  const double step = (clockwise ? -2. : 2.) * pi / arcs;
  const auto vertex = [&](int i) {
    return Point{centre.x + radius * std::cos(i * step), centre.y + radius * std::sin(i * step)};
  };
  for (int i = 0; i < arcs; ++i)
    loop.push_back(arc(vertex(i), vertex((i + 1) % arcs), centre, clockwise));
  return loop;
}

Loop square(double side) {
  const double h = side / 2.;
  return {line({-h, -h}, {h, -h}), line({h, -h}, {h, h}), line({h, h}, {-h, h}),
          line({-h, h}, {-h, -h})};
}

GenevaDimensions wheel_of(int stations, double clearance = 0.) {
  GenevaDimensionsInput input{};
  input.stations = stations;
  input.wheel_diameter = 1.;
  input.slot_clearance = clearance;
  return complete_dimensions(input);
}

TEST(AreaMoments, Disk) {
  for (const int arcs : {3, 4, 7}) {
    const AreaMoments moments = area_moments({"disk", {circle({0., 0.}, 0.5, false, arcs)}});
    EXPECT_NEAR(moments.area, pi / 4., closed_form);
    EXPECT_NEAR(moments.polar_moment, pi / 32., closed_form);
    EXPECT_NEAR(moments.centroid.x, 0., closed_form);
    EXPECT_NEAR(moments.centroid.y, 0., closed_form);
  }
}

TEST(AreaMoments, DiskAwayFromTheOrigin) {
  const AreaMoments moments = area_moments({"disk", {circle({2., -1.}, 0.5, false, 4)}});
  EXPECT_NEAR(moments.area, pi / 4., 10. * closed_form);
  EXPECT_NEAR(moments.centroid.x, 2., 10. * closed_form);
  EXPECT_NEAR(moments.centroid.y, -1., 10. * closed_form);
  EXPECT_NEAR(moments.polar_moment, pi / 32. + pi / 4. * 5., 10. * closed_form);
}

TEST(AreaMoments, Annulus) {
  const AreaMoments moments =
      area_moments({"annulus", {circle({0., 0.}, 1., false, 4), circle({0., 0.}, 0.5, true, 4)}});
  EXPECT_NEAR(moments.area, pi * 0.75, closed_form);
  EXPECT_NEAR(moments.polar_moment, pi / 2. * (1. - 1. / 16.), closed_form);
}

TEST(AreaMoments, Square) {
  const AreaMoments moments = area_moments({"square", {square(2.)}});
  EXPECT_NEAR(moments.area, 4., closed_form);
  EXPECT_NEAR(moments.polar_moment, 16. / 6., closed_form);
  EXPECT_NEAR(moments.centroid.x, 0., closed_form);
}

TEST(AreaMoments, HalfDiskClosedByALine) {
  const Loop loop{line({-1., 0.}, {1., 0.}), arc({1., 0.}, {0., 1.}, {0., 0.}, false),
                  arc({0., 1.}, {-1., 0.}, {0., 0.}, false)};
  const AreaMoments moments = area_moments({"half disk", {loop}});
  EXPECT_NEAR(moments.area, pi / 2., closed_form);
  EXPECT_NEAR(moments.centroid.x, 0., closed_form);
  EXPECT_NEAR(moments.centroid.y, 4. / (3. * pi), closed_form);
  EXPECT_NEAR(moments.polar_moment, pi / 4., closed_form);
}

TEST(AreaMoments, SquareWithAConcaveQuarterDisk) {
  // the unit square [0, 1]^2 less the quarter disk of radius 1/2 about its corner (1, 1)
  const double h = 0.5;
  const Loop loop{line({0., 0.}, {1., 0.}), line({1., 0.}, {1., h}),
                  arc({1., h}, {h, 1.}, {1., 1.}, true), line({h, 1.}, {0., 1.}),
                  line({0., 1.}, {0., 0.})};
  const AreaMoments moments = area_moments({"notched square", {loop}});
  const double quarter = pi / 16.;
  const double offset = 1. - 4. * h / (3. * pi);  // centroid of the quarter disk
  EXPECT_NEAR(moments.area, 1. - quarter, closed_form);
  EXPECT_NEAR(moments.centroid.x, (0.5 - quarter * offset) / (1. - quarter), closed_form);
  EXPECT_NEAR(moments.centroid.y, moments.centroid.x, closed_form);
  // quarter disk about its corner pi h^4/8, moved to the origin by the parallel-axis theorem
  const double own = pi * h * h * h * h / 8.;
  const double to_corner = 2. * std::pow(1. - offset, 2);
  EXPECT_NEAR(moments.polar_moment, 2. / 3. - (own + quarter * (2. * offset * offset - to_corner)),
              closed_form);
}

TEST(AreaMoments, RefusesAnOutlineThatRunsClockwise) {
  expect_refused(
      [] {
        area_moments({"disk", {circle({0., 0.}, 0.1, true, 4)}});
      },
      {"area of outline 'disk'", "-31415.9 mm^2", "positive", "counter-clockwise"});
}

/// The outline turned by an angle about the origin, then moved.
Outline moved(Outline outline, double angle, Point shift) {
  const auto move = [&](Point& p) {
    p = {shift.x + std::cos(angle) * p.x - std::sin(angle) * p.y,
         shift.y + std::sin(angle) * p.x + std::cos(angle) * p.y};
  };
  for (Loop& loop : outline.loops)
    for (Segment& segment : loop) {
      move(segment.start);
      move(segment.end);
      move(segment.centre);
    }
  return outline;
}

RC_GTEST_PROP(AreaMomentsProperty, FollowTurnsAndShiftsByTheParallelAxisTheorem, ()) {
  // hundreds of segments with moments of about 25 of the shift: 1e-12
  const Outline wheel = wheel_outline(wheel_of(random_stations()));
  const double angle = between(-pi, pi);
  const Point shift{between(-5., 5.), between(-5., 5.)};
  const AreaMoments before = area_moments(wheel);
  const AreaMoments after = area_moments(moved(wheel, angle, shift));
  RC_ASSERT(std::abs(after.area - before.area) < 1e-12);
  RC_ASSERT(distance(after.centroid, shift) < 1e-12);
  const double steiner = before.area * (shift.x * shift.x + shift.y * shift.y);
  RC_ASSERT(std::abs(after.polar_moment - before.polar_moment - steiner) < 1e-11);
}

TEST(AreaMoments, OfTheWheelAgreeWithAFinePolygon) {
  // The circles of radius up to 0.7 are cut in 200 pieces of below 3 mrad: a chord leaves an area
  // of rho^2 h^3/12 each, in all below 1e-6 of the disk.
  for (int n = 3; n <= 24; ++n) {
    const Outline wheel = wheel_outline(wheel_of(n));
    Outline faceted{"polygon", {}};
    for (const Loop& loop : wheel.loops) {
      const std::vector<Point> points = polygon(loop, 200);
      Loop sides;
      for (std::size_t i = 0; i < points.size(); ++i)
        sides.push_back(line(points[i], points[(i + 1) % points.size()]));
      faceted.loops.push_back(sides);
    }
    const AreaMoments exact = area_moments(wheel);
    const AreaMoments approximate = area_moments(faceted);
    EXPECT_NEAR(approximate.area, exact.area, 1e-5) << n;
    EXPECT_NEAR(approximate.polar_moment, exact.polar_moment, 1e-5) << n;
  }
}

TEST(WheelOutline, IsARingForEveryNumberOfStations) {
  for (int n = 3; n <= 24; ++n)
    for (const double clearance : {0., 1e-3}) {
      SCOPED_TRACE(n);
      expect_ring(wheel_outline(wheel_of(n, clearance)));
    }
}

TEST(WheelOutline, NamesEverySurface) {
  for (const int n : {3, 4, 11}) {
    std::map<std::string, int> count;
    const Outline wheel = wheel_outline(wheel_of(n));
    for (const Loop& loop : wheel.loops)
      for (const Segment& segment : loop) ++count[segment.surface];
    const std::map<std::string, int> expected{{"driving wall", 3},  {"opposite wall", 1},
                                              {"slots", 4 * n - 4}, {"locking arcs", n},
                                              {"rim", 2 * n},       {"bore", 4}};
    EXPECT_EQ(count, expected) << n;
  }
}

TEST(WheelOutline, EngagedSlotLiesAlongTheXAxisFromBottomToRim) {
  const GenevaDimensions wheel = wheel_of(5, 2e-3);
  const double half = wheel.slot_width / 2.;
  const double end = std::sqrt(0.25 - half * half);
  const Loop boundary = wheel_outline(wheel).loops[0];
  for (const Segment& segment : boundary) {
    const bool driving = segment.surface == "driving wall";
    if (segment.is_arc || (!driving && segment.surface != "opposite wall")) continue;
    const Point inner = driving ? segment.start : segment.end;
    const Point outer = driving ? segment.end : segment.start;
    EXPECT_NEAR(inner.x, wheel.centre_distance - wheel.crank_radius, closed_form);
    EXPECT_NEAR(outer.x, end, closed_form);
    EXPECT_NEAR(inner.y, driving ? half : -half, closed_form);
    EXPECT_EQ(inner.y, outer.y);
  }
}

TEST(WheelOutline, DrivingWallIsOneSmoothChainWithTheBottomOfItsSlot) {
  for (const double clearance : {0., 1e-3})
    expect_smooth_wall(wheel_outline(wheel_of(5, clearance)).loops[0]);
}

TEST(WheelOutline, BoreHasItsRadiusAndStartsOnTop) {
  const GenevaDimensions wheel = wheel_of(6);
  const Loop bore = wheel_outline(wheel).loops[1];
  ASSERT_EQ(bore.size(), 4U);
  EXPECT_EQ(bore[0].start.x, 0.);
  EXPECT_EQ(bore[0].start.y, wheel.bore_radius);
  for (const Segment& segment : bore) {
    EXPECT_TRUE(segment.clockwise);
    EXPECT_NEAR(distance(segment.start, {0., 0.}), wheel.bore_radius, closed_form);
  }
}

TEST(WheelOutline, LockingArcsHaveTheirRadiusAndMeetTheRim) {
  const GenevaDimensions wheel = wheel_of(7);
  const Loop boundary = wheel_outline(wheel).loops[0];
  for (const Segment& segment : boundary) {
    if (segment.surface != "locking arcs") continue;
    EXPECT_TRUE(segment.clockwise);
    EXPECT_NEAR(distance(segment.start, segment.centre), wheel.locking_radius, closed_form);
    EXPECT_NEAR(distance(segment.centre, {0., 0.}), wheel.centre_distance, closed_form);
    EXPECT_NEAR(distance(segment.start, {0., 0.}), 0.5, closed_form);
    EXPECT_NEAR(distance(segment.end, {0., 0.}), 0.5, closed_form);
  }
}

TEST(WheelOutline, IsRefusedWhereTheDimensionsAre) {
  GenevaDimensions wheel = wheel_of(4);
  wheel.bore_radius = 0.4;
  expect_refused([&] { wheel_outline(wheel); }, {"bore radius is 400 mm"});
  expect_refused([&] { wheel_inertia(wheel, 7850.); }, {"bore radius is 400 mm"});
}

TEST(PinOutline, StartsAtThePointOfContactAndRunsByQuarters) {
  const GenevaDimensions wheel = wheel_of(4, 4e-3);
  const double x = 0.3;
  const Outline pin = pin_outline(wheel, x);
  ASSERT_EQ(pin.loops.size(), 2U);
  const Loop& outer = pin.loops[0];
  ASSERT_EQ(outer.size(), 4U);
  const double radius = wheel.pin_diameter / 2.;
  const double y = 2e-3;  // (slot width - pin diameter)/2
  const Point expected[] = {{x, y + radius}, {x - radius, y}, {x, y - radius}, {x + radius, y}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(outer[i].start.x, expected[i].x, closed_form);
    EXPECT_NEAR(outer[i].start.y, expected[i].y, closed_form);
    EXPECT_EQ(outer[i].surface, "pin");
    EXPECT_FALSE(outer[i].clockwise);
  }
  EXPECT_NEAR(outer[0].start.y, wheel.slot_width / 2., closed_form);  // on the driving wall
}

TEST(PinOutline, CoreRunsClockwiseFromTheSameAngles) {
  const GenevaDimensions wheel = wheel_of(4);
  const Loop core = pin_outline(wheel, 0.3).loops[1];
  ASSERT_EQ(core.size(), 4U);
  const double radius = wheel.pin_core_radius;
  const Point expected[] = {{0.3, radius}, {0.3 + radius, 0.}, {0.3, -radius}, {0.3 - radius, 0.}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(core[i].start.x, expected[i].x, closed_form);
    EXPECT_NEAR(core[i].start.y, expected[i].y, closed_form);
    EXPECT_EQ(core[i].surface, "pin core");
    EXPECT_TRUE(core[i].clockwise);
  }
}

TEST(PinOutline, IsAClosedRing) {
  for (int n = 3; n <= 24; ++n) {
    SCOPED_TRACE(n);
    const GenevaDimensions wheel = wheel_of(n);
    const Outline pin = pin_outline(wheel, wheel.centre_distance - wheel.crank_radius);
    expect_closed(pin);
    const double radius = wheel.pin_diameter / 2.;
    const double core = wheel.pin_core_radius;
    EXPECT_NEAR(area_moments(pin).area, pi * (radius * radius - core * core), closed_form);
  }
}

TEST(PinOutline, IsRefusedBeyondTheDrivingWall) {
  const GenevaDimensions wheel = wheel_of(4);  // 207.107 mm to sqrt(500^2 - 75^2) mm
  expect_refused([&] { pin_outline(wheel, 0.2); },
                 {"pin distance is 200 mm", "from 207.107 mm", "to 494.343 mm", "choose"});
  expect_refused([&] { pin_outline(wheel, 0.5); }, {"pin distance is 500 mm"});
  expect_refused([&] { pin_outline(wheel, std::nan("")); }, {"pin distance is nan mm"});
}

TEST(WheelInertia, IsDensityTimesThicknessTimesPolarMoment) {
  const GenevaDimensions wheel = wheel_of(6);
  const double polar = area_moments(wheel_outline(wheel)).polar_moment;
  EXPECT_NEAR(wheel_inertia(wheel, 7850.) / (7850. * 0.14 * polar), 1., closed_form);
}

TEST(WheelInertia, RefusesDensityThatIsNotPositive) {
  expect_refused([] { wheel_inertia(wheel_of(6), -1.); }, {"density is -1 kg/m^3", "positive"});
}

/// A wheel about the default one; its locking arcs reach from just the rim to the default.
GenevaDimensions random_wheel() {
  const JohnsonRow row = johnson_row(random_stations());
  const double reach = 0.5 / std::cos(pi / row.stations) - 0.5;  // c - D/2 for D = 1
  GenevaDimensionsInput input{};
  input.stations = row.stations;
  input.wheel_diameter = 1.;
  input.pin_diameter = row.k2 * between(0.1, 0.95);
  input.slot_clearance = row.k2 * between(0., 0.05);
  input.thickness = between(0.01, 1.);
  input.locking_radius = reach + (row.k4 - reach) * between(0.05, 1.);
  return complete_dimensions(input);
}

RC_GTEST_PROP(WheelProperty, InertiaIsPositiveAndBelowTheFullDisks, ()) {
  const GenevaDimensions wheel = random_wheel();
  const AreaMoments moments = area_moments(wheel_outline(wheel));
  RC_ASSERT(moments.area > 0.);
  RC_ASSERT(moments.area < pi / 4.);
  RC_ASSERT(wheel_inertia(wheel, 7850.) > 0.);
  RC_ASSERT(wheel_inertia(wheel, 7850.) < solid_cylinder_inertia(1., wheel.thickness, 7850.));
}

RC_GTEST_PROP(WheelProperty, IsBalancedAboutItsAxis, ()) {
  const AreaMoments moments = area_moments(wheel_outline(random_wheel()));
  RC_ASSERT(distance(moments.centroid, {0., 0.}) < 1e-13);
}

/// Proportions at random on both sides of what is possible.
GenevaDimensionsInput random_proportions() {
  GenevaDimensionsInput input{};
  input.stations = random_stations();
  input.wheel_diameter = 1.;
  const double half_pitch = pi / input.stations;
  const double crank = 0.5 * std::tan(half_pitch);
  const double nearest = 0.5 / std::cos(half_pitch) - crank;
  const double width = 2. * nearest * std::sin(half_pitch) * between(0.05, 0.8);
  const double depth = 0.5 - nearest * between(0.7, 1.02) + width / 2.;
  input.pin_diameter = width;
  input.slot_depth = depth;
  const double reach = 0.5 / std::cos(half_pitch) - 0.5;
  input.locking_radius = reach + (crank - reach) * between(-0.05, 1.);
  input.bore_radius = std::max(1e-3, 0.5 - depth) * between(0.1, 1.1);
  return input;
}

RC_GTEST_PROP(WheelProperty, WhateverIsAcceptedIsOneSimpleOutlineClearOfItsBore, ()) {
  const GenevaDimensionsInput input = random_proportions();
  GenevaDimensions wheel{};
  try {
    wheel = complete_dimensions(input);
  } catch (const std::invalid_argument&) {
    RC_DISCARD("refused");
  }
  const std::vector<Point> boundary = polygon(wheel_outline(wheel).loops[0], 6);
  RC_ASSERT(!crosses_itself(boundary));
  for (const Point& point : boundary) RC_ASSERT(std::hypot(point.x, point.y) > wheel.bore_radius);
}

RC_GTEST_PROP(WheelProperty, PinClearsTheSlotWhereverItTouchesTheWall, ()) {
  const GenevaDimensions wheel = random_wheel();
  const ExternalGeneva geneva(wheel.stations);
  const double angle = between(-0.9, 0.9) * geneva.engagement_angle();
  const double x = wheel.centre_distance * geneva.pin_distance_ratio(angle);
  RC_PRE(x < std::sqrt(0.25 - wheel.slot_width * wheel.slot_width / 4.));
  const Outline pin = pin_outline(wheel, x);
  const double low = slot_bottom_centre(wheel);
  for (const Point& point : polygon(pin.loops[0], 16)) {
    RC_ASSERT(std::abs(point.y) <= wheel.slot_width / 2. + closed_form);
    if (point.x < low) RC_ASSERT(distance(point, {low, 0.}) <= wheel.slot_width / 2. + closed_form);
  }
}

}  // namespace
}  // namespace geneva::loads
