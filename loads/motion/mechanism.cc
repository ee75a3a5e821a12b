#include "loads/motion/mechanism.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// Engagements may follow each other without a dwell, up to a few roundings.
constexpr double rounding = 1e-12;

/// The angle shifted by whole periods into [-period/2, period/2).
double wrapped(const double angle, const double period) {
  return angle - period * std::floor(angle / period + 0.5);
}

void refuse_together(const Mechanism& mechanism, const Engagement& first, const Engagement& second,
                     const double apart) {
  throw base::InputError(fmt::format(
      "pins {} and {} are {:.6g} deg of the driver apart: they would be in slots of the {} "
      "together, since each stays {:.6g} deg; place them at least that far apart ({} equally "
      "spaced "
      "pins at most)",
      first.pin + 1, second.pin + 1, apart / degree, mechanism.name,
      (mechanism.exit - mechanism.entry) / degree, most_pins(mechanism)));
}

}  // namespace

double half_pitch(const Mechanism& mechanism) { return pi / mechanism.stations; }

SlotMotion slot_motion(const Jet& x, const Jet& y, const Jet& carrier_turn) {
  const Jet distance = sqrt(x * x + y * y);
  const Jet wheel_angle = atan2(y, x);
  return {wheel_angle, distance, distance, wheel_angle + carrier_turn, 1.};
}

std::vector<Engagement> engagements(const Mechanism& mechanism,
                                    const std::vector<double>& pin_angles) {
  std::vector<Engagement> result;
  for (std::size_t pin = 0; pin < pin_angles.size(); ++pin) {
    require_finite("pin angle", pin_angles[pin] / degree, "deg");
    const double middle = wrapped(pin_angles[pin], mechanism.period);
    result.push_back({middle + mechanism.entry, middle, middle + mechanism.exit, pin});
  }
  std::sort(result.begin(), result.end(),
            [](const Engagement& a, const Engagement& b) { return a.middle < b.middle; });
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Engagement& next = result[(i + 1) % result.size()];
    const double turn = i + 1 < result.size() ? 0. : mechanism.period;
    if (next.begin + turn < result[i].end - rounding)
      refuse_together(mechanism, result[i], next, next.middle + turn - result[i].middle);
  }
  return result;
}

double cycle_begin(const Mechanism& mechanism, const std::vector<Engagement>& engagements) {
  const double dwell = engagements.front().begin + mechanism.period - engagements.back().end;
  return engagements.front().begin - dwell / 2.;
}

std::vector<double> equally_spaced_pins(const Mechanism& mechanism, const int count) {
  if (count < 1)
    throw base::InputError(fmt::format("number of pins is {}: it must be from 1 to {} with the {}",
                                       count, most_pins(mechanism), mechanism.name));
  std::vector<double> angles;
  angles.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) angles.push_back(i * mechanism.period / count);
  return angles;
}

int most_pins(const Mechanism& mechanism) {
  return static_cast<int>(mechanism.period / (mechanism.exit - mechanism.entry) + rounding * 100.);
}

double tangency_defect(const Mechanism& mechanism, const double driver_angle) {
  const SlotMotion motion = mechanism.motion(driver_angle);
  return std::atan2(std::abs(motion.pin_distance.value * motion.wheel_angle.first),
                    std::abs(motion.slot_position.first));
}

}  // namespace geneva::loads
