#pragma once

#include <string>

#include "fem/solution.h"

namespace geneva::post {

/// Why Hertz's closed form is left out beside a contact of curved surfaces: it wants one parabola
/// of the gap (K. L. Johnson 1985, section 4.1), so that the curvatures may not change within the
/// contact, and where one surface encloses the other the contact must be narrow.
/// @param half_width of the contact [m]
/// @return empty if nothing is said against it
template <int dim>
std::string hertz_objection(const fem::Solution<dim>& solution,
                            const fem::ContactResult<dim>& contact, double half_width);

}  // namespace geneva::post
