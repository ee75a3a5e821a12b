#pragma once

#include <array>
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
template <int dim>
std::optional<double> symmetry_plane(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                                     const ContactResult<dim>& contact, unsigned int axis);

/// By component, whether the force of a contact has none for the whole: along the normal of a plane
/// of symmetry the other half has the opposite one, around an axis of revolution the other side.
template <int dim>
std::array<bool, static_cast<std::size_t>(dim)> lateral_directions(
    const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
    const ContactResult<dim>& contact);

}  // namespace geneva::fem
