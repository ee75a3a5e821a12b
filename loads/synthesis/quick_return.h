#pragma once

#include <optional>

namespace geneva::loads {

/// What is known of the Geneva mechanism that a quick-return mechanism shall replace.
struct QuickReturnInput {
  int stations;                           ///< z, 3..24
  double maximum_wheel_speed;             ///< omega_4max > 0 [rad/s]
  std::optional<double> crank;            ///< AB [m]; exactly one of this and the next
  std::optional<double> centre_distance;  ///< AD [m]
};

/// Crank-slider-rocker mechanism that moves like an external Geneva while the pin is in the slot
/// (Lecture 4): crank AB about A, slider on the pin B, rocker DB about D.
///
/// The crank angle theta is measured from AD, the rocker angle phi from DA in the sense of the
/// Geneva wheel's rotation, both as in ExternalGeneva; the lecture's angles are phi_2 = pi/2 +
/// theta and phi_4 = -pi/2 - phi.
struct QuickReturn {
  int stations;
  double crank;            ///< AB = AD sin(pi/z) [m]
  double centre_distance;  ///< AD [m]
  double crank_speed;      ///< omega_2 = omega_4max (AD - AB)/AB [rad/s]
  double motion_ratio;     ///< k_t = (z - 2)/(z + 2) of the Geneva: motion time over dwell time
};

/// Position and rates at one crank angle, any within the whole revolution.
struct QuickReturnPosition {
  double crank_angle;      ///< theta [rad]
  double rocker_angle;     ///< phi [rad], at most pi/z to either side
  double slider_distance;  ///< S = DB [m]
  double rocker_speed;     ///< omega_4 [rad/s], positive in the Geneva wheel's sense
  double slider_speed;     ///< dS/dt [m/s], positive away from D
};

/// The four extreme positions (Lecture 4).
struct QuickReturnExtremes {
  QuickReturnPosition slider_nearest;   ///< crank in line, towards D: S = AD - AB, omega_4max
  QuickReturnPosition slider_farthest;  ///< crank in line, away from D: S = AD + AB
  QuickReturnPosition rocker_first;     ///< crank perpendicular to the rocker, phi = -pi/z
  QuickReturnPosition rocker_last;      ///< the same, phi = +pi/z
};

/// @throws base::InputError if the stations are not 3..24, the speed is not positive and
/// finite, or not exactly one length, positive and finite, is given
QuickReturn quick_return(const QuickReturnInput& input);

/// The loop AB = AD + s (Lecture 4) solved for phi and S, and its derivative for the rates: S phi'
/// and S' are the components of the pin's velocity across and along the rocker. The lecture's speed
/// equations lack the slider's own speed and hold where it is at rest only.
/// @throws base::InputError unless the crank angle is finite
QuickReturnPosition position(const QuickReturn& mechanism, double crank_angle);

/// Extremes of S where the crank is in line with AD, of phi where it is perpendicular to the
/// rocker: cos(theta) = AB/AD.
QuickReturnExtremes extreme_positions(const QuickReturn& mechanism);

}  // namespace geneva::loads
