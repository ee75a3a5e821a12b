#include "loads/motion/pin_load.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// On one wall: what friction takes off the arm of the normal force, per coefficient [m].
double friction_arm(const MotionState& state, const double pin_diameter, const Wall wall) {
  const double slip = surface_speed(state.slot_position, state.pin_turn, pin_diameter, wall);
  const double lever = pin_diameter / 2. * state.friction_lever;
  return slip > 0. ? lever : slip < 0. ? -lever : 0.;
}

/// The arm of the normal force is positive on either wall, since the pin does not jam: the moment's
/// sign is the force's.
Wall wall_of(const double moment) {
  return moment > 0. ? Wall::driving : moment < 0. ? Wall::braking : Wall::none;
}

/// At the ends of an engagement the wheel's speed is 0 but for roundings.
bool turns_backwards(const MotionState& state) {
  constexpr double rounding = 1e-12;
  return state.wheel_angle.first < -rounding * std::abs(state.driver_angle.first);
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

/// A stretch of an engagement, and the times up to which the quantity is evaluated: just inside of
/// ends at which it may jump.
struct Stretch {
  double begin;
  double end;
  double first;
  double last;
};

/// The time of a maximum value found at the edge of a stretch: the edge itself, unless the
/// quantity has another value there, or just beyond, where roundings of an angle may lead.
double time_at_edge(const std::function<double(double)>& at_time, const Peak& inside,
                    const double edge) {
  constexpr double rounding = 1e-9;
  const auto is_other = [&](const double time) {
    return std::abs(at_time(time) - inside.value) > rounding * std::abs(inside.value);
  };
  const double beyond = 2. * edge - inside.time;
  return is_other(edge) || is_other(beyond) ? inside.time : edge;
}

/// The maximum value on a stretch, on which the quantity is smooth.
Peak maximum_on(const DrivenMechanism& driven,
                const std::function<double(const MotionState&)>& quantity, const Stretch& stretch) {
  // Much finer than the sharpest peak, that of n = 3, 4 deg from the line of centres.
  constexpr int intervals = 512;
  const auto at_time = [&](const double at) { return quantity(driven.at_time(at)); };
  const double begin = stretch.begin;
  const double end = stretch.end;
  const double step = (end - begin) / intervals;
  const auto time = [&](const int i) {
    return i == 0 ? stretch.first : i == intervals ? stretch.last : begin + step * i;
  };
  // Differences at the ends reach past them by a rounding, where the pin is in no slot any more.
  const auto value = [&](const double at) {
    return at_time(std::clamp(at, stretch.first, stretch.last));
  };
  Peak best{-std::numeric_limits<double>::infinity(), begin};
  for (int i = 0; i <= intervals; ++i)
    if (const double here = value(time(i)); here > best.value) best = {here, time(i)};
  const double h = step / 8.;
  const auto top = summit(value, std::max(begin + 3. * h, best.time - step),
                          std::min(end - 3. * h, best.time + step), h);
  if (top && value(*top) >= best.value) return {value(*top), *top};
  if (best.time == stretch.first) best.time = time_at_edge(at_time, best, begin);
  if (best.time == stretch.last) best.time = time_at_edge(at_time, best, end);
  return best;
}

/// An engagement cut where a quantity may not be smooth, and midway, so that of two equal maxima of
/// a symmetric motion each has its own stretch.
std::vector<Stretch> stretches(const DrivenMechanism& driven, const TimedEngagement& engagement,
                               const std::vector<double>& breaks) {
  constexpr double inset = 1e-11;
  std::vector<double> times{engagement.begin};
  for (const double joint : driven.joints(engagement)) times.push_back(joint);
  times.push_back(driven.drive().time_at(engagement.engagement.middle));
  for (const double at : breaks)
    times.push_back(driven.drive().time_at(engagement.engagement.middle + at));
  times.push_back(engagement.end);
  std::sort(times.begin(), times.end());
  const double inside = inset * (engagement.end - engagement.begin);
  std::vector<Stretch> result;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double begin = times[i];
    const double end = times[i + 1];
    if (end - begin <= 4. * inside) continue;
    result.push_back({begin, end, begin == engagement.begin ? begin : begin + inside,
                      end == engagement.end ? end : end - inside});
  }
  return result;
}

}  // namespace

double friction_along_wall(const WheelTrain& train) {
  if (!train.roller) return train.slot_friction;
  return train.roller->friction * train.roller->diameter / train.pin_diameter;
}

PinLoad pin_load(const MotionState& state, const WheelTrain& train) {
  if (!state.pin)
    throw base::InputError(
        fmt::format("driver angle is {:.6g} deg: no pin is in a slot there, and the wheel rests",
                    state.driver_angle.value * 180. / pi));
  const double forwards = turns_backwards(state) ? -1. : 1.;
  const double moment = (train.wheel_inertia + train.load.load_inertia) * state.wheel_angle.second +
                        train.load.friction_moment * forwards + train.external_torque;
  const Wall wall = wall_of(moment);
  const double force =
      moment / (state.pin_distance.value -
                friction_along_wall(train) * friction_arm(state, train.pin_diameter, wall));
  const auto slip_on = [&](const Wall on) {
    return surface_speed(state.slot_position, state.pin_turn, train.pin_diameter, on);
  };
  // A roller turns on its stud by the slip that it saves the wall, over its radius.
  const double rolls = train.roller ? 0. : 1.;
  const double bore = train.roller ? train.roller->diameter / train.pin_diameter : 0.;
  return {state.time,
          state.driver_angle.value,
          state.driver_angle.first,
          state.driver_angle.second,
          state.slot_angle,
          state.wheel_angle.first,
          state.wheel_angle.second,
          state.pin_distance.value,
          state.slot_position.first,
          state.pin_turn.first,
          rolls * slip_on(Wall::driving),
          rolls * slip_on(Wall::braking),
          rolls * slip_on(wall),
          bore * std::abs(slip_on(wall)),
          moment,
          force,
          wall};
}

