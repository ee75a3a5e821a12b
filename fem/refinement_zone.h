#pragma once

#include <deal.II/dofs/dof_handler.h>

#include <utility>
#include <vector>

#include "fem/contact/active_set.h"

namespace geneva::fem {

/// Boundary ids (source, target) of the interfaces.
using SurfaceIds = std::vector<std::pair<unsigned int, unsigned int>>;

/// Flags this rank's cells along the contact zones, which reach a quarter of the contact's width
/// beyond its ends.
/// @param only_uneven in the plane only those whose edges are long beside the shortest of their
/// zone, in space those of lower levels than the highest of their side
/// @return their number
unsigned int flag_zone(dealii::DoFHandler<2>& dof_handler,
                       const std::vector<ContactInterface<2>>& interfaces,
                       const SurfaceIds& surface_ids, bool only_uneven);
unsigned int flag_zone(dealii::DoFHandler<3>& dof_handler,
                       const std::vector<ContactInterface<3>>& interfaces,
                       const SurfaceIds& surface_ids, bool only_uneven);

}  // namespace geneva::fem
