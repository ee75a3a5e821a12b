#include "loads/motion/pin_load.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// What slot friction takes off the arm of the normal force, per coefficient of friction [m].
double friction_arm(const MotionState& state, const double pin_diameter) {
  const double slip = state.slot_position.first;
  const double lever = pin_diameter / 2. * state.friction_lever;
  return slip > 0. ? lever : slip < 0. ? -lever : 0.;
}

/// Arm of the normal force with the share of slot friction.
double arm(const MotionState& state, const WheelTrain& train) {
  return state.pin_distance.value - train.slot_friction * friction_arm(state, train.pin_diameter);
}

/// Where the slope of a function changes from rising to falling, if it does between two places.
///
/// The slope is the central difference of sixth order: the place of a flat maximum is known only to
/// the root of the function's roundings from its values, but fully from its slope.
std::optional<double> summit(const std::function<double(double)>& function, const double begin,
                             const double end, const double h) {
  const auto slope = [&](const double x) {
    return 45. * (function(x + h) - function(x - h)) -
           9. * (function(x + 2. * h) - function(x - 2. * h)) +
           (function(x + 3. * h) - function(x - 3. * h));
  };
  const double rising = slope(begin);
  const double falling = slope(end);
  if (!(begin < end && rising > 0. && falling < 0.)) return std::nullopt;
  std::uintmax_t steps = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      slope, begin, end, rising, falling, boost::math::tools::eps_tolerance<double>(50), steps);
  return (bracket.first + bracket.second) / 2.;
}

/// The greatest value between two times, on which the quantity is smooth.
Peak greatest_between(const DrivenMechanism& driven,
                      const std::function<double(const MotionState&)>& quantity, const double begin,
                      const double end) {
  // Much finer than the sharpest peak, that of n = 3, 4 deg from the line of centres.
  constexpr int intervals = 512;
  const double step = (end - begin) / intervals;
  const auto time = [&](const int i) { return i == intervals ? end : begin + step * i; };
  // Differences at the ends reach past them by a rounding, where the pin is in no slot any more.
  const auto value = [&](const double at) {
    return quantity(driven.at_time(std::clamp(at, begin, end)));
  };
  Peak best{-std::numeric_limits<double>::infinity(), begin};
  for (int i = 0; i <= intervals; ++i)
    if (const double here = value(time(i)); here > best.value) best = {here, time(i)};
  const double h = step / 8.;
  const auto top = summit(value, std::max(begin + 3. * h, best.time - step),
                          std::min(end - 3. * h, best.time + step), h);
  if (!top || value(*top) < best.value) return best;
  return {value(*top), *top};
}

/// Times that cut an engagement into stretches on which everything is smooth: also the reversal of
/// the slip cuts, where slot friction changes its sign.
std::vector<double> cuts(const DrivenMechanism& driven, const TimedEngagement& engagement) {
  std::vector<double> times{engagement.begin};
  for (const double joint : driven.joints(engagement)) times.push_back(joint);
  times.push_back(driven.drive().time_at(engagement.engagement.middle));
  times.push_back(engagement.end);
  std::sort(times.begin(), times.end());
  return times;
}

}  // namespace

PinLoad pin_load(const MotionState& state, const WheelTrain& train) {
  if (!state.pin)
    throw std::invalid_argument(
        fmt::format("driver angle is {:.6g} deg: no pin is in a slot there, and the wheel rests",
                    state.driver_angle.value * 180. / pi));
  const double forwards = state.wheel_angle.first < 0. ? -1. : 1.;
  const double moment = (train.wheel_inertia + train.load.load_inertia) * state.wheel_angle.second +
                        train.load.friction_moment * forwards + train.external_torque;
  const double force = moment / arm(state, train);
  return {state.time,
          state.driver_angle.value,
          state.driver_angle.first,
          state.driver_angle.second,
          state.slot_angle,
          state.wheel_angle.first,
          state.wheel_angle.second,
          state.pin_distance.value,
          state.slot_position.first,
          moment,
          force,
          force > 0.   ? Wall::driving
          : force < 0. ? Wall::braking
                       : Wall::none};
}

void check(const WheelTrain& train, const DrivenMechanism& driven) {
  require_not_negative("wheel inertia", train.wheel_inertia, "kg m^2");
  require_not_negative("load inertia", train.load.load_inertia, "kg m^2");
  require_not_negative("friction moment", train.load.friction_moment, "N m");
  require_not_negative("coefficient of slot friction", train.slot_friction, "");
  require_finite("external torque", train.external_torque, "N m");
  if (train.slot_friction == 0.) return;
  const Peak steepest = greatest(driven, [&](const MotionState& state) {
    return friction_arm(state, train.pin_diameter) / state.pin_distance.value;
  });
  if (train.slot_friction * steepest.value >= 1.)
    throw std::invalid_argument(fmt::format(
        "coefficient of slot friction is {:.6g}: the pin of {:.6g} mm jams in the slot, since "
        "friction there has a longer arm than the force that turns the wheel; the coefficient must "
        "be below {:.4g}",
        train.slot_friction, 1e3 * train.pin_diameter, 1. / steepest.value));
}

Peak greatest(const DrivenMechanism& driven,
              const std::function<double(const MotionState&)>& quantity) {
  // Equal maxima before and after the line of centres differ by roundings: the first one counts.
  constexpr double rounding = 1e-9;
  Peak best{-std::numeric_limits<double>::infinity(), 0.};
  for (const TimedEngagement& engagement : driven.engagements()) {
    const std::vector<double> times = cuts(driven, engagement);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      if (!(times[i + 1] > times[i])) continue;
      const Peak peak = greatest_between(driven, quantity, times[i], times[i + 1]);
      const bool is_first = !std::isfinite(best.value);
      if (is_first ? peak.value > best.value
                   : peak.value > best.value + rounding * std::abs(best.value))
        best = peak;
    }
  }
  return best;
}

double peak_force_angle(const DrivenMechanism& driven, const WheelTrain& train) {
  check(train, driven);
  const Peak peak =
      greatest(driven, [&](const MotionState& state) { return pin_load(state, train).force; });
  return driven.drive().driver_angle(peak.time).value;
}

double peak_acceleration_angle(const DrivenMechanism& driven) {
  const Peak peak =
      greatest(driven, [](const MotionState& state) { return state.wheel_angle.second; });
  return driven.drive().driver_angle(peak.time).value;
}

}  // namespace geneva::loads