void check(const RollerBore& bore, const double pin_diameter) {
  require_positive_length("bore diameter of the roller", bore.diameter);
  require_not_negative("coefficient of bore friction", bore.friction, "");
  if (bore.diameter < pin_diameter) return;
  throw base::InputError(
      fmt::format("bore diameter of the roller is {:.6g} mm: it must be less than the roller's own "
                  "diameter, {:.6g} mm (the pin diameter)",
                  1e3 * bore.diameter, 1e3 * pin_diameter));
}

void check(const WheelTrain& train, const DrivenMechanism& driven) {
  require_not_negative("wheel inertia", train.wheel_inertia, "kg m^2");
  require_not_negative("load inertia", train.load.load_inertia, "kg m^2");
  require_not_negative("friction moment", train.load.friction_moment, "N m");
  require_not_negative("coefficient of slot friction", train.slot_friction, "");
  require_finite("external torque", train.external_torque, "N m");
  if (train.roller) check(*train.roller, train.pin_diameter);
  const double friction = friction_along_wall(train);
  if (friction == 0.) return;
  const std::vector<double> breaks = slip_breaks(driven, train);
  const auto steepest_on = [&](const Wall wall) {
    return maximum(
               driven,
               [&](const MotionState& state) {
                 return friction_arm(state, train.pin_diameter, wall) / state.pin_distance.value;
               },
               breaks)
        .value;
  };
  const double steepest = std::max(steepest_on(Wall::driving), steepest_on(Wall::braking));
  if (friction * steepest < 1.) return;
  const double given = train.roller ? train.roller->friction : train.slot_friction;
  throw base::InputError(fmt::format(
      "coefficient of {} friction is {:.6g}: the {} of {:.6g} mm jams in the slot, since friction "
      "there has a longer arm than the force that turns the wheel; the coefficient must be below "
      "{:.4g}",
      train.roller ? "bore" : "slot", given, train.roller ? "roller" : "pin",
      1e3 * train.pin_diameter, given / (friction * steepest)));
}

std::vector<double> slip_breaks(const DrivenMechanism& driven, const WheelTrain& train) {
  std::vector<double> angles;
  for (const SlipReversal& reversal : slip_reversals(driven.mechanism(), train.pin_diameter))
    angles.push_back(reversal.driver_angle);
  return angles;
}

Peak maximum(const DrivenMechanism& driven,
             const std::function<double(const MotionState&)>& quantity,
             const std::vector<double>& breaks) {
  // Equal maxima before and after the line of centres differ by roundings: the first one counts.
  constexpr double rounding = 1e-9;
  Peak best{-std::numeric_limits<double>::infinity(), 0.};
  for (const TimedEngagement& engagement : driven.engagements())
    for (const Stretch& stretch : stretches(driven, engagement, breaks)) {
      const Peak peak = maximum_on(driven, quantity, stretch);
      const bool is_first = !std::isfinite(best.value);
      if (is_first ? peak.value > best.value
                   : peak.value > best.value + rounding * std::abs(best.value))
        best = peak;
    }
  return best;
}

double peak_force_angle(const DrivenMechanism& driven, const WheelTrain& train) {
  check(train, driven);
  const Peak peak = maximum(
      driven, [&](const MotionState& state) { return pin_load(state, train).force; },
      slip_breaks(driven, train));
  return driven.drive().driver_angle(peak.time).value;
}

Peak peak_acceleration(const DrivenMechanism& driven) {
  const Peak peak =
      maximum(driven, [](const MotionState& state) { return state.wheel_angle.second; });
  // A flat maximum is told from its neighbours only to the root of roundings, its jerk is not.
  constexpr double beside = 1e-7;
  constexpr int halvings = 40;
  const auto still_rises = [&](const double time) {
    return driven.at_time(time).wheel_angle.third > 0.;
  };
  for (const TimedEngagement& engagement : driven.engagements()) {
    const double slack = beside * (engagement.end - engagement.begin);
    double from = peak.time - slack;
    double to = peak.time + slack;
    if (from < engagement.begin || to > engagement.end) continue;
    if (!still_rises(from) || still_rises(to)) return peak;
    for (int halving = 0; halving < halvings; ++halving) {
      const double middle = (from + to) / 2.;
      (still_rises(middle) ? from : to) = middle;
    }
    return {driven.at_time(from).wheel_angle.second, from};
  }
  return peak;
}

double peak_acceleration_angle(const DrivenMechanism& driven) {
  return driven.drive().driver_angle(peak_acceleration(driven).time).value;
}

}  // namespace geneva::loads
