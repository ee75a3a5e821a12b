#pragma once

#include <filesystem>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// Reads a plane geometry (.geo, checked and meshed with quadrilaterals) or mesh (.msh, format 2.2
/// or 4.1).
///
/// Physical surfaces become bodies and physical curves become surfaces, by name. Curves that are
/// circles are found
/// (.geo: from the geometry; .msh: if all nodes, five at least, lie on one). Runs on one rank,
/// without MPI.
/// @param file the .geo or .msh file; what a .geo may hold: guard_geometry
/// @param length_unit metres per unit of length of the file, > 0
/// @throws std::invalid_argument naming the file and what is wrong: missing, commands that a
/// geometry may not hold, syntax error, no plane physical group, unnamed groups or a name used
/// twice, triangles, cells of order 2, cut short, bodies that share vertices, cells that no solver
/// can use
MeshData<2> read_geometry(const std::filesystem::path& file, double length_unit);

}  // namespace geneva::mesh
