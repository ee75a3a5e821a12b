#include "loads/motion/drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "base/errors.h"
#include "loads/motion/cubic_spline.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// Where an increasing function takes a value, between two places.
double inverse(const std::function<double(double)>& function, const double begin, const double end,
               const double value) {
  const double below = function(begin) - value;
  const double above = function(end) - value;
  if (below >= 0.) return begin;
  if (above <= 0.) return end;
  std::uintmax_t steps = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      [&](const double x) { return function(x) - value; }, begin, end, below, above,
      boost::math::tools::eps_tolerance<double>(52), steps);
  return (bracket.first + bracket.second) / 2.;
}

/// A stretch of time in which a pin is in its slot, or none is.
struct Phase {
  double begin;                  ///< [s]
  double end;                    ///< [s]
  double from;                   ///< driver angle [rad]
  double to;                     ///< driver angle [rad]
  std::optional<double> middle;  ///< of the engagement [rad]
};

/// Engagements of equal motion times with dwells at the reference speed between them; the first
/// pin passes driver angle 0 at time 0.
std::vector<Phase> phases(const Mechanism& mechanism, const std::vector<Engagement>& engagements,
                          const double motion_time, const double speed) {
  std::vector<Phase> result;
  double time = 0.;
  double angle = cycle_begin(mechanism, engagements);
  const double cycle_end = angle + mechanism.period;
  double origin = 0.;
  const auto add_dwell = [&](const double to) {
    if (to > angle) result.push_back({time, time + (to - angle) / speed, angle, to, std::nullopt});
    time += std::max(0., to - angle) / speed;
    angle = to;
  };
  for (const Engagement& engagement : engagements) {
    add_dwell(engagement.begin);
    result.push_back({time, time + motion_time, angle, engagement.end, engagement.middle});
    if (engagement.pin == 0) origin = time + motion_time / 2.;
    time += motion_time;
    angle = engagement.end;
  }
  add_dwell(cycle_end);
  for (Phase& phase : result) {
    phase.begin -= origin;
    phase.end -= origin;
  }
  return result;
}

/// The phase at a time; where two meet, that of the pin.
const Phase& phase_at(const std::vector<Phase>& phases, const double time) {
  const double slack = 1e-12 * (phases.back().end - phases.front().begin);
  for (const Phase& phase : phases)
    if (phase.middle && time >= phase.begin - slack && time <= phase.end + slack) return phase;
  for (const Phase& phase : phases)
    if (time <= phase.end) return phase;
  return phases.back();
}

/// Relative time in a phase, as a function of time.
Jet relative_time(const Phase& phase, const double time) {
  const double duration = phase.end - phase.begin;
  return {std::clamp((time - phase.begin) / duration, 0., 1.), 1. / duration, 0., 0.};
}

/// A drive whose engagements follow a law and whose dwells are passed at constant speed.
Drive phased(const Mechanism& mechanism, const std::vector<Engagement>& engagements,
             const double motion_time,
             const std::function<Jet(const Jet& relative_time)>& law_of_angle) {
  require_positive("motion time", motion_time, "s");
  const double speed = (mechanism.exit - mechanism.entry) / motion_time;
  const auto all = std::make_shared<const std::vector<Phase>>(
      phases(mechanism, engagements, motion_time, speed));
  Drive drive{};
  drive.begin = all->front().begin;
  drive.end = all->back().end;
  drive.reference_speed = speed;
  drive.driver_angle = [=](const double time) {
    const Phase& phase = phase_at(*all, time);
    if (phase.middle) return *phase.middle + law_of_angle(relative_time(phase, time));
    return Jet{phase.from + speed * (time - phase.begin), speed, 0., 0.};
  };
  drive.time_at = [all, angle_at = drive.driver_angle](const double angle) {
    for (const Phase& phase : *all)
      if (angle <= phase.to)
        return inverse([&](const double time) { return angle_at(time).value; }, phase.begin,
                       phase.end, angle);
    return all->back().end;
  };
  return drive;
}

/// sin(x)/x and its derivatives, for |x| < 1.
Jet sine_ratio(const Jet& x) {
  std::array<double, 4> derivatives{};
  double coefficient = 1.;  // of x^(2 i): (-1)^i/(2 i + 1)!
  for (int i = 0; i < 10; ++i) {
    double term = coefficient;
    for (int order = 0; order < 4; ++order) {
      const int power = 2 * i - order;
      if (power < 0) break;
      derivatives.at(static_cast<std::size_t>(order)) += term * std::pow(x.value, power);
      term *= power;
    }
    coefficient *= -1. / ((2. * i + 2.) * (2. * i + 3.));
  }
  return chain({derivatives[0], derivatives[1], derivatives[2], derivatives[3]}, x);
}

