#include "loads/engagement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

void check_motion(const DriverMotion& motion) {
  require_positive("driver speed", motion.speed, "rad/s");
  require_finite("driver acceleration", motion.acceleration, "rad/s^2");
}

void check_driver_angle(const ExternalGeneva& geneva, double driver_angle) {
  const double limit = geneva.engagement_angle();
  // a few roundings of a right angle, so that -(pi/2 - pi/n) formed elsewhere is still accepted
  if (std::abs(driver_angle) <= limit + 1e-12) return;
  const double degree = pi / 180.;
  throw std::invalid_argument(fmt::format(
      "driver angle is {0:.6g} deg: with {1} stations the pin is in the slot from -{2:.6g} deg to "
      "{2:.6g} deg; choose an angle in this range",
      driver_angle / degree, geneva.stations(), limit / degree));
}

/// A positive multiple of dF/dtheta, with F = (J a + M_f)/x and x dx/dtheta = c^2 s sin(theta).
double force_slope(const ExternalGeneva& geneva, const DriverMotion& motion, double inertia,
                   double friction_moment, double angle) {
  const double moment =
      inertia * geneva.wheel_acceleration(angle, motion.speed, motion.acceleration) +
      friction_moment;
  const double moment_slope = inertia * (motion.speed * motion.speed * geneva.jerk_ratio(angle) +
                                         motion.acceleration * geneva.acceleration_ratio(angle));
  const double distance = geneva.pin_distance_ratio(angle);
  return moment_slope * distance * distance - moment * geneva.crank_ratio() * std::sin(angle);
}

}  // namespace

PinLoad pin_load(const ExternalGeneva& geneva, double centre_distance, const DriverMotion& motion,
                 double wheel_inertia, const WheelLoad& load, double driver_angle) {
  require_positive_length("centre distance", centre_distance);
  check_motion(motion);
  check_driver_angle(geneva, driver_angle);
  const double acceleration =
      geneva.wheel_acceleration(driver_angle, motion.speed, motion.acceleration);
  const double distance = centre_distance * geneva.pin_distance_ratio(driver_angle);
  return {driver_angle,
          geneva.wheel_angle(driver_angle),
          geneva.wheel_speed(driver_angle, motion.speed),
          acceleration,
          distance,
          pin_force(wheel_inertia, load, acceleration, distance)};
}

double peak_force_angle(const ExternalGeneva& geneva, double centre_distance,
                        const DriverMotion& motion, double wheel_inertia, const WheelLoad& load) {
  require_positive("wheel inertia", wheel_inertia, "kg m^2");
  // A decelerating driver can make two maxima: find the greater one on a grid, much finer than the
  // sharpest peak (n = 3, 4 deg from the line of centres), then the zero of the slope beside it.
  const int intervals = 1000;
  const double limit = geneva.engagement_angle();
  const auto grid = [&](int i) { return limit * (2. * i / intervals - 1.); };
  int best = 0;
  double greatest = -HUGE_VAL;
  for (int i = 0; i <= intervals; ++i) {
    const double force =
        pin_load(geneva, centre_distance, motion, wheel_inertia, load, grid(i)).force;
    if (force > greatest) {
      greatest = force;
      best = i;
    }
  }
  const auto slope = [&](double angle) {
    return force_slope(geneva, motion, wheel_inertia + load.load_inertia, load.friction_moment,
                       angle);
  };
  double before = grid(std::max(best - 1, 0));
  double after = grid(std::min(best + 1, intervals));
  if (slope(before) <= 0.) return before;  // greatest at entry
  if (slope(after) >= 0.) return after;    // greatest at exit
  while (after - before > 1e-12) {
    const double middle = (before + after) / 2.;
    (slope(middle) > 0. ? before : after) = middle;
  }
  return (before + after) / 2.;
}

}  // namespace geneva::loads
