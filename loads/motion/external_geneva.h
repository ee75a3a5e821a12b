#pragma once

#include "loads/motion/mechanism.h"

namespace geneva::loads {

/// Kinematics of an external Geneva mechanism with one pin (ME341 lecture, Eq. 5.25 - 5.34),
/// dimensionless.
///
/// The driver angle theta is measured from the line of centres: the pin enters the slot at
/// -engagement_angle(), is nearest the wheel axis at 0 and leaves at +engagement_angle(). The wheel
/// angle phi is measured from the line of centres in the wheel's sense of rotation, so that phi
/// grows with theta. The formulas hold within the engagement; beyond it the wheel rests and they do
/// not apply.
class ExternalGeneva {
 public:
  /// @param stations number of slots n, 3..24
  /// @throws base::InputError outside that range
  explicit ExternalGeneva(int stations);

  [[nodiscard]] int stations() const { return stations_; }
  /// alpha = pi/n [rad]: half the angle between slots
  [[nodiscard]] double half_pitch() const { return half_pitch_; }
  /// sin(alpha) = crank radius / centre distance (Fig. 5.31)
  [[nodiscard]] double crank_ratio() const { return crank_ratio_; }
  /// theta_e = pi/2 - alpha [rad]: driver angle at which the pin enters (-) and leaves (+)
  [[nodiscard]] double engagement_angle() const;

  /// phi(theta) [rad], Eq. 5.30
  [[nodiscard]] double wheel_angle(double driver_angle) const;
  /// dphi/dtheta, Eq. 5.31; not negative within the engagement
  [[nodiscard]] double speed_ratio(double driver_angle) const;
  /// d2phi/dtheta2, Eq. 5.32; positive before the line of centres
  [[nodiscard]] double acceleration_ratio(double driver_angle) const;
  /// d3phi/dtheta3, the derivative of Eq. 5.32; negative between the peaks of acceleration
  [[nodiscard]] double jerk_ratio(double driver_angle) const;
  /// distance from the wheel axis to the pin axis divided by the centre distance: sqrt(1 + s^2 - 2
  /// s cos theta)
  [[nodiscard]] double pin_distance_ratio(double driver_angle) const;

  /// theta* > 0 [rad], Eq. 5.33 and 5.34: the wheel's acceleration is greatest at -theta* and least
  /// at +theta*
  [[nodiscard]] double peak_acceleration_angle() const;

  /// Wheel speed [rad/s] for the driver speed [rad/s] at the driver angle [rad].
  [[nodiscard]] double wheel_speed(double driver_angle, double driver_speed) const;
  /// Wheel acceleration [rad/s^2] including the driver-acceleration term (the equation
  /// before 5.29).
  [[nodiscard]] double wheel_acceleration(double driver_angle, double driver_speed,
                                          double driver_acceleration) const;

 private:
  int stations_;
  double half_pitch_;
  double crank_ratio_;
};

/// The external Geneva with one pin as a mechanism; lengths follow from the centre distance.
/// @param stations 3..24
/// @param centre_distance c [m] between the driver's and the wheel's axis; the crank is c sin(pi/n)
/// @throws base::InputError outside that range, or if the distance is not positive
Mechanism external_geneva(int stations, double centre_distance);

}  // namespace geneva::loads
