#pragma once

#include <optional>

#include "fem/problem.h"
#include "fem/solution.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Place along an axis of the plane of symmetry that bounds a contact there: supports hold both of
/// its bodies on one plane normal to the axis, in that direction only, and the contact's nodes end
/// on it.
/// @param axis 0, 1, 2: x, y, z
/// @return [m]; nothing if there is none
std::optional<double> symmetry_plane(const mesh::MeshData<3>& mesh, const Problem<3>& problem,
                                     const ContactResult<3>& contact, unsigned int axis);

}  // namespace geneva::fem
