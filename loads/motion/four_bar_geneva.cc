#include "loads/motion/four_bar_geneva.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

constexpr int samples = 720;  // of a turn

Jet jet(const std::array<double, 4>& derivatives) {
  return {derivatives[0], derivatives[1], derivatives[2], derivatives[3]};
}

/// Where a function changes its sign between two places in any order.
double root(const std::function<double(double)>& function, const double one, const double other) {
  const double begin = std::min(one, other);
  const double end = std::max(one, other);
  const double at_begin = function(begin);
  const double at_end = function(end);
  if (at_begin == 0.) return begin;
  if (at_end == 0.) return end;
  std::uintmax_t steps = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      function, begin, end, at_begin, at_end, boost::math::tools::eps_tolerance<double>(51), steps);
  return (bracket.first + bracket.second) / 2.;
}

/// The coupler point over a turn of the crank, which does not depend on the wheel.
struct CouplerCurve {
  FourBar linkage;
  Assembly assembly;
  std::vector<FourBarMotion> samples;  ///< at equal steps, half a step from 0
};

constexpr double step = 2. * pi / samples;

std::shared_ptr<const CouplerCurve> coupler_curve(const FourBar& linkage, const Assembly assembly) {
  CouplerCurve curve{linkage, assembly, {}};
  for (int i = 0; i < samples; ++i)
    curve.samples.push_back(loads::motion(linkage, assembly, (i + 0.5) * step));
  return std::make_shared<const CouplerCurve>(std::move(curve));
}

/// The coupler point as seen from the wheel's axis.
class PinPath {
 public:
  PinPath(std::shared_ptr<const CouplerCurve> curve, const double direction, const double distance)
      : curve_(std::move(curve)),
        axis_x_(curve_->linkage.crank_pivot[0] + distance * std::cos(direction)),
        axis_y_(curve_->linkage.crank_pivot[1] + distance * std::sin(direction)) {}

  [[nodiscard]] SlotMotion at(const double crank_angle) const {
    return turned(crank_angle, 0., 1.);
  }
  /// The same, its x axis leading from the wheel's axis along an angle, mirrored if side is -1.
  [[nodiscard]] SlotMotion turned(const double crank_angle, const double angle,
                                  const double side) const {
    const FourBarMotion state = loads::motion(curve_->linkage, curve_->assembly, crank_angle);
    const Jet x = jet(state.x) - axis_x_;
    const Jet y = jet(state.y) - axis_y_;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    return slot_motion(cosine * x + sine * y, side * (cosine * y - sine * x),
                       -side * jet(state.coupler_angle));
  }
  [[nodiscard]] double distance_of_sample(const int index) const {
    const FourBarMotion& state = sample(index);
    return std::hypot(state.x[0] - axis_x_, state.y[0] - axis_y_);
  }
  /// Has the sign of the rate of the pin's angle about the wheel's axis.
  [[nodiscard]] double turning_of_sample(const int index) const { return turning(sample(index)); }
  [[nodiscard]] double turning_at(const double crank_angle) const {
    return turning(loads::motion(curve_->linkage, curve_->assembly, crank_angle));
  }

 private:
  [[nodiscard]] const FourBarMotion& sample(const int index) const {
    return curve_->samples[static_cast<std::size_t>((index % samples + samples) % samples)];
  }
  [[nodiscard]] double turning(const FourBarMotion& state) const {
    return (state.x[0] - axis_x_) * state.y[1] - (state.y[0] - axis_y_) * state.x[1];
  }

  std::shared_ptr<const CouplerCurve> curve_;
  double axis_x_;
  double axis_y_;
};

/// Crank angles between which the pin turns the wheel one way, around the pin's nearest place; none
/// if it goes round the wheel's axis.
struct Stretch {
  double begin;
  double end;
  double swing;  ///< of the wheel [rad], with its sign
};

/// Angle by which the pin has gone round the wheel's axis between two crank angles less than a turn
/// apart.
double swing(const PinPath& path, const double begin, const double end) {
  constexpr int steps = 16;  // each turns by less than half a turn
  double sum = 0.;
  double last = path.at(begin).wheel_angle.value;
  for (int i = 1; i <= steps; ++i) {
    const double next = path.at(begin + (end - begin) * i / steps).wheel_angle.value;
    sum += std::remainder(next - last, 2. * pi);
    last = next;
  }
  return sum;
}

std::optional<Stretch> stretch_around_nearest(const PinPath& path) {
  int nearest = 0;
  for (int i = 1; i < samples; ++i)
    if (path.distance_of_sample(i) < path.distance_of_sample(nearest)) nearest = i;
  const double sign = path.turning_of_sample(nearest) > 0. ? 1. : -1.;
  const auto end_of_stretch = [&](const int way) -> std::optional<double> {
    for (int i = 1; i < samples; ++i) {
      const int here = nearest + way * i;
      if (sign * path.turning_of_sample(here) < 0.)
        return root([&](const double angle) { return path.turning_at(angle); },
                    (here - way + 0.5) * step, (here + 0.5) * step);
    }
    return std::nullopt;
  };
  const auto begin = end_of_stretch(-1);
  const auto end = end_of_stretch(1);
  if (!begin || !end) return std::nullopt;
  return Stretch{*begin, *end, swing(path, *begin, *end)};
}

