#include "loads/motion/spherical_geneva.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

Mechanism spherical_geneva(const int stations, const double shaft_angle, const double radius) {
  require_stations(stations);
  require_positive_length("sphere radius", radius);
  if (!(shaft_angle > 0. && shaft_angle < pi))
    throw base::InputError(
        fmt::format("shaft angle is {:.6g} deg: the pin's cone about the driver's axis closes from "
                    "0 to 180 deg only, both left out (there the axes are parallel: take an "
                    "external or internal Geneva)",
                    shaft_angle * 180. / pi));
  const double sine = std::sin(shaft_angle);
  const double cosine = std::cos(shaft_angle);
  const double sine_p = sine * std::sin(pi / stations);
  const double cosine_p = std::sqrt(1. - sine_p * sine_p);
  const auto motion = [=](const double driver_angle) {
    // The pin's direction; z is the wheel's axis, the driver's axis lies in the plane y = 0.
    const Jet angle = variable(driver_angle);
    const Jet x = cosine_p * sine - (sine_p * cosine) * cos(angle);
    const Jet y = sine_p * sin(angle);
    const Jet z = cosine_p * cosine + (sine_p * sine) * cos(angle);
    const Jet distance = sqrt(x * x + y * y);
    // From the driver's axis to the direction along the slot, seen along the pin's own axis.
    const Jet turn = atan2(sine * y, sine * (z * x) - cosine * (distance * distance));
    return SlotMotion{atan2(y, x), radius * distance, radius * atan2(distance, z), turn, z.value};
  };
  const double exit = std::acos(sine_p / cosine_p * cosine / sine);
  return {fmt::format("spherical Geneva with {} stations and a shaft angle of {:.6g} deg", stations,
                      shaft_angle * 180. / pi),
          stations,
          2. * pi,
          -exit,
          exit,
          {},
          motion};
}

}  // namespace geneva::loads
