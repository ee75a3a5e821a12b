#pragma once

#include "fem/problem.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Puts the problem's bodies in the order of the mesh's.
/// @throws std::invalid_argument if a body of the mesh has no material, or a material no body
void order_bodies(Problem<2>& problem, const mesh::MeshData<2>& mesh);

/// Checks that every name in the problem is in the mesh, that contact surfaces do not overlap and
/// that every body is held or touched.
/// @throws std::invalid_argument naming what is missing and what there is
void check(const Problem<2>& problem, const mesh::MeshData<2>& mesh);

}  // namespace geneva::fem
