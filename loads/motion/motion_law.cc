#include "loads/motion/motion_law.h"

#include <fmt/format.h>

#include <limits>

#include "base/errors.h"
#include "loads/pi.h"

namespace geneva::loads {

namespace {

void check_relative_time(const double relative_time, const double maximum) {
  if (relative_time >= 0. && relative_time <= maximum) return;
  throw base::InputError(
      fmt::format("relative time of the motion law is {:.6g}: the law is given from 0 to {:.6g}; "
                  "choose a time within the motion",
                  relative_time, maximum));
}

/// A/k^3 of the cycloidal law, from its series where the difference of the two terms cancels.
double cycloid_over_cube(const double k) {
  const double x = 2. * pi * k;
  const double cube = 8. * pi * pi * pi / (2. * pi);
  if (x > 0.5) return (k - std::sin(x) / (2. * pi)) / (k * k * k);
  double term = 1. / 6.;
  double sum = term;
  for (int i = 1; i < 8; ++i) {
    term *= -x * x / ((2. * i + 2.) * (2. * i + 3.));
    sum += term;
  }
  return cube * sum;
}

}  // namespace

Jet progress(const MotionLaw law, const double relative_time) {
  check_relative_time(relative_time, 1.);
  const double k = relative_time;
  if (law == MotionLaw::harmonic) return 0.5 - 0.5 * cos(pi * variable(k));
  // 1 - cos(2 pi k) = 2 sin^2(pi k), so that nothing cancels at the start
  const double sine = std::sin(pi * k);
  const double value =
      k < 0.5 ? cycloid_over_cube(k) * k * k * k : k - std::sin(2. * pi * k) / (2. * pi);
  return {value, 2. * sine * sine, 2. * pi * std::sin(2. * pi * k),
          4. * pi * pi * std::cos(2. * pi * k)};
}

Jet root_of_progress(const MotionLaw law, const double relative_time) {
  check_relative_time(relative_time, 0.5);
  if (law == MotionLaw::harmonic) return sin(pi / 2. * variable(relative_time));
  const double infinite = std::numeric_limits<double>::infinity();
  if (relative_time == 0.) return {0., 0., infinite, -infinite};
  return sqrt(progress(law, relative_time));
}

bool has_smooth_root(const MotionLaw law) { return law == MotionLaw::harmonic; }

}  // namespace geneva::loads
