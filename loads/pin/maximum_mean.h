#pragma once

#include <algorithm>
#include <vector>

namespace geneva::loads {

/// Maximum mean line load over a length.
struct MaximumMean {
  double value;  ///< [N/m]
  double place;  ///< middle of that length along z [m]
};

/// @param places where the line load bends or jumps, ascending [m]
/// @param load_up_to place [m] -> load [N] below it; 0 before the first place
/// @param length [m], > 0
template <typename LoadUpTo>
MaximumMean maximum_mean(const std::vector<double>& places, const LoadUpTo& load_up_to,
                         const double length) {
  MaximumMean maximum{0., 0.};
  if (places.empty()) return maximum;
  const double last_start = std::max(places.front(), places.back() - length);
  // a mean is greatest around a peak, or where the window begins or ends at an end of the load
  for (const double place : places)
    for (const double anywhere : {place, place - length / 2., place - length}) {
      const double start = std::clamp(anywhere, places.front(), last_start);
      const double mean = (load_up_to(start + length) - load_up_to(start)) / length;
      if (mean > maximum.value) maximum = {mean, start + length / 2.};
    }
  return maximum;
}

}  // namespace geneva::loads
