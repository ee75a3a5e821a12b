#include "loads/wheel/locking_disc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "loads/pi.h"
#include "loads/wheel/outline_shapes.h"

namespace geneva::loads {

namespace {

/// A cut-out of the pin on +x: of a disc of radius R it takes the points p with
/// curvature (R^2 - |p|^2) >= R cos(half_width) - x. Its boundary is the circle about
/// x = 1/(2 curvature) through both corners on the rim, a straight line for 0.
struct CutOut {
  double half_width;  ///< of it on the rim [rad]
  double curvature;   ///< [1/m]
};

/// +1 if the wheel's axis lies beyond the pin on +x midway through the engagement.
double sense(const SlotSide side) { return side == SlotSide::outside ? 1. : -1.; }

/// Tips of the wheel, where its locking arcs meet the cylinder of diameter D, in the driver's
/// frame.
/// @param driver_angle from midway through the engagement [rad]
std::vector<Point> tips(const CommonDimensions& dimensions, const SlotSide side,
                        const double driver_angle) {
  const Point axis = rotated({sense(side) * dimensions.centre_distance, 0.}, -driver_angle);
  const double slot = std::atan2(-axis.y, dimensions.crank_radius - axis.x);
  const double half_locking = locking_half_angle(dimensions);
  std::vector<Point> result;
  for (int arc = 0; arc < dimensions.stations; ++arc)
    for (const double end : {-half_locking, half_locking}) {
      const double angle = slot + (2 * arc + 1) * pi / dimensions.stations + end;
      const Point tip = rotated({dimensions.wheel_diameter / 2., 0.}, angle);
      result.push_back({axis.x + tip.x, axis.y + tip.y});
    }
  return result;
}

double size(const Point& point) { return std::hypot(point.x, point.y); }

/// Driver angles over the engagement; the ways' chords are off by less than 1e-6 of their radius.
std::vector<double> instants(const CommonDimensions& dimensions, const SlotSide side) {
  constexpr int count = 4000;
  std::vector<double> result;
  for (int i = 1; i < count; ++i)
    result.push_back(half_engagement(dimensions, side) * (2. * i / count - 1.));
  return result;
}

/// The tips' whole way where it is within the disc's circle.
std::vector<Point> way_of_tips(const CommonDimensions& dimensions, const SlotSide side) {
  constexpr double on_rim = 1e-9;
  std::vector<Point> way;
  for (const double angle : instants(dimensions, side))
    for (const Point& tip : tips(dimensions, side, angle))
      if (size(tip) < (1. - on_rim) * dimensions.locking_radius) way.push_back(tip);
  return way;
}

/// Where a tip crosses the disc's circle between a driver angle on one side of it and one on the
/// other, by bisection.
Point crossing(const CommonDimensions& dimensions, const SlotSide side, const std::size_t tip,
               double before, double after) {
  const auto place = [&](const double angle) { return tips(dimensions, side, angle)[tip]; };
  const auto inside = [&](const double angle) {
    return size(place(angle)) < dimensions.locking_radius;
  };
  const bool inside_before = inside(before);
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (before + after) / 2.;
    (inside(middle) == inside_before ? before : after) = middle;
  }
  return place(before);
}

/// How far from the pin's line the tips cross the disc's circle [rad]: a narrower cut-out would
/// leave corners in their way.
double reach_of_tips(const CommonDimensions& dimensions, const SlotSide side) {
  const double radius = dimensions.locking_radius;
  const std::vector<double> angles = instants(dimensions, side);
  double reach = 0.;
  std::vector<Point> last = tips(dimensions, side, angles.front());
  for (std::size_t i = 1; i < angles.size(); ++i) {
    std::vector<Point> next = tips(dimensions, side, angles[i]);
    for (std::size_t tip = 0; tip < next.size(); ++tip)
      if ((size(last[tip]) < radius) != (size(next[tip]) < radius)) {
        const Point at = crossing(dimensions, side, tip, angles[i - 1], angles[i]);
        reach = std::max(reach, std::abs(std::atan2(at.y, at.x)));
      }
    last = std::move(next);
  }
  return reach;
}

/// Of a width on the rim the one of least curvature through which every tip passes.
CutOut cut_out(const CommonDimensions& dimensions, const SlotSide side,
               const std::vector<Point>& way, const double half_width) {
  const double radius = dimensions.locking_radius;
  CutOut result{half_width, sense(side) / (2. * dimensions.centre_distance)};
  for (const Point& tip : way)
    result.curvature =
        std::max(result.curvature, (radius * std::cos(half_width) - tip.x) /
                                       (radius * radius - tip.x * tip.x - tip.y * tip.y));
  return result;
}

/// Where the cut-out's boundary meets the pin's line: x + k (R^2 - x^2) = R cos w [m].
double deepest(const CutOut& cut, const double radius) {
  const double corner = radius * std::cos(cut.half_width);
  const double squares = 1. + 4. * cut.curvature * (cut.curvature * radius * radius - corner);
  // of both roots the one that stays for a curvature of 0
  return 2. * (corner - cut.curvature * radius * radius) / (1. + std::sqrt(squares));
}

/// Rim from one cut-out to the next, in two arcs: it may be more than half a turn.
void add_rim(Loop& loop, const double radius, const double begin, const double end) {
  const Point rim{radius, 0.};
  const std::array<double, 3> angles{begin, (begin + end) / 2., end};
  for (std::size_t i = 0; i < 2; ++i)
    loop.push_back(
        arc(rotated(rim, angles[i]), rotated(rim, angles[i + 1]), {0., 0.}, false, "locking disc"));
}

/// Counter-clockwise around the material, from the rim's end before the pin to its begin after it.
void add_cut(Loop& loop, const CutOut& cut, const double radius, const double pin_angle,
             const Point next) {
  const Point start = rotated({radius, 0.}, pin_angle - cut.half_width);
  if (std::abs(cut.curvature) * radius < 1e-9) {
    loop.push_back(line(start, next, "cut-out"));
    return;
  }
  const Point centre = rotated({1. / (2. * cut.curvature), 0.}, pin_angle);
  loop.push_back(arc(start, next, centre, cut.curvature > 0., "cut-out"));
}

/// The narrowest cut-out, from the engagement on, that leaves something of the disc.
CutOut cut_out(const CommonDimensions& dimensions, const SlotSide side) {
  constexpr double least_left = 0.1;  // on the pin's line, of the radius
  const double radius = dimensions.locking_radius;
  const std::vector<Point> way = way_of_tips(dimensions, side);
  const double least_width =
      std::max(half_engagement(dimensions, side), reach_of_tips(dimensions, side));
  CutOut cut = cut_out(dimensions, side, way, least_width);
  while (cut.half_width < pi && deepest(cut, radius) < (least_left - 1.) * radius)
    cut = cut_out(dimensions, side, way, cut.half_width + degree / 2.);
  return cut;
}

}  // namespace

