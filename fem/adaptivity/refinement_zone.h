#pragma once

#include <deal.II/dofs/dof_handler.h>

#include <utility>
#include <vector>

#include "fem/contact/active_set.h"
#include "fem/contact/zone.h"

namespace geneva::fem {

/// Boundary ids (source, target) of the interfaces.
using SurfaceIds = std::vector<std::pair<unsigned int, unsigned int>>;

/// Which cells along a contact zone.
enum class ZonePart {
  all,
  uneven,  ///< in the plane whose edges are long beside the shortest of their side, or all of a
           ///< side whose edges are too long beside the other's; in 3-D of lower levels than the
           ///< highest of their side
  longest  ///< in the plane whose edges are about as long as the longest of the zone, in 3-D all
};

/// Flags this rank's cells along the contact zones, which reach a quarter of the contact's width
/// beyond its ends.
/// @return their number
unsigned int flag_zone(dealii::DoFHandler<2>& dof_handler,
                       const std::vector<ContactInterface<2>>& interfaces,
                       const SurfaceIds& surface_ids, ZonePart part);
unsigned int flag_zone(dealii::DoFHandler<3>& dof_handler,
                       const std::vector<ContactInterface<3>>& interfaces,
                       const SurfaceIds& surface_ids, ZonePart part);

}  // namespace geneva::fem
