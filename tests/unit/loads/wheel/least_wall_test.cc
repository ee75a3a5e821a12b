#include "loads/wheel/least_wall.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "base/errors.h"
#include "loads/design/johnson.h"
#include "loads/wheel/internal_outline.h"
#include "loads/wheel/outline.h"
#include "tests/unit/loads/random_values.h"
#include "tests/unit/loads/wheel/outline_shape.h"

namespace geneva::loads {
namespace {

using test::between;
using test::distance;
using test::random_stations;

using Points = std::vector<Point>;

Points points_of(const Segment& segment) {
  constexpr int pieces = 150;
  Points points;
  if (segment.is_arc) {
    test::append_points(points, segment, pieces);
  } else {
    for (int i = 0; i < pieces; ++i) {
      const double t = static_cast<double>(i) / pieces;
      points.push_back({segment.start.x + t * (segment.end.x - segment.start.x),
                        segment.start.y + t * (segment.end.y - segment.start.y)});
    }
  }
  points.push_back(segment.end);
  return points;
}

/// Slots, locking arcs, bore or rim in their order; the cylinder on which the slots open divides
/// them.
std::vector<Points> features(const Outline& wheel, const std::string& divides) {
  std::vector<Points> found;
  for (const Loop& loop : wheel.loops) {
    bool is_new = true;
    for (const Segment& segment : loop) {
      if (segment.surface == divides) {
        is_new = true;
        continue;
      }
      if (is_new) found.emplace_back();
      is_new = false;
      const Points points = points_of(segment);
      found.back().insert(found.back().end(), points.begin(), points.end());
    }
  }
  return found;
}

double distance_between(const Points& first, const Points& second) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point& p : first)
    for (const Point& q : second) least = std::min(least, distance(p, q));
  return least;
}

/// Of a slot and what follows it around the wheel, and of these and the closed circle.
double sampled_wall(const std::vector<Points>& around, const Points& circle) {
  double least = std::min(distance_between(around[0], circle), distance_between(around[1], circle));
  for (std::size_t other = 1; other <= 2; ++other)
    least = std::min(least, distance_between(around[0], around[other]));
  return least;
}

/// Points of 150 to a segment are at most 3e-3 of the diameter apart, so that two of them are
/// nearer than 2e-3 of it beside the shortest way.
void expect_sampled(const double wall, const double sampled, const double diameter) {
  RC_LOG() << "wall " << wall << ", sampled " << sampled << '\n';
  RC_ASSERT(sampled >= wall * (1. - 1e-9));
  RC_ASSERT(sampled <= wall + 2e-3 * diameter);
}

/// A wheel of 0.1 m with some proportions that are not Johnson's; discarded if there is none.
template <typename Input, typename Complete, typename Change>
auto random_wheel(const Complete& complete, const Change& change) {
  Input input{};
  input.stations = random_stations();
  input.wheel_diameter = 0.1;
  const auto usual = complete(input);
  input.pin_diameter = usual.pin_diameter * between(0.4, 1.3);
  input.locking_radius = usual.locking_radius * between(0.8, 1.1);
  change(input, usual);
  try {
    return complete(input);
  } catch (const base::InputError&) {
    RC_DISCARD("no such wheel");
  }
}

RC_GTEST_PROP(LeastWall, IsTheLeastDistanceBetweenPartsOfTheOutline, ()) {
  const GenevaDimensions wheel = random_wheel<GenevaDimensionsInput>(
      complete_dimensions, [](GenevaDimensionsInput& input, const GenevaDimensions& usual) {
        input.bore_radius = usual.bore_radius * between(0.5, 1.5);
      });
  std::vector<Points> found = features(wheel_outline(wheel), "rim");
  const Points bore = found.back();
  found.pop_back();
  expect_sampled(least_wall(wheel).thickness, sampled_wall(found, bore), wheel.wheel_diameter);
}

RC_GTEST_PROP(LeastWall, IsTheSameOfAnInternalWheel, ()) {
  const InternalDimensions wheel = random_wheel<InternalDimensionsInput>(
      complete_internal_dimensions,
      [](InternalDimensionsInput& input, const InternalDimensions& usual) {
        input.rim_radius = usual.rim_radius * between(0.9, 1.2);
      });
  std::vector<Points> found = features(internal_wheel_outline(wheel), "inner rim");
  const Points rim = found.front();
  found.erase(found.begin());
  expect_sampled(least_wall(wheel).thickness, sampled_wall(found, rim), wheel.wheel_diameter);
}

TEST(LeastWall, NamesWhatItSeparates) {
  GenevaDimensionsInput input{};
  input.stations = 4;
  input.wheel_diameter = 0.1;
  input.bore_radius = 0.013;
  EXPECT_STREQ(least_wall(complete_dimensions(input)).between, "slot and bore");
  input.bore_radius = std::nullopt;
  input.locking_radius = 0.042;
  EXPECT_STREQ(least_wall(complete_dimensions(input)).between, "slot and locking arc, at the rim");
}

TEST(LeastWall, IsMoreThanATenthOfTheSlotWithJohnsonSProportions) {
  for (int n = 3; n <= 24; ++n) {
    GenevaDimensionsInput input{};
    input.stations = n;
    input.wheel_diameter = 0.1;
    const GenevaDimensions wheel = complete_dimensions(input);
    EXPECT_GT(least_wall(wheel).thickness, 0.1 * wheel.slot_width) << n;
  }
}

}  // namespace
}  // namespace geneva::loads
