#include "fem/adaptivity/lengthwise_pressure.h"

#include <algorithm>
#include <cmath>

namespace geneva::fem {

LengthwisePressure lengthwise_pressure(const ContactResult<3>& contact,
                                       const std::optional<double>& middle) {
  constexpr double same = 1e-9;
  const auto [lowest, highest] = std::minmax_element(
      contact.nodes.begin(), contact.nodes.end(),
      [](const auto& a, const auto& b) { return a.position[2] < b.position[2]; });
  const double centre = middle.value_or((lowest->position[2] + highest->position[2]) / 2.);
  const double half = std::max(highest->position[2] - centre, centre - lowest->position[2]);
  LengthwisePressure maximum;
  for (const ContactNode<3>& node : contact.nodes) {
    const double share = std::abs(node.position[2] - centre) / half;
    if (share <= 0.5 * (1. + same)) maximum.middle = std::max(maximum.middle, node.pressure);
    if (share >= 1. - same) maximum.end = std::max(maximum.end, node.pressure);
  }
  return maximum;
}

}  // namespace geneva::fem
