#include "loads/motion/kinematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/errors.h"

namespace geneva::loads {

namespace {

PinLoad rest(const MotionState& state) {
  PinLoad load{};
  load.time = state.time;
  load.driver_angle = state.driver_angle.value;
  load.driver_speed = state.driver_angle.first;
  load.driver_acceleration = state.driver_angle.second;
  load.pin_distance = state.pin_distance.value;
  load.wall = Wall::none;
  return load;
}

PlacedPeak placed(const DrivenMechanism& driven,
                  const std::function<double(const MotionState&)>& quantity,
                  const std::vector<double>& breaks = {}) {
  const Peak peak = maximum(driven, quantity, breaks);
  return {peak.value, driven.drive().driver_angle(peak.time).value, peak.time};
}

/// Driver angles [rad] from the middle of an engagement at which the pin goes from one wall to the
/// other, and its slip jumps: where the moment is 0, by bisection.
std::vector<double> wall_changes(const DrivenMechanism& driven, const WheelTrain& train) {
  constexpr int intervals = 256;
  constexpr int halvings = 50;
  const auto drives = [&](const double time) {
    return pin_load(driven.at_time(time), train).moment > 0.;
  };
  std::vector<double> angles;
  for (const TimedEngagement& engagement : driven.engagements())
    for (int i = 0; i < intervals; ++i) {
      const double step = (engagement.end - engagement.begin) / intervals;
      double from = engagement.begin + i * step;
      double to = std::min(engagement.begin + (i + 1) * step, engagement.end);
      const bool drives_before = drives(from);
      if (drives(to) == drives_before) continue;
      for (int halving = 0; halving < halvings; ++halving) {
        const double middle = (from + to) / 2.;
        (drives(middle) == drives_before ? from : to) = middle;
      }
      angles.push_back(driven.drive().driver_angle(from).value - engagement.engagement.middle);
    }
  return angles;
}

/// The maximum size of the slip on the wall that carries.
PlacedPeak maximum_slip(const DrivenMechanism& driven, const WheelTrain& train,
                        std::vector<double> breaks) {
  for (const double angle : wall_changes(driven, train)) breaks.push_back(angle);
  return placed(
      driven, [&](const MotionState& state) { return std::abs(pin_load(state, train).slip_speed); },
      breaks);
}

/// Steps of the cycle and the ends of the engagements, in order.
std::vector<double> times(const DrivenMechanism& driven, const int steps) {
  const double begin = driven.drive().begin;
  const double end = driven.drive().end;
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(steps) + 1 + 2 * driven.engagements().size());
  for (int i = 0; i <= steps; ++i)
    result.push_back(i == steps ? end : begin + (end - begin) * i / steps);
  const double same = 1e-9 * (end - begin);
  for (const TimedEngagement& engagement : driven.engagements())
    for (const double time : {engagement.begin, engagement.end}) {
      const auto next = std::lower_bound(result.begin(), result.end(), time - same);
      if (next != result.end() && *next <= time + same)
        *next = time;
      else
        result.insert(next, time);
    }
  return result;
}

}  // namespace

double hertz_pressure(const PinContact& contact, const double force) {
  if (force == 0.) return 0.;
  return hertz_line(std::abs(force) / contact.thickness, contact.pin_diameter / 2.,
                    contact.contact_modulus)
      .peak_pressure;
}

double bore_pressure(const PinContact& contact, const WheelTrain& train, const double force) {
  if (!train.roller || train.roller->needles) return 0.;
  return std::abs(force) / (train.roller->diameter * contact.thickness);
}

std::vector<KinematicsRow> kinematics_rows(const DrivenMechanism& driven, const WheelTrain& train,
                                           const PinContact& contact, const int steps) {
  if (steps < 1)
    throw base::InputError(fmt::format("number of steps is {}: it must be 1 or more", steps));
  const std::vector<double> instants = times(driven, steps);
  std::vector<KinematicsRow> rows;
  rows.reserve(instants.size());
  for (const double time : instants) {
    const MotionState state = driven.at_time(time);
    const PinLoad load = state.pin ? pin_load(state, train) : rest(state);
    rows.push_back({state, load, hertz_pressure(contact, load.force)});
  }
  return rows;
}

