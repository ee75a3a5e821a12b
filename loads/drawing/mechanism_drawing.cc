#include "loads/drawing/mechanism_drawing.h"

#include <algorithm>
#include <cmath>

#include "loads/pi.h"

namespace geneva::loads {

namespace {

/// Radius of the sphere on which a pin moves; nothing in the plane.
double sphere_radius(const SlotMotion& motion) {
  const double cosine = motion.friction_lever;
  return cosine == 1. ? 0. : motion.pin_distance.value / std::sqrt(1. - cosine * cosine);
}

/// A place at a distance from the wheel's axis along a slot and to its left; on a sphere both are
/// arcs.
Place beside_slot(const double along, const double left, const double direction,
                  const double radius) {
  if (radius == 0.)
    return {along * std::cos(direction) - left * std::sin(direction),
            along * std::sin(direction) + left * std::cos(direction), 0.};
  const double polar = along / radius;
  const double turned = direction + left / (radius * std::sin(polar));
  return {radius * std::sin(polar) * std::cos(turned), radius * std::sin(polar) * std::sin(turned),
          radius * std::cos(polar)};
}

void append_arc(const Segment& segment, Polyline& line) {
  const auto angle_of = [&](const Point& at) {
    return std::atan2(at.y - segment.centre.y, at.x - segment.centre.x);
  };
  const double radius =
      std::hypot(segment.start.x - segment.centre.x, segment.start.y - segment.centre.y);
  const double begin = angle_of(segment.start);
  double turn = angle_of(segment.end) - begin;
  if (segment.clockwise && turn > 0.) turn -= 2. * pi;
  if (!segment.clockwise && turn < 0.) turn += 2. * pi;
  constexpr double step = 0.028;  // 1 - cos(step/2) = 1e-4
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / step)));
  for (int i = 0; i < steps; ++i) {
    const double angle = begin + turn * i / steps;
    line.push_back({segment.centre.x + radius * std::cos(angle),
                    segment.centre.y + radius * std::sin(angle), 0.});
  }
}

}  // namespace

Place pin_place(const SlotMotion& motion) {
  const double angle = motion.wheel_angle.value;
  return {motion.pin_distance.value * std::cos(angle), motion.pin_distance.value * std::sin(angle),
          sphere_radius(motion) * motion.friction_lever};
}

Polyline pin_path(const Mechanism& mechanism, const int steps) {
  Polyline path;
  for (int i = 0; i <= steps; ++i)
    path.push_back(pin_place(mechanism.motion(mechanism.period * (i - 0.5 * steps) / steps)));
  return path;
}

std::vector<Polyline> polylines(const Outline& outline) {
  std::vector<Polyline> result;
  for (const Loop& loop : outline.loops) {
    Polyline line;
    for (const Segment& segment : loop)
      if (segment.is_arc)
        append_arc(segment, line);
      else
        line.push_back({segment.start.x, segment.start.y, 0.});
    line.push_back(line.front());
    result.push_back(std::move(line));
  }
  return result;
}

Polyline schematic_wheel(const Mechanism& mechanism, const double slot_width) {
  const SlotMotion entry = mechanism.motion(mechanism.entry);
  const SlotMotion middle = mechanism.motion(0.);
  const double radius = sphere_radius(entry);
  const double half = slot_width / 2.;
  const double rim = entry.slot_position.value;
  const double bottom = middle.slot_position.value;
  constexpr int bottom_steps = 12;
  constexpr int rim_steps = 16;
  const double opening = half / rim;  // half the angle that a slot takes out of the rim
  Polyline wheel;
  for (int slot = 0; slot < mechanism.stations; ++slot) {
    const double direction = 2. * half_pitch(mechanism) * slot;
    wheel.push_back(beside_slot(rim, -half, direction, radius));
    for (int i = 0; i <= bottom_steps; ++i) {
      const double angle = pi * (i - 0.5 * bottom_steps) / bottom_steps;
      wheel.push_back(
          beside_slot(bottom - half * std::cos(angle), half * std::sin(angle), direction, radius));
    }
    const double from = direction + opening;
    const double to = direction + 2. * half_pitch(mechanism) - opening;
    for (int i = 0; i <= rim_steps; ++i)
      wheel.push_back(beside_slot(rim, 0., from + (to - from) * i / rim_steps, radius));
  }
  wheel.push_back(wheel.front());
  return wheel;
}

}  // namespace geneva::loads
