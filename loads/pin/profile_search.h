#pragma once

#include <functional>
#include <vector>

#include "loads/pin/pin_line.h"

namespace geneva::loads {

/// What a profile of a pin, of which one size is to be found, has to bear.
struct ProfileDuty {
  PinLine pin;                                     ///< but for its profile
  std::function<PinProfile(double size)> profile;  ///< of a size [m]
  double first_size;                               ///< where the search begins [m]
  double least_size;                               ///< that is allowed [m]
  std::vector<double> tilts;                       ///< in place of the pin's own, one or more [rad]
  double force;                                    ///< the greatest; the pressure rises with it [N]
};

/// A size that was tried.
struct ProfileTrial {
  double size;        ///< [m]
  double line_load;   ///< maximum over all tilts, mean over a twentieth of the length [N/m]
  double worst_tilt;  ///< of that [rad]
};

/// The size of the least maximum line load, and those that were tried.
struct ProfileSearch {
  ProfileTrial best;
  std::vector<ProfileTrial> trials;  ///< in their order
};

/// The pin of a duty with that size and tilt.
PinLine pin_of(const ProfileDuty& duty, double size, double tilt);

/// A scan by equal factors, then Brent's method (1973), both over the size's logarithm.
/// @throws base::InputError where pin_line_contact() does
ProfileSearch find_profile(const ProfileDuty& duty);

/// Contact pressure over sizes and tilts.
struct ProfileMap {
  std::vector<double> sizes;                   ///< ascending [m]
  std::vector<double> tilts;                   ///< [rad]
  std::vector<std::vector<double>> pressures;  ///< of the maximum line load, by tilt and size [Pa]
};

/// Around a size, by equal factors, over the range of the duty's tilts.
/// @throws base::InputError where pin_line_contact() does
ProfileMap map_around(const ProfileDuty& duty, double size);

}  // namespace geneva::loads
