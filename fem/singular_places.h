#pragma once

#include <deal.II/base/point.h>

#include <vector>

#include "fem/adaptivity/level_record.h"
#include "fem/body_strength.h"
#include "fem/boundary_tractions.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// @param tractions of the same mesh
template <int dim>
std::vector<SingularPlace<dim>> singular_places(const mesh::MeshData<dim>& mesh,
                                                const BoundaryTractions<dim>& tractions);

/// Corners of the coarse mesh, on no round surface, at which a maximum stress has grown by a tenth
/// or more over each of three refinements, the last hardly less than the first: as the power of the
/// cells' size that a singular stress is, which no mesh resolves. Such as a corner that only a
/// plane of symmetry makes re-entrant.
/// @param history the newest last
template <int dim>
std::vector<SingularPlace<dim>> grown_places(const mesh::MeshData<dim>& mesh,
                                             const std::vector<LevelRecord>& history);

/// Whether a place [m] is in the surroundings of any of them.
template <int dim>
bool is_beside(const std::vector<SingularPlace<dim>>& singular, const dealii::Point<dim>& place);

/// Whether a maximum there [m] stands clear of what is left out around them. Else it depends on how
/// far that reaches, and no mesh makes it certain.
template <int dim>
bool is_clear(const std::vector<SingularPlace<dim>>& singular, const Components<dim>& place);

}  // namespace geneva::fem
