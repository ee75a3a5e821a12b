#include "loads/synthesis/quick_return.h"

#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

QuickReturn quick_return(const QuickReturnInput& input) {
  const int z = require_stations(input.stations);
  require_positive("maximum wheel speed", input.maximum_wheel_speed, "rad/s");
  if (input.crank.has_value() == input.centre_distance.has_value())
    throw base::InputError(
        input.crank ? "crank AB and centre distance AD are both given: AB/AD = sin(pi/z) fixes one "
                      "by the other; give only one of them"
                    : "neither crank AB nor centre distance AD is given: the size of the mechanism "
                      "is open; give one of them");
  const double ratio = std::sin(pi / z);
  if (input.crank) require_positive_length("crank AB", *input.crank);
  if (input.centre_distance) require_positive_length("centre distance AD", *input.centre_distance);
  const double crank = input.crank ? *input.crank : *input.centre_distance * ratio;
  const double distance = input.crank ? *input.crank / ratio : *input.centre_distance;
  return {z, crank, distance, input.maximum_wheel_speed * (1. - ratio) / ratio,
          (z - 2.) / (z + 2.)};
}

QuickReturnPosition position(const QuickReturn& mechanism, double crank_angle) {
  require_finite("crank angle", crank_angle * 180. / pi, "deg");
  const double ab = mechanism.crank;
  const double ad = mechanism.centre_distance;
  const double across = ab * std::sin(crank_angle);
  // AD - AB cos(theta), written so that nothing cancels where B is near D
  const double half_sine = std::sin(crank_angle / 2.);
  const double along = (ad - ab) + 2. * ab * half_sine * half_sine;
  const double slider = std::hypot(across, along);
  const double rocker_ratio = ab * (ad * std::cos(crank_angle) - ab) / (slider * slider);
  const double slider_ratio = ad * across / slider;
  return {crank_angle, std::atan2(across, along), slider, mechanism.crank_speed * rocker_ratio,
          mechanism.crank_speed * slider_ratio};
}

QuickReturnExtremes extreme_positions(const QuickReturn& mechanism) {
  const double perpendicular = pi / 2. - pi / mechanism.stations;
  return {position(mechanism, 0.), position(mechanism, pi), position(mechanism, -perpendicular),
          position(mechanism, perpendicular)};
}

}  // namespace geneva::loads
