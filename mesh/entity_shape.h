#pragma once

#include <optional>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// The circle of a curve of Gmsh's current model; in space the cylinder or sphere of a surface. It
/// is found in points of the geometry, or in the nodes of a mesh.
/// @param entity Gmsh's tag of the curve or surface
/// @return nothing if it has another shape
template <int dim>
std::optional<Circle> shape_of(int entity);

}  // namespace geneva::mesh