double half_engagement(const CommonDimensions& dimensions, const SlotSide side) {
  return pi / 2. - sense(side) * pi / dimensions.stations;
}

std::optional<LockingDisc> locking_disc(const CommonDimensions& dimensions, const SlotSide side,
                                        const std::vector<double>& pin_angles) {
  constexpr double least_dwell = degree;
  const CutOut cut = cut_out(dimensions, side);
  const double radius = dimensions.locking_radius;
  std::vector<double> pins = pin_angles;
  for (double& angle : pins) angle -= 2. * pi * std::floor(angle / (2. * pi));
  std::sort(pins.begin(), pins.end());
  pins.push_back(pins.front() + 2. * pi);
  Loop loop;
  for (std::size_t i = 0; i + 1 < pins.size(); ++i) {
    const double begin = pins[i] + cut.half_width;
    const double end = pins[i + 1] - cut.half_width;
    if (end - begin < least_dwell) return std::nullopt;
    add_cut(loop, cut, radius, pins[i], rotated({radius, 0.}, begin));
    add_rim(loop, radius, begin, end);
  }
  // the very numbers of its start, so that the loop closes without a gap
  loop.back().end = loop.front().start;
  return LockingDisc{{"locking disc", {loop}}, cut.half_width};
}

}  // namespace geneva::loads
