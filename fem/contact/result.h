#pragma once

#include "fem/contact/active_set.h"
#include "fem/solution.h"

namespace geneva::fem {

/// The state of one contact pair in SI units, with its resultants.
template <int dim>
ContactResult<dim> contact_result(const ContactPair& pair, const ContactInterface<dim>& interface,
                                  const ContactState& state, const Scales& scales);

}  // namespace geneva::fem
