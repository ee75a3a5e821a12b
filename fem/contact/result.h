#pragma once

#include <array>
#include <optional>

#include "fem/contact/contact_result.h"
#include "fem/contact/interface.h"
#include "fem/problem/scaling.h"

namespace geneva::fem {

/// The state of one contact pair in SI units, with its resultants.
template <int dim>
ContactResult<dim> contact_result(const ContactPair& pair, const ContactInterface<dim>& interface,
                                  const ContactState& state, const Scales& scales);

/// Counts the half-width of intervals with one free end from the plane of symmetry or axis of
/// revolution that the other lies on, whatever the pressure there is.
/// @param places of the planes normal to x and y [m]
/// @param size of the model [m]
void count_from_mirrors(ContactResult<2>& contact,
                        const std::array<std::optional<double>, 2>& places, double size);

}  // namespace geneva::fem
