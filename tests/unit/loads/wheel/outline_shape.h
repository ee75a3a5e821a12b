#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "loads/wheel/outline.h"

namespace geneva::loads::test {

inline double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

inline double cross(Point origin, Point p, Point q) {
  return (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
}

/// Points of an arc or line, without its end.
inline void append_points(std::vector<Point>& points, const Segment& segment, int pieces) {
  if (!segment.is_arc) {
    points.push_back(segment.start);
    return;
  }
  const Point p{segment.start.x - segment.centre.x, segment.start.y - segment.centre.y};
  const Point q{segment.end.x - segment.centre.x, segment.end.y - segment.centre.y};
  const double turn = std::atan2(p.x * q.y - p.y * q.x, p.x * q.x + p.y * q.y);
  for (int i = 0; i < pieces; ++i) {
    const double t = turn * i / pieces;
    points.push_back({segment.centre.x + std::cos(t) * p.x - std::sin(t) * p.y,
                      segment.centre.y + std::sin(t) * p.x + std::cos(t) * p.y});
  }
}

inline std::vector<Point> polygon(const Loop& loop, int pieces) {
  std::vector<Point> points;
  for (const Segment& segment : loop) append_points(points, segment, pieces);
  return points;
}

/// Every segment starts where the one before ended, to the last bit; arcs lie on their circles and
/// take less than half a turn in the sense they name.
inline void expect_closed(const Outline& outline) {
  for (const Loop& loop : outline.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Segment& segment = loop[i];
      const Segment& next = loop[(i + 1) % loop.size()];
      EXPECT_EQ(segment.end.x, next.start.x) << segment.surface << ' ' << i;
      EXPECT_EQ(segment.end.y, next.start.y) << segment.surface << ' ' << i;
      EXPECT_GT(distance(segment.start, segment.end), 1e-6) << segment.surface << ' ' << i;
      if (!segment.is_arc) continue;
      EXPECT_NEAR(distance(segment.start, segment.centre), distance(segment.end, segment.centre),
                  1e-15);
      EXPECT_EQ(cross(segment.centre, segment.start, segment.end) < 0., segment.clockwise);
    }
}

/// Products below rounding count as touching: walls of opposite slots lie on one line.
inline bool chords_cross(Point a, Point b, Point c, Point d) {
  const double rounding = -1e-28;
  return cross(a, b, c) * cross(a, b, d) < rounding && cross(c, d, a) * cross(c, d, b) < rounding;
}

inline bool crosses_itself(const std::vector<Point>& points) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 2; j < count; ++j) {
      const std::size_t after = (j + 1) % count;  // the first when j is the last: a neighbour of it
      if (after != i && chords_cross(points[i], points[i + 1], points[j], points[after]))
        return true;
    }
  return false;
}

/// Two closed loops that do not cross themselves, the outer one counter-clockwise and the inner one
/// clockwise.
inline void expect_ring(const Outline& outline) {
  expect_closed(outline);
  ASSERT_EQ(outline.loops.size(), 2U);
  for (const Loop& loop : outline.loops) EXPECT_FALSE(crosses_itself(polygon(loop, 6)));
  EXPECT_GT(area_moments({"outer", {outline.loops[0]}}).area, 0.);
  EXPECT_THROW(area_moments({"inner", {outline.loops[1]}}), std::invalid_argument);
}

/// Direction of a segment at its start or its end, of length 1.
inline Point direction(const Segment& segment, const bool at_start) {
  const Point at = at_start ? segment.start : segment.end;
  const double turn = segment.clockwise ? -1. : 1.;
  const Point along =
      segment.is_arc ? Point{turn * (segment.centre.y - at.y), turn * (at.x - segment.centre.x)}
                     : Point{segment.end.x - segment.start.x, segment.end.y - segment.start.y};
  const double length = std::hypot(along.x, along.y);
  return {along.x / length, along.y / length};
}

/// The driving wall is one chain, straight part and round bottom, and turns nowhere at once.
inline void expect_smooth_wall(const Loop& loop) {
  std::vector<Segment> wall;
  for (const Segment& segment : loop)
    if (segment.surface == "driving wall") wall.push_back(segment);
  ASSERT_EQ(wall.size(), 3U);
  for (std::size_t i = 1; i < wall.size(); ++i) {
    EXPECT_EQ(distance(wall[i - 1].end, wall[i].start), 0.);
    EXPECT_LT(distance(direction(wall[i - 1], false), direction(wall[i], true)), 1e-12);
  }
}

}  // namespace geneva::loads::test
