#pragma once

#include "fem/problem.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Puts the problem's bodies in the order of the mesh's.
/// @throws base::InputError if a body of the mesh has no material, or a material no body
template <int dim>
void order_bodies(Problem<dim>& problem, const mesh::MeshData<dim>& mesh);

/// Checks that every name in the problem is in the mesh, that contact surfaces do not overlap and
/// that every body is held or touched.
/// @throws base::InputError naming what is missing and what there is
template <int dim>
void check(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh);

}  // namespace geneva::fem
