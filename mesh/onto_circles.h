#pragma once

#include <set>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// Makes the faces of the tori among some circles flat pieces.
/// @param circles indices into MeshData::circles
/// @return whether there were any
template <int dim>
bool flatten_tori(MeshData<dim>& mesh, const std::set<int>& circles);

/// Moves the vertices of the faces that belong to some circles (in 3-D cylinders, spheres and tori)
/// onto them by the shortest way; where a flat face ends there, along that face, and where another
/// circle ends there, onto both. Tori on which that cannot be done become flat pieces.
/// @param circles indices into MeshData::circles
/// @throws base::InputError naming the place of a vertex whose circles do not meet near to it
template <int dim>
void move_onto_circles(MeshData<dim>& mesh, const std::set<int>& circles);

}  // namespace geneva::mesh