/// Carrier, cross and pin while the cross follows a law: functions of relative time.
struct CrossMotion {
  Jet carrier_angle;
  Jet cross_angle;
  Jet pin_distance;
};

/// Eq. 4 - 7 in the first half of the motion, for positive angles (mirrored by the caller).
///
/// beta = asin(lambda sin phi) is a right angle at the end, where asin has no derivative: with
/// beta = pi/2 - 2 asin(u), u^2 = (1 - lambda sin phi)/2 = cos(alpha (1 - A)) sin(alpha A)/sin
/// alpha is a product, and u a smooth function of the root of A.
CrossMotion first_half(const PlaneGeneva kind, const double alpha, const double centre_distance,
                       const MotionLaw law, const Jet& k) {
  const Jet root = chain(root_of_progress(law, k.value), k);
  const Jet part = chain(progress(law, k.value), k);
  const Jet phi = alpha * (1. - 2. * part);
  const Jet smooth =
      (alpha / std::sin(alpha)) * sine_ratio(alpha * part) * cos(alpha * (1. - part));
  const Jet u = root * sqrt(smooth);
  const Jet beta = pi / 2. - 2. * asin(u);
  const Jet cosine = 2. * u * sqrt(1. - u * u);
  const double sign = kind == PlaneGeneva::external ? -1. : 1.;
  return {beta + sign * phi, phi,
          centre_distance * cos(phi) + (sign * centre_distance * std::sin(alpha)) * cosine};
}

CrossMotion cross_motion(const PlaneGeneva kind, const double alpha, const double centre_distance,
                         const MotionLaw law, const Jet& k) {
  if (k.value > 0.5) return first_half(kind, alpha, centre_distance, law, 1. - k);
  const CrossMotion mirrored = first_half(kind, alpha, centre_distance, law, k);
  return {-mirrored.carrier_angle, -mirrored.cross_angle, mirrored.pin_distance};
}

void check_rows(const std::vector<double>& times, const std::vector<double>& angles) {
  if (times.size() < 4)
    throw base::InputError(
        fmt::format("the motion table has {} rows: it needs four or more for a speed and an "
                    "acceleration; add rows",
                    times.size()));
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool is_finite = std::isfinite(times[i]) && std::isfinite(angles[i]);
    if (is_finite && (i == 0 || (times[i] > times[i - 1] && angles[i] > angles[i - 1]))) continue;
    throw base::InputError(fmt::format(
        "row {} of the motion table is {:.6g} s, {:.6g} deg{}: times and angles must be finite and "
        "grow from row to row; sort the table, or leave out double rows",
        i + 1, times[i], angles[i] / degree,
        i == 0 ? ""
               : fmt::format(" after {:.6g} s, {:.6g} deg", times[i - 1], angles[i - 1] / degree)));
  }
}

/// The minimum speed of a cubic between two rows is at an end or where its acceleration is 0.
void check_speed(const CubicSpline& spline) {
  for (std::size_t i = 0; i + 1 < spline.x().size(); ++i) {
    const double begin = spline.x()[i];
    const double width = spline.x()[i + 1] - begin;
    const Jet start = spline(begin);
    const double still = start.third != 0. ? -start.second / start.third : -1.;
    const double least =
        std::min({start.first, start.first + width * (start.second + width * start.third / 2.),
                  still > 0. && still < width
                      ? start.first + still * (start.second + still * start.third / 2.)
                      : start.first});
    if (least <= 0.)
      throw base::InputError(
          fmt::format("the motion table lets the driver stand still or turn back between {:.6g} s "
                      "and {:.6g} s: "
                      "the driver must go forward; add rows there, or make the motion smoother",
                      begin, begin + width));
  }
}

bool covers_one(const std::vector<Engagement>& engagements, const double from, const double to) {
  return std::any_of(engagements.begin(), engagements.end(), [&](const Engagement& engagement) {
    return engagement.begin >= from && engagement.end <= to;
  });
}

}  // namespace

Drive constant_speed(const Mechanism& mechanism, const std::vector<Engagement>& engagements,
                     const double speed) {
  return constant_acceleration(mechanism, engagements, speed, 0.);
}

