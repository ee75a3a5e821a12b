#include "loads/motion/long_dwell_geneva.h"

#include <fmt/format.h>

#include <cmath>

#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// The pin's place in a plane and the direction of its chain link as functions of one variable.
struct Place {
  Jet x;
  Jet y;
  Jet turn;  ///< of the link, against the wheel's sense; 0 midway [rad]
};

Place circle(const double centre_x, const double centre_y, const double radius, const Jet& angle) {
  return {centre_x - radius * cos(angle), centre_y + radius * sin(angle), angle};
}

/// The pin's place on the chain; x leads away from the wheel, y is 0 midway.
/// @param near_axis x of the sprocket whose circle passes the line of centres first
Place along(const double near_axis, const double radius, const double spacing, const Jet& angle) {
  const double quarter = pi / 2.;
  const double straight = spacing / radius;
  const double side = angle.value < 0. ? -1. : 1.;
  const Jet turned = side * angle;
  if (turned.value <= quarter) return circle(near_axis, 0., radius, angle);
  if (turned.value <= quarter + straight)
    return {near_axis + radius * (turned - quarter), constant(side * radius),
            constant(side * quarter)};
  return circle(near_axis + spacing, 0., radius, angle - side * straight);
}

/// @param axes x of both sprockets' axes
Place across(const double axes, const double radius, const double spacing, const Jet& angle) {
  const double half = spacing / (2. * radius);
  const double side = angle.value < 0. ? -1. : 1.;
  const Jet turned = side * angle;
  if (turned.value <= half) return {constant(axes - radius), radius * angle, constant(0.)};
  if (turned.value <= half + pi)
    return circle(axes, side * spacing / 2., radius, angle - side * half);
  return {constant(axes + radius), side * (spacing / 2. - radius * (turned - half - pi)),
          constant(side * pi)};
}

}  // namespace

Mechanism long_dwell_geneva(const int stations, const double pitch_radius, const double spacing,
                            const SprocketLine line) {
  require_stations(stations);
  require_positive_length("pitch radius", pitch_radius);
  require_not_negative("sprocket spacing", 1e3 * spacing, "mm");
  const double alpha = pi / stations;
  const double period = 2. * pi + 2. * spacing / pitch_radius;
  const auto wrapped = [period](const double angle) {
    return variable(angle - period * std::floor(angle / period + 0.5));
  };
  Mechanism mechanism{fmt::format("long-dwell Geneva with {} stations", stations),
                      stations,
                      period,
                      0.,
                      pi / 2. - alpha,
                      {},
                      {}};
  if (line == SprocketLine::along_line_of_centres) {
    const double axis = pitch_radius / std::sin(alpha);
    mechanism.motion = [=](const double driver_angle) {
      const Place pin = along(axis, pitch_radius, spacing, wrapped(driver_angle));
      return slot_motion(pin.x, pin.y, pin.turn);
    };
  } else {
    const double half = spacing / (2. * pitch_radius);
    const double axes = (pitch_radius + spacing / 2. * std::cos(alpha)) / std::sin(alpha);
    mechanism.exit += half;
    if (spacing > 0.) mechanism.joints = {-half, half};
    mechanism.motion = [=](const double driver_angle) {
      const Place pin = across(axes, pitch_radius, spacing, wrapped(driver_angle));
      return slot_motion(pin.x, pin.y, pin.turn);
    };
  }
  mechanism.entry = -mechanism.exit;
  return mechanism;
}

}  // namespace geneva::loads
