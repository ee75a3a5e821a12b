#include "api/cycle_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geneva::api {

namespace {

using post::CyclePoint;

/// Peak pressure over Hertz's along the instants of one wall.
class PressureRatio {
 public:
  explicit PressureRatio(const std::vector<CyclePoint>& points) : points_(points) {}

  /// Interpolated between the instants before and after, of the same engagement and wall.
  [[nodiscard]] double operator()(const std::size_t engagement, const loads::PinLoad& load) const {
    const CyclePoint* before = nullptr;
    const CyclePoint* after = nullptr;
    for (const CyclePoint& point : points_) {
      if (!point.contact || point.instant.engagement != engagement ||
          point.instant.load.wall != load.wall)
        continue;
      if (point.instant.load.time <= load.time)
        before = &point;
      else if (after == nullptr)
        after = &point;
    }
    if (before == nullptr && after == nullptr) return std::numeric_limits<double>::quiet_NaN();
    if (before == nullptr) return ratio(*after);
    if (after == nullptr) return ratio(*before);
    const double from = before->instant.load.time;
    const double share = (load.time - from) / (after->instant.load.time - from);
    return (1. - share) * ratio(*before) + share * ratio(*after);
  }

 private:
  static double ratio(const CyclePoint& point) {
    return point.contact->peak_pressure / point.hertz_pressure;
  }

  const std::vector<CyclePoint>& points_;
};

/// Heat per length and time over the speed at which its place moves.
double per_area(const double heat, const double speed) {
  if (heat == 0.) return 0.;
  return speed == 0. ? std::numeric_limits<double>::quiet_NaN() : heat / std::abs(speed);
}

}  // namespace

std::vector<post::CycleCurvePoint> curve_of(const std::vector<CyclePoint>& points,
                                            const loads::DrivenMechanism& driven,
                                            const loads::WheelTrain& train,
                                            const loads::PinContact& contact) {
  constexpr int steps = 200;
  const PressureRatio ratio(points);
  std::vector<post::CycleCurvePoint> curve;
  for (std::size_t i = 0; i < driven.engagements().size(); ++i) {
    if (std::none_of(points.begin(), points.end(),
                     [&](const CyclePoint& point) { return point.instant.engagement == i; }))
      continue;
    const loads::TimedEngagement& engagement = driven.engagements()[i];
    for (int step = 0; step <= steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      const double time =
          std::min(engagement.begin + (engagement.end - engagement.begin) * share, engagement.end);
      const loads::MotionState motion = driven.at_time(time);
      const loads::PinLoad load = loads::pin_load(motion, train);
      const double hertz = loads::hertz_pressure(contact, load.force);
      // of a roller the heat is in its bore
      const double heat = train.slot_friction * std::abs(load.force) / contact.thickness *
                          std::abs(load.slip_speed);
      const double pin_speed = 0.5 * contact.pin_diameter * load.pin_turn_speed;
      curve.push_back({load.driver_angle, load.force, hertz, hertz * ratio(i, load),
                       load.slip_speed, load.pin_distance, motion.pin_turn.value,
                       per_area(heat, load.travel_speed), per_area(heat, pin_speed)});
    }
  }
  return curve;
}

post::CycleWork work_of(const loads::DrivenMechanism& driven, const loads::WheelTrain& train) {
  constexpr int steps = 20000;
  const loads::TimedEngagement& engagement = driven.engagements().front();
  const double step = (engagement.end - engagement.begin) / steps;
  post::CycleWork work{};
  double taken = 0.;
  for (int i = 0; i <= steps; ++i) {
    const double weight = (i == 0 || i == steps ? 1. : i % 2 == 1 ? 4. : 2.) * step / 3.;
    const loads::PinLoad load = loads::pin_load(
        driven.at_time(std::min(engagement.begin + i * step, engagement.end)), train);
    const double power = load.moment * load.wheel_speed;
    work.pin += weight * power;
    work.driving += weight * std::max(0., power);
    work.friction += weight * loads::friction_along_wall(train) * std::abs(load.force) *
                     (train.roller ? load.bore_speed : std::abs(load.slip_speed));
    taken += weight * (train.load.friction_moment * std::abs(load.wheel_speed) +
                       train.external_torque * load.wheel_speed);
  }
  const auto speed_at = [&](const double time) { return driven.at_time(time).wheel_angle.first; };
  const double inertia = train.wheel_inertia + train.load.load_inertia;
  work.energy_change =
      taken + 0.5 * inertia *
                  (std::pow(speed_at(engagement.end), 2) - std::pow(speed_at(engagement.begin), 2));
  return work;
}

}  // namespace geneva::api