Drive constant_acceleration(const Mechanism& mechanism, const std::vector<Engagement>& engagements,
                            const double speed, const double acceleration) {
  require_positive("driver speed", speed, "rad/s");
  require_finite("driver acceleration", acceleration, "rad/s^2");
  const auto speed_squared = [=](const double angle) {
    return speed * speed + 2. * acceleration * angle;
  };
  const auto moves = [&](const double from, const double to) {
    return std::min(speed_squared(from), speed_squared(to)) > 0.;
  };
  double from = cycle_begin(mechanism, engagements);
  double to = from + mechanism.period;
  if (!moves(from, to)) {
    from = engagements.front().begin;
    to = engagements.back().end;
  }
  if (!moves(from, to))
    throw base::InputError(fmt::format(
        "driver acceleration is {:.6g} rad/s^2: the driver, at {:.6g} rad/s when driver angle is "
        "0, "
        "would stand still within the engagement from {:.6g} to {:.6g} deg; the acceleration must "
        "be between {:.6g} and {:.6g} rad/s^2",
        acceleration, speed, from / degree, to / degree, -speed * speed / (2. * to),
        -speed * speed / (2. * from)));
  // omega t + epsilon t^2/2 = theta, in the form in which nothing cancels
  const auto time_at = [=](const double angle) {
    return 2. * angle / (speed + std::sqrt(std::max(0., speed_squared(angle))));
  };
  Drive drive{};
  drive.begin = time_at(from);
  drive.end = time_at(to);
  drive.reference_speed = speed;
  drive.driver_angle = [=](const double time) {
    return Jet{(speed + acceleration * time / 2.) * time, speed + acceleration * time, acceleration,
               0.};
  };
  drive.time_at = time_at;
  return drive;
}

Drive table(const std::vector<Engagement>& engagements, const std::vector<double>& times,
            const std::vector<double>& angles) {
  check_rows(times, angles);
  const auto spline = std::make_shared<const CubicSpline>(times, angles);
  check_speed(*spline);
  if (!covers_one(engagements, angles.front(), angles.back()))
    throw base::InputError(fmt::format(
        "the motion table goes from {:.6g} to {:.6g} deg: it covers no engagement as a whole (the "
        "first pin's is from {:.6g} to {:.6g} deg); add rows, or shift the angles, which are 0 "
        "midway through the first pin's engagement",
        angles.front() / degree, angles.back() / degree, engagements.front().begin / degree,
        engagements.front().end / degree));
  Drive drive{};
  drive.begin = times.front();
  drive.end = times.back();
  drive.reference_speed = (angles.back() - angles.front()) / (times.back() - times.front());
  drive.driver_angle = [spline](const double time) { return (*spline)(time); };
  drive.time_at = [spline](const double angle) {
    return inverse([&](const double time) { return (*spline)(time).value; }, spline->x().front(),
                   spline->x().back(), angle);
  };
  return drive;
}

Drive law_on_carrier(const Mechanism& mechanism, const std::vector<Engagement>& engagements,
                     const MotionLaw law, const double motion_time) {
  return phased(mechanism, engagements, motion_time, [=](const Jet& k) {
    return mechanism.entry + (mechanism.exit - mechanism.entry) * chain(progress(law, k.value), k);
  });
}

Drive law_on_cross(const Mechanism& mechanism, const PlaneGeneva kind, const double centre_distance,
                   const std::vector<Engagement>& engagements, const MotionLaw law,
                   const double motion_time) {
  const double alpha = half_pitch(mechanism);
  Drive drive = phased(mechanism, engagements, motion_time, [=](const Jet& k) {
    return cross_motion(kind, alpha, centre_distance, law, k).carrier_angle;
  });
  const double speed = drive.reference_speed;
  const auto all = std::make_shared<const std::vector<Phase>>(
      phases(mechanism, engagements, motion_time, speed));
  drive.prescribed = [=](const double time) -> std::optional<PrescribedMotion> {
    const Phase& phase = phase_at(*all, time);
    if (!phase.middle) return std::nullopt;
    const CrossMotion motion =
        cross_motion(kind, alpha, centre_distance, law, relative_time(phase, time));
    return PrescribedMotion{
        *phase.middle + motion.carrier_angle,
        {motion.cross_angle, motion.pin_distance, motion.pin_distance,
         kind == PlaneGeneva::external ? motion.cross_angle + motion.carrier_angle
                                       : motion.cross_angle - motion.carrier_angle,
         1.}};
  };
  if (has_smooth_root(law)) return drive;
  for (const Phase& phase : *all)
    if (phase.middle)
      for (const bool at_end : {false, true})
        drive.unbounded.push_back(
            {"driver acceleration", at_end ? phase.end : phase.begin,
             at_end ? phase.to : phase.from,
             "the pin moves along the slot there, and only an infinite acceleration of the driver "
             "starts the wheel by a law whose progress grows with the cube of time"});
  return drive;
}

}  // namespace geneva::loads
