#include "loads/motion/internal_geneva.h"

#include <fmt/format.h>

#include <cmath>

#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

Mechanism internal_geneva(const int stations, const double centre_distance) {
  require_stations(stations);
  require_positive_length("centre distance", centre_distance);
  const double crank = centre_distance * std::sin(pi / stations);
  const auto motion = [=](const double driver_angle) {
    const Jet angle = variable(driver_angle);
    return slot_motion(centre_distance + crank * cos(angle), crank * sin(angle), -angle);
  };
  const double exit = pi / 2. + pi / stations;
  return {fmt::format("internal Geneva with {} stations", stations),
          stations,
          2. * pi,
          -exit,
          exit,
          {},
          motion};
}

}  // namespace geneva::loads
