#include "loads/wheel/internal_outline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "loads/design/johnson.h"
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

/// Exact formulas on shapes of size 1 to 2: a few dozen roundings.
constexpr double closed_form = 1e-14;

InternalDimensionsInput input_of(int stations) {
  InternalDimensionsInput input{};
  input.stations = stations;
  input.wheel_diameter = 1.;
  return input;
}

InternalDimensions wheel_of(int stations, double clearance = 0.) {
  InternalDimensionsInput input = input_of(stations);
  input.slot_clearance = clearance;
  return complete_internal_dimensions(input);
}

/// Area and polar moment of area about the wheel's axis.
struct Moments {
  double area;
  double polar;
};

Moments operator+(Moments a, Moments b) { return {a.area + b.area, a.polar + b.polar}; }
Moments operator-(Moments a, Moments b) { return {a.area - b.area, a.polar - b.polar}; }
Moments operator*(double factor, Moments a) { return {factor * a.area, factor * a.polar}; }

Moments disk(double radius) { return {pi * std::pow(radius, 2), pi / 2. * std::pow(radius, 4)}; }

/// Segment of a disk beyond a chord, half the angle seen from its centre: sector less triangle.
Moments disk_segment(double radius, double half_angle) {
  const double e = radius * std::cos(half_angle);
  const double h = radius * std::sin(half_angle);
  return {
      half_angle * radius * radius - e * h,
      half_angle * std::pow(radius, 4) / 2. - std::pow(e, 3) * h / 2. - e * std::pow(h, 3) / 6.};
}

/// From the inner rim to the bottom: a rectangle and half a disk, less what lies inside the rim.
Moments slot(const InternalDimensions& wheel) {
  const double a = wheel.wheel_diameter / 2.;
  const double h = wheel.slot_width / 2.;
  const double bottom = a + wheel.slot_depth - h;
  const double half_angle = std::asin(h / a);
  const double end = a * std::cos(half_angle);
  const Moments rectangle{2. * h * (bottom - end),
                          2. * h * (std::pow(bottom, 3) - std::pow(end, 3)) / 3. +
                              2. * std::pow(h, 3) * (bottom - end) / 3.};
  const Moments half_disk{pi * h * h / 2., bottom * bottom * pi * h * h / 2. +
                                               2. * bottom * 2. * std::pow(h, 3) / 3. +
                                               pi * std::pow(h, 4) / 4.};
  return rectangle + half_disk - disk_segment(a, half_angle);
}

/// The locking disk less its lens with the disk inside the inner rim.
Moments pocket(const InternalDimensions& wheel) {
  const double a = wheel.wheel_diameter / 2.;
  const double radius = wheel.locking_radius;
  const double c = wheel.centre_distance;
  const double at_axis = std::acos((c * c + a * a - radius * radius) / (2. * c * a));
  const double at_centre = std::acos((c * c + radius * radius - a * a) / (2. * c * radius));
  const Moments own = disk_segment(radius, at_centre);
  const double towards_axis = 2. / 3. * std::pow(radius * std::sin(at_centre), 3);
  const Moments moved{own.area, own.polar + c * c * own.area - 2. * c * towards_axis};
  const Moments whole{pi * radius * radius,
                      pi / 2. * std::pow(radius, 4) + c * c * pi * radius * radius};
  return whole - moved - disk_segment(a, at_axis);
}

Moments closed_form_of(const InternalDimensions& wheel) {
  return disk(wheel.rim_radius) - disk(wheel.wheel_diameter / 2.) -
         static_cast<double>(wheel.stations) * (slot(wheel) + pocket(wheel));
}

TEST(InternalWheelOutline, HasTheAreaAndPolarMomentOfTheRingLessSlotsAndPockets) {
  for (int n = 3; n <= 24; ++n)
    for (const double clearance : {0., 4e-3}) {
      const InternalDimensions wheel = wheel_of(n, clearance);
      const AreaMoments moments = area_moments(internal_wheel_outline(wheel));
      const Moments expected = closed_form_of(wheel);
      EXPECT_NEAR(moments.area / expected.area, 1., 10. * closed_form) << n;
      EXPECT_NEAR(moments.polar_moment / expected.polar, 1., 10. * closed_form) << n;
    }
}

