#include "post/view/quantised.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geneva::post {

namespace {
constexpr std::uint16_t no_number = 65535;
constexpr double maximum_step = 65534.;
}  // namespace

Quantised quantised(const std::vector<float>& values) {
  Quantised result{0.F, 0.F, {}};
  bool is_first = true;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    result.low = is_first ? value : std::min(result.low, value);
    result.high = is_first ? value : std::max(result.high, value);
    is_first = false;
  }
  const double range = static_cast<double>(result.high) - result.low;
  for (const float value : values)
    result.steps.push_back(!std::isfinite(value) ? no_number
                           : range == 0.         ? std::uint16_t{0}
                                                 : static_cast<std::uint16_t>(std::lround(
                                                       maximum_step * (value - result.low) / range)));
  return result;
}

std::vector<float> restored(const Quantised& values) {
  std::vector<float> result;
  const double range = static_cast<double>(values.high) - values.low;
  for (const std::uint16_t step : values.steps)
    result.push_back(step == no_number
                         ? std::numeric_limits<float>::quiet_NaN()
                         : static_cast<float>(values.low + range * step / maximum_step));
  return result;
}

}  // namespace geneva::post
