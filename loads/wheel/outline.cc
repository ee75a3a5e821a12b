#include "loads/wheel/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"
#include "loads/wheel/outline_shapes.h"

namespace geneva::loads {

namespace {

/// Integrals of 1, x, y and x^2 + y^2 over the area swept by the radius vector.
struct Integrals {
  double one = 0.;
  double x = 0.;
  double y = 0.;
  double square = 0.;
};

void add_line(Integrals& sum, Point p, Point q) {
  const double cross = p.x * q.y - p.y * q.x;
  sum.one += cross / 2.;
  sum.x += cross * (p.x + q.x) / 6.;
  sum.y += cross * (p.y + q.y) / 6.;
  const double squares = p.x * p.x + p.x * q.x + q.x * q.x + p.y * p.y + p.y * q.y + q.y * q.y;
  sum.square += cross * squares / 12.;
}

/// Signed angle of the arc [rad], p and q its ends seen from its centre.
double sweep(Point p, Point q, bool clockwise) {
  const double angle = std::atan2(p.x * q.y - p.y * q.x, p.x * q.x + p.y * q.y);
  if (clockwise && angle > 0.) return angle - 2. * pi;
  if (!clockwise && angle < 0.) return angle + 2. * pi;
  return angle;
}

/// On the arc x = a + rho cos t, y = b + rho sin t the integrands are trigonometric polynomials;
/// their integrals over t follow from the arc's ends and its sweep.
void add_arc(Integrals& sum, const Segment& segment) {
  const double a = segment.centre.x;
  const double b = segment.centre.y;
  const Point p{segment.start.x - a, segment.start.y - b};
  const Point q{segment.end.x - a, segment.end.y - b};
  const double rho_squared = p.x * p.x + p.y * p.y;
  const double swept = rho_squared * sweep(p, q, segment.clockwise);  // rho^2 int dt
  const double cosine = q.y - p.y;                                    // rho int cos t dt
  const double sine = p.x - q.x;                                      // rho int sin t dt
  const double cosine_sine = (q.y * q.y - p.y * p.y) / 2.;            // rho^2 int cos t sin t dt
  const double cosine_squared = (swept + q.x * q.y - p.x * p.y) / 2.;
  const double sine_squared = swept - cosine_squared;
  const double offset = a * cosine + b * sine;
  sum.one += (swept + offset) / 2.;
  sum.x +=
      (a * (swept + offset) + rho_squared * cosine + a * cosine_squared + b * cosine_sine) / 3.;
  sum.y += (b * (swept + offset) + rho_squared * sine + a * cosine_sine + b * sine_squared) / 3.;
  const double far_squared = a * a + b * b + rho_squared;
  sum.square += (far_squared * swept + (far_squared + 2. * rho_squared) * offset +
                 2. * (a * a * cosine_squared + 2. * a * b * cosine_sine + b * b * sine_squared)) /
                4.;
}

void add_loop(Integrals& sum, const Loop& loop) {
  for (const Segment& segment : loop) {
    if (segment.is_arc)
      add_arc(sum, segment);
    else
      add_line(sum, segment.start, segment.end);
  }
}

/// Vertices of one pitch, from the rim's corner with the slot's lower wall to the end of the
/// locking arc, counter-clockwise around the wheel.
std::array<Point, 7> pitch_vertices(const GenevaDimensions& dimensions, double angle) {
  const double half_width = dimensions.slot_width / 2.;
  const double bottom = slot_bottom_centre(dimensions);
  const double end = wall_end(dimensions);
  const Point rim{dimensions.wheel_diameter / 2., 0.};
  const double half_pitch = pi / dimensions.stations;
  const double half_locking = locking_half_angle(dimensions);
  std::array<Point, 7> vertices{{{end, -half_width},
                                 {bottom, -half_width},
                                 {bottom - half_width, 0.},
                                 {bottom, half_width},
                                 {end, half_width},
                                 rotated(rim, half_pitch - half_locking),
                                 rotated(rim, half_pitch + half_locking)}};
  for (Point& vertex : vertices) vertex = rotated(vertex, angle);
  return vertices;
}

/// The locking arc is always less than half a turn: from its centre the rim's chord lies
/// (r^2 + R^2)/(2 c) > 0 towards the wheel's axis.
Loop wheel_boundary(const GenevaDimensions& dimensions) {
  const double pitch = 2. * pi / dimensions.stations;
  const Point axis{0., 0.};
  Loop loop;
  for (int slot = 0; slot < dimensions.stations; ++slot) {
    const double angle = slot * pitch;
    const auto vertices = pitch_vertices(dimensions, angle);
    // the very numbers of the next slot, so that the loop closes without a gap
    const auto next = pitch_vertices(dimensions, (slot + 1) % dimensions.stations * pitch);
    const Point bottom = rotated({slot_bottom_centre(dimensions), 0.}, angle);
    const Point locking = rotated({dimensions.centre_distance, 0.}, angle + pitch / 2.);
    const bool engaged = slot == 0;
    loop.push_back(line(vertices[0], vertices[1], engaged ? "opposite wall" : "slots"));
    loop.push_back(arc(vertices[1], vertices[2], bottom, true, engaged ? "driving wall" : "slots"));
    loop.push_back(arc(vertices[2], vertices[3], bottom, true, engaged ? "driving wall" : "slots"));
    loop.push_back(line(vertices[3], vertices[4], engaged ? "driving wall" : "slots"));
    loop.push_back(arc(vertices[4], vertices[5], axis, false, "rim"));
    loop.push_back(arc(vertices[5], vertices[6], locking, true, "locking arcs"));
    loop.push_back(arc(vertices[6], next[0], axis, false, "rim"));
  }
  return loop;
}

}  // namespace

AreaMoments area_moments(const Outline& outline) {
  Integrals sum;
  for (const Loop& loop : outline.loops) add_loop(sum, loop);
  if (!(sum.one > 0.))
    throw base::InputError(
        fmt::format("area of outline '{}' is {:.6g} mm^2: it must be positive; run the outer loop "
                    "counter-clockwise and the holes clockwise",
                    outline.name, 1e6 * sum.one));
  return {sum.one, {sum.x / sum.one, sum.y / sum.one}, sum.square};
}

double signed_area(const Loop& loop) {
  Integrals sum;
  add_loop(sum, loop);
  return sum.one;
}

double extent(const std::vector<Outline>& outlines) {
  double largest = 0.;
  for (const Outline& outline : outlines)
    for (const Loop& loop : outline.loops)
      for (const Segment& segment : loop)
        largest = std::max({largest, std::abs(segment.start.x), std::abs(segment.start.y)});
  return largest;
}

Outline wheel_outline(const GenevaDimensions& dimensions) {
  check(dimensions);
  return {"wheel",
          {wheel_boundary(dimensions), circle({0., 0.}, dimensions.bore_radius, true, "bore")}};
}

Outline pin_outline(const GenevaDimensions& dimensions, double pin_distance) {
  check(dimensions);
  return pin_beside_wall(dimensions, pin_distance,
                         {dimensions.centre_distance - dimensions.crank_radius, "nearest position",
                          wall_end(dimensions), "end of the wall"});
}

double wheel_inertia(const GenevaDimensions& dimensions, double density) {
  require_positive("density", density, "kg/m^3");
  return density * dimensions.thickness * area_moments(wheel_outline(dimensions)).polar_moment;
}

}  // namespace geneva::loads
