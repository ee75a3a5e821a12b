#pragma once

#include <array>
#include <optional>

#include "fem/contact/contact_result.h"
#include "fem/problem/problem.h"
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

/// By component, the place of the plane of symmetry that bounds a contact there, or of the axis of
/// revolution [m]. The force of the whole contact has no such component: the other half or side has
/// the opposite one.
template <int dim>
std::array<std::optional<double>, static_cast<std::size_t>(dim)> mirrors(
    const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
    const ContactResult<dim>& contact);

}  // namespace geneva::fem
