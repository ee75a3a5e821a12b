#pragma once

#include <vector>

#include "fem/body_strength.h"
#include "fem/contacts_own_field.h"
#include "fem/singular_places.h"
#include "fem/solution.h"
#include "fem/stress_recovery.h"

namespace geneva::fem {

/// By body, outside of the contacts' own field and of the surroundings of singular places: the
/// maxima at the nodes; in the plane, where a node of the boundary is it, the top of the parabola
/// through its neighbours along the boundary. Their error is what the recovery of the stress leaves
/// on this mesh.
template <int dim>
std::vector<BodyStrength<dim>> strength(const Solution<dim>& solution,
                                        const NodalStress<dim>& stress,
                                        const std::vector<SingularPlace<dim>>& singular);

}  // namespace geneva::fem
