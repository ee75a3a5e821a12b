#pragma once

#include <string>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// Maximum angle [rad] between the normals of neighbouring flat faces of a surface, as a polygon
/// that stands for an arc has them. Below 0.01 degrees they count as one plane, above 46 degrees as
/// a corner that is meant.
/// @return 0 if there are none
template <int dim>
double maximum_kink(const MeshData<dim>& mesh, const std::string& surface);

}  // namespace geneva::mesh
