#pragma once

#include <vector>

#include "loads/wheel/outline.h"
#include "mesh/mesh_data.h"
#include "mesh/mesh_sizing.h"

namespace geneva::mesher {

using mesh::MeshData;
using mesh::MeshSizing;

/// Meshes outlines with Gmsh, see mesh::mesh_outlines; sizes and loops have been checked.
/// @throws std::runtime_error if Gmsh fails or finds no mesh of good cells
MeshData<2> mesh_outlines(const std::vector<loads::Outline>& outlines, const MeshSizing& sizing);

}  // namespace geneva::mesher
