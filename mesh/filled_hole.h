#pragma once

#include <string>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// Fills the round hole that a surface surrounds with quadrilaterals of the same body: a square
/// grid whose sides lie on the hole's boundary, which becomes a rounded square. The surface is no
/// boundary any more.
/// @param surface name of the hole's boundary: a closed chain of an even number of edges around one
/// centre, eight or more
/// @throws base::InputError if it is not
MeshData<2> with_filled_hole(const MeshData<2>& mesh, const std::string& surface);

}  // namespace geneva::mesh