/// Swing of the wheel for an axis at a distance, without a sign; 2 pi where the pin goes round it.
double swing_at(const std::shared_ptr<const CouplerCurve>& curve, const double direction,
                const double distance) {
  const auto stretch = stretch_around_nearest({curve, direction, distance});
  return stretch ? std::abs(stretch->swing) : 2. * pi;
}

/// The maximum distance at which the swing is a pitch: it falls with the distance far away.
double tangent_distance(const int stations, const std::shared_ptr<const CouplerCurve>& curve,
                        const double direction) {
  const double pitch = 2. * pi / stations;
  const auto excess = [&](const double distance) {
    return swing_at(curve, direction, distance) - pitch;
  };
  const FourBar& linkage = curve->linkage;
  constexpr double ratio = 1.03;
  double far = 20. * (linkage.crank + linkage.coupler + linkage.rocker + linkage.point_distance);
  while (far > 1e-2 * linkage.crank) {
    const double near = far / ratio;
    if (excess(near) >= 0.) {
      const double distance = root(excess, near, far);
      // The swing jumps where the axis comes into the loop of the path: that is no tangency.
      if (std::abs(excess(distance)) < 1e-9) return distance;
      break;
    }
    far = near;
  }
  throw base::InputError(fmt::format(
      "wheel direction is {:.6g} deg: nowhere along it does the coupler point turn a wheel of {} "
      "stations by its pitch of {:.6g} deg; choose another direction, or more stations",
      direction / degree, stations, pitch / degree));
}

/// Refuses a motion through a place where the linkage could go on in two ways.
void refuse_change_point(const FourBar& linkage, const Assembly assembly, const double begin,
                         const double end) {
  if (stays_parallelogram(linkage, assembly)) return;
  for (const double angle : change_points(linkage)) {
    const double inside = angle + 2. * pi * std::ceil((begin - angle) / (2. * pi));
    if (inside > end) continue;
    throw base::InputError(fmt::format(
        "lengths are AB {:.6g}, BC {:.6g}, CD {:.6g} and AD {:.6g} mm: all links are in line at a "
        "crank angle of {:.6g} deg, which is in the engagement, and the linkage can go on there in "
        "two ways; make the crank shorter, or choose another wheel direction",
        1e3 * linkage.crank, 1e3 * linkage.coupler, 1e3 * linkage.rocker,
        1e3 * frame_length(linkage), std::remainder(angle, 2. * pi) / degree));
  }
}

}  // namespace

FourBarGeneva four_bar_geneva(const int stations, const FourBar& linkage, const Assembly assembly,
                              const WheelPlace& place) {
  require_stations(stations);
  require_finite("wheel direction", place.direction / degree, "deg");
  if (!crank_turns_fully(linkage))
    throw base::InputError(fmt::format(
        "the crank of {:.6g} mm does not turn fully: with a frame of {:.6g} mm, a coupler of "
        "{:.6g} "
        "mm and a rocker of {:.6g} mm the shortest and the longest link together must not be "
        "longer "
        "than the other two, and crank or frame the shortest (Grashof); shorten the crank",
        1e3 * linkage.crank, 1e3 * frame_length(linkage), 1e3 * linkage.coupler,
        1e3 * linkage.rocker));
  if (place.distance) require_positive_length("centre distance", *place.distance);
  const auto curve = coupler_curve(linkage, assembly);
  const double distance =
      place.distance ? *place.distance : tangent_distance(stations, curve, place.direction);
  const PinPath path(curve, place.direction, distance);
  const auto stretch = stretch_around_nearest(path);
  const double pitch = 2. * pi / stations;
  constexpr double rounding = 1e-9;
  if (!stretch || std::abs(stretch->swing) < pitch - rounding)
    throw base::InputError(fmt::format(
        "centre distance is {:.6g} mm: {}; a wheel of {} stations turns by {:.6g} deg; choose "
        "another distance, or leave it out to have it found",
        1e3 * distance,
        stretch ? fmt::format("the coupler point turns the wheel by {:.6g} deg at most",
                              std::abs(stretch->swing) / degree)
                : std::string("the coupler point goes round the wheel's axis"),
        stations, pitch / degree));
  const double side = stretch->swing > 0. ? 1. : -1.;
  const double start = path.at(stretch->begin).wheel_angle.value;
  const auto turned = [&](const double angle) { return side * swing(path, stretch->begin, angle); };
  const bool is_whole = turned(stretch->end) <= pitch + rounding;
  const double end = is_whole ? stretch->end
                              : root([&](const double angle) { return turned(angle) - pitch; },
                                     stretch->begin, stretch->end);
  refuse_change_point(linkage, assembly, stretch->begin, end);
  const double middle =
      root([&](const double angle) { return turned(angle) - pitch / 2.; }, stretch->begin, end);
  const double towards_pin = start + side * pitch / 2.;
  return {{fmt::format("four-bar Geneva with {} stations", stations),
           stations,
           2. * pi,
           stretch->begin - middle,
           end - middle,
           {},
           [=](const double driver_angle) {
             return path.turned(middle + driver_angle, towards_pin, side);
           }},
          distance,
          middle};
}

}  // namespace geneva::loads
