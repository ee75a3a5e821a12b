#pragma once

#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// Cuts cells that are long beside their depth along some surfaces, or deep beside their length, so
/// that all are about square there.
///
/// Refinement keeps the proportions of a coarse cell. Under a contact, cells several times as long
/// as deep make neighbouring pressures differ and the convergence slow. An edge is cut together
/// with all that lie opposite to it across a cell, from cell to cell, so that the cells still meet
/// edge to edge; new points lie on the circles of the boundary.
/// @param mesh checked
/// @param surfaces names; those that are not in the mesh are left out
MeshData<2> with_compact_cells(const MeshData<2>& mesh, const std::vector<std::string>& surfaces);

}  // namespace geneva::mesh