Characteristics characteristics(const DrivenMechanism& driven, const WheelTrain& train,
                                const PinContact& contact) {
  check(train, driven);
  const double speed = driven.drive().reference_speed;
  const TimedEngagement& first = driven.engagements().front();
  const auto force = [&](const MotionState& state) { return pin_load(state, train).force; };
  const auto pressure = [&](const MotionState& state) {
    return hertz_pressure(contact, force(state));
  };
  const auto pressure_times_slip = [&](const MotionState& state) {
    const PinLoad load = pin_load(state, train);
    return hertz_pressure(contact, load.force) * std::abs(load.slip_speed);
  };
  const auto bore_pressure_times_speed = [&](const MotionState& state) {
    const PinLoad load = pin_load(state, train);
    return bore_pressure(contact, train, load.force) * load.bore_speed;
  };
  const std::vector<double> breaks = slip_breaks(driven, train);
  Characteristics result{};
  result.speed_ratio =
      placed(driven, [&](const MotionState& state) { return state.wheel_angle.first / speed; });
  const Peak acceleration = peak_acceleration(driven);
  result.acceleration_ratio = {acceleration.value / (speed * speed),
                               driven.drive().driver_angle(acceleration.time).value,
                               acceleration.time};
  result.jerk_ratio = placed(driven, [&](const MotionState& state) {
    return std::abs(state.wheel_angle.third / (speed * speed * speed));
  });
  result.entry_acceleration_ratio =
      driven.at_time(first.begin).wheel_angle.second / (speed * speed);
  result.jerk_ratio_at_centre =
      driven.at_engaged_angle(first.engagement.middle).wheel_angle.third / (speed * speed * speed);
  result.engagement_angle = driven.mechanism().exit - driven.mechanism().entry;
  result.motion_time = first.end - first.begin;
  result.dwell_times = driven.dwells();
  double motion = 0.;
  for (const TimedEngagement& engagement : driven.engagements())
    motion += engagement.end - engagement.begin;
  const double dwell = std::accumulate(result.dwell_times.begin(), result.dwell_times.end(), 0.);
  result.motion_fraction = motion / (motion + dwell);
  result.time_ratio = motion / dwell;

  const MotionState johnson = driven.at_time(result.acceleration_ratio.time);
  const auto over_johnson = [&](const double value, const double there) {
    return force(johnson) > 0. ? value / there : std::numeric_limits<double>::quiet_NaN();
  };
  result.force = placed(
      driven, [&](const MotionState& state) { return std::max(0., force(state)); }, breaks);
  result.braking_force = placed(
      driven, [&](const MotionState& state) { return std::max(0., -force(state)); }, breaks);
  result.force_ratio = over_johnson(result.force.value, force(johnson));
  result.pressure = placed(driven, pressure, breaks);
  result.pressure_ratio = over_johnson(result.pressure.value, pressure(johnson));
  result.pressure_times_slip = placed(driven, pressure_times_slip, breaks);
  result.pressure_times_slip_ratio =
      over_johnson(result.pressure_times_slip.value, pressure_times_slip(johnson));
  result.slip_speed = maximum_slip(driven, train, breaks);
  result.bore_pressure_times_speed = placed(driven, bore_pressure_times_speed, breaks);
  result.slip_reversals = slip_reversals(driven.mechanism(), train.pin_diameter);
  result.entry_tangency = tangency_defect(driven.mechanism(), driven.mechanism().entry);
  result.exit_tangency = tangency_defect(driven.mechanism(), driven.mechanism().exit);
  return result;
}

}  // namespace geneva::loads
