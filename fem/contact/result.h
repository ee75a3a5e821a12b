#pragma once

#include "fem/contact/active_set.h"
#include "fem/solution.h"

namespace geneva::fem {

/// The state of one contact pair in SI units, with its resultants.
ContactResult<2> contact_result(const ContactPair& pair, const ContactInterface<2>& interface,
                                const ContactState& state, const Scales& scales);

}  // namespace geneva::fem
