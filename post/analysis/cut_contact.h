#pragma once

#include <optional>

#include "fem/contact/contact_result.h"
#include "fem/solution.h"

namespace geneva::post {

/// The axis along which the source's surface ends amid the pressure of a contact of curved
/// surfaces, where no plane of symmetry bounds it: as if the bodies were cut there.
/// @return 0, 1, 2: x, y, z; none if it does nowhere
template <int dim>
std::optional<unsigned int> cut_axis(const fem::Solution<dim>& solution,
                                     const fem::ContactResult<dim>& contact);

}  // namespace geneva::post