TEST(InternalWheelOutline, IsARingForEveryNumberOfStations) {
  for (int n = 3; n <= 24; ++n)
    for (const double clearance : {0., 1e-3}) {
      SCOPED_TRACE(n);
      expect_ring(internal_wheel_outline(wheel_of(n, clearance)));
    }
}

TEST(InternalWheelOutline, NamesEverySurface) {
  for (const int n : {3, 4, 11}) {
    std::map<std::string, int> count;
    const Outline wheel = internal_wheel_outline(wheel_of(n));
    EXPECT_EQ(wheel.name, "wheel");
    for (const Loop& loop : wheel.loops)
      for (const Segment& segment : loop) ++count[segment.surface];
    const std::map<std::string, int> expected{{"driving wall", 3},  {"opposite wall", 1},
                                              {"slots", 4 * n - 4}, {"locking arcs", 2 * n},
                                              {"inner rim", 2 * n}, {"rim", 4}};
    EXPECT_EQ(count, expected) << n;
  }
}

TEST(InternalWheelOutline, DrivingWallIsOneSmoothChainWithTheBottomOfItsSlot) {
  for (const double clearance : {0., 1e-3})
    expect_smooth_wall(internal_wheel_outline(wheel_of(5, clearance)).loops[1]);
}

TEST(InternalWheelOutline, EngagedSlotLiesAlongTheXAxisFromTheInnerRimToItsBottom) {
  const InternalDimensions wheel = wheel_of(5, 2e-3);
  const double half = wheel.slot_width / 2.;
  const Outline outline = internal_wheel_outline(wheel);
  for (const Segment& segment : outline.loops[1]) {
    const bool driving = segment.surface == "driving wall";
    if (segment.is_arc || (!driving && segment.surface != "opposite wall")) continue;
    const Point inner = driving ? segment.start : segment.end;
    const Point outer = driving ? segment.end : segment.start;
    EXPECT_NEAR(inner.x, std::sqrt(0.25 - half * half), closed_form);
    EXPECT_NEAR(outer.x, wheel.centre_distance + wheel.crank_radius, closed_form);
    EXPECT_NEAR(inner.y, driving ? half : -half, closed_form);
    EXPECT_EQ(inner.y, outer.y);
  }
}

TEST(InternalWheelOutline, ArcsLieOnTheirCylinders) {
  for (const int n : {3, 7, 24}) {
    const InternalDimensions wheel = wheel_of(n);
    const Outline outline = internal_wheel_outline(wheel);
    const double deepest = 0.5 + wheel.slot_depth;
    for (const Loop& loop : outline.loops)
      for (const Segment& segment : loop) {
        const double from_axis = std::hypot(segment.start.x, segment.start.y);
        EXPECT_LE(from_axis, (segment.surface == "rim" ? wheel.rim_radius : deepest) + closed_form);
        if (segment.surface == "rim") {
          EXPECT_NEAR(from_axis, wheel.rim_radius, closed_form);
        }
        if (segment.surface == "inner rim") {
          EXPECT_NEAR(from_axis, 0.5, closed_form);
        }
        if (segment.surface != "locking arcs") continue;
        EXPECT_NEAR(distance(segment.start, segment.centre), wheel.locking_radius, closed_form);
        EXPECT_NEAR(distance(segment.centre, {0., 0.}), wheel.centre_distance, closed_form);
        EXPECT_TRUE(segment.clockwise);
      }
  }
}

TEST(InternalWheelOutline, LockingArcsLieMidwayBetweenSlots) {
  const int n = 6;
  const Outline outline = internal_wheel_outline(wheel_of(n));
  for (const Segment& segment : outline.loops[1]) {
    if (segment.surface != "locking arcs") continue;
    const double pitches = std::atan2(segment.centre.y, segment.centre.x) / (2. * pi / n);
    EXPECT_NEAR(std::abs(pitches - std::floor(pitches)), 0.5, closed_form);
  }
}

TEST(InternalWheelOutline, IsRefusedWhereTheDimensionsAre) {
  InternalDimensions wheel = wheel_of(4);
  wheel.rim_radius = 1.;
  expect_refused([&] { internal_wheel_outline(wheel); }, {"rim radius is 1000 mm"});
  expect_refused([&] { internal_pin_outline(wheel, 0.6); }, {"rim radius is 1000 mm"});
  expect_refused([&] { internal_wheel_inertia(wheel, 7850.); }, {"rim radius is 1000 mm"});
}

