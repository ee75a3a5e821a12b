#include "loads/motion/external_geneva.h"

#include <fmt/format.h>

#include <cmath>

#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

double square(double value) { return value * value; }

}  // namespace

ExternalGeneva::ExternalGeneva(int stations)
    : stations_(require_stations(stations)),
      half_pitch_(pi / stations_),
      crank_ratio_(std::sin(half_pitch_)) {}

double ExternalGeneva::engagement_angle() const { return pi / 2. - half_pitch_; }

double ExternalGeneva::wheel_angle(double driver_angle) const {
  return std::atan2(crank_ratio_ * std::sin(driver_angle),
                    1. - crank_ratio_ * std::cos(driver_angle));
}

double ExternalGeneva::speed_ratio(double driver_angle) const {
  return crank_ratio_ * (std::cos(driver_angle) - crank_ratio_) /
         square(pin_distance_ratio(driver_angle));
}

double ExternalGeneva::acceleration_ratio(double driver_angle) const {
  const double distance_squared = square(pin_distance_ratio(driver_angle));
  return -crank_ratio_ * square(std::cos(half_pitch_)) * std::sin(driver_angle) /
         square(distance_squared);
}

double ExternalGeneva::jerk_ratio(double driver_angle) const {
  const double distance_squared = square(pin_distance_ratio(driver_angle));
  const double bracket = distance_squared * std::cos(driver_angle) -
                         4. * crank_ratio_ * square(std::sin(driver_angle));
  return -crank_ratio_ * square(std::cos(half_pitch_)) * bracket /
         (square(distance_squared) * distance_squared);
}

double ExternalGeneva::pin_distance_ratio(double driver_angle) const {
  // 1 + s^2 - 2 s cos(theta), written so that nothing cancels near the line of centres
  const double half_sine = std::sin(driver_angle / 2.);
  return std::sqrt(square(1. - crank_ratio_) + 4. * crank_ratio_ * square(half_sine));
}

double ExternalGeneva::peak_acceleration_angle() const {
  const double gamma = (1. + square(crank_ratio_)) / (2. * crank_ratio_);
  return std::acos((std::sqrt(square(gamma) + 8.) - gamma) / 2.);
}

double ExternalGeneva::wheel_speed(double driver_angle, double driver_speed) const {
  return driver_speed * speed_ratio(driver_angle);
}

double ExternalGeneva::wheel_acceleration(double driver_angle, double driver_speed,
                                          double driver_acceleration) const {
  return driver_acceleration * speed_ratio(driver_angle) +
         square(driver_speed) * acceleration_ratio(driver_angle);
}

Mechanism external_geneva(const int stations, const double centre_distance) {
  const ExternalGeneva geneva(stations);
  require_positive_length("centre distance", centre_distance);
  const double crank = centre_distance * geneva.crank_ratio();
  const auto motion = [=](const double driver_angle) {
    const Jet angle = variable(driver_angle);
    return slot_motion(centre_distance - crank * cos(angle), crank * sin(angle), angle);
  };
  return {fmt::format("external Geneva with {} stations", stations),
          stations,
          2. * pi,
          -geneva.engagement_angle(),
          geneva.engagement_angle(),
          {},
          motion};
}

}  // namespace geneva::loads
