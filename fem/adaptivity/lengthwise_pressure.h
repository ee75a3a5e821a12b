#pragma once

#include <optional>

#include "fem/contact/contact_result.h"

namespace geneva::fem {

/// Maximum pressures [Pa] of a contact along its length, which is that in z.
struct LengthwisePressure {
  double middle = 0.;  ///< in the middle half of the length
  double end = 0.;     ///< at its two ends
};

/// @param middle plane of symmetry across the length, if there is one: else the middle of the nodes
LengthwisePressure lengthwise_pressure(const ContactResult<3>& contact,
                                       const std::optional<double>& middle);

}  // namespace geneva::fem