TEST(InternalPinOutline, TouchesTheDrivingWallWithItsFirstVertex) {
  const InternalDimensions wheel = wheel_of(4, 4e-3);
  const Outline pin = internal_pin_outline(wheel, 0.7);
  expect_closed(pin);
  ASSERT_EQ(pin.loops.size(), 2U);
  EXPECT_NEAR(pin.loops[0][0].start.x, 0.7, closed_form);
  EXPECT_NEAR(pin.loops[0][0].start.y, wheel.slot_width / 2., closed_form);
  EXPECT_EQ(pin.loops[0][0].surface, "pin");
  EXPECT_EQ(pin.loops[1][0].surface, "pin core");
  const double radius = wheel.pin_diameter / 2.;
  EXPECT_NEAR(area_moments(pin).area,
              pi * (radius * radius - wheel.pin_core_radius * wheel.pin_core_radius), closed_form);
}

TEST(InternalPinOutline, IsRefusedBeyondTheDrivingWall) {
  const InternalDimensions wheel = wheel_of(4);  // sqrt(500^2 - 75^2) mm to 1207.107 mm
  EXPECT_NO_THROW(internal_pin_outline(wheel, wheel.centre_distance + wheel.crank_radius));
  EXPECT_NO_THROW(internal_pin_outline(wheel, 0.5));
  expect_refused([&] { internal_pin_outline(wheel, 0.494); },
                 {"pin distance is 494 mm", "from 494.343 mm (end of the wall)",
                  "to 1207.11 mm (farthest position)", "choose"});
  expect_refused([&] { internal_pin_outline(wheel, 1.208); }, {"pin distance is 1208 mm"});
  expect_refused([&] { internal_pin_outline(wheel, std::nan("")); }, {"pin distance is nan mm"});
}

TEST(InternalWheelInertia, IsDensityTimesThicknessTimesPolarMoment) {
  const InternalDimensions wheel = wheel_of(6);
  EXPECT_NEAR(internal_wheel_inertia(wheel, 7850.) / (7850. * 0.14 * closed_form_of(wheel).polar),
              1., 10. * closed_form);
  expect_refused([&] { internal_wheel_inertia(wheel, 0.); }, {"density is 0 kg/m^3", "positive"});
}

/// Proportions at random on both sides of what is possible.
InternalDimensionsInput random_proportions() {
  InternalDimensionsInput input = input_of(random_stations());
  const double half_pitch = pi / input.stations;
  const double crank = 0.5 * std::tan(half_pitch);
  const double reach = 0.5 / std::cos(half_pitch) - 0.5;
  input.slot_width = (crank - reach) * between(0.05, 1.05);
  input.pin_diameter = *input.slot_width * between(0.5, 1.);
  input.slot_depth = reach + crank + *input.slot_width * between(0.45, 2.);
  input.locking_radius = reach + (crank - reach) * between(-0.05, 1.);
  input.rim_radius = 0.5 + *input.slot_depth * between(0.95, 1.5);
  return input;
}

RC_GTEST_PROP(InternalWheelProperty, WhateverIsAcceptedIsOneSimpleRing, ()) {
  InternalDimensions wheel{};
  try {
    wheel = complete_internal_dimensions(random_proportions());
  } catch (const std::invalid_argument&) {
    RC_DISCARD("refused");
  }
  const Outline outline = internal_wheel_outline(wheel);
  const std::vector<Point> hole = polygon(outline.loops[1], 6);
  RC_ASSERT(!crosses_itself(hole));
  for (const Point& point : hole) {
    const double from_axis = std::hypot(point.x, point.y);
    RC_ASSERT(from_axis < wheel.rim_radius);
    RC_ASSERT(from_axis >= std::min(0.5, wall_end(wheel)) - closed_form);
  }
  const AreaMoments moments = area_moments(outline);
  RC_ASSERT(distance(moments.centroid, {0., 0.}) < 1e-13);
  RC_ASSERT(std::abs(moments.polar_moment / closed_form_of(wheel).polar - 1.) < 1e-12);
}

}  // namespace
}  // namespace geneva::loads
