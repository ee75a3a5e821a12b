#pragma once

#include <filesystem>

#include "mesh/mesh_data.h"
#include "mesh/mesher.h"

namespace geneva::mesh {

/// Reads a geometry (.geo, meshed with quadrilaterals, in 3-D with hexahedra as it
/// says itself) or mesh (.msh, format 2.2 or 4.1).
///
/// In the plane physical surfaces become bodies and physical curves become surfaces, by name; in
/// 3-D physical volumes become bodies and physical surfaces become surfaces. Curves that are
/// circles, surfaces that are parts of cylinders or spheres are found (.geo: from the geometry;
/// .msh: if all nodes, five on a curve and ten on a surface at least, lie on one). Nodes of nearly
/// round ones are moved onto the nearest circle, cylinder or sphere. Runs on one rank, without MPI.
/// @param file the .geo or .msh file, which may read others of its directory
/// @param length_unit metres per unit of length of the file, > 0
/// @param circle_tolerance how far points of a nearly round curve or surface may be off, as a share
/// of the radius, >= 0
/// @throws base::InputError naming the file and what is wrong: missing, commands that a
/// geometry may not hold (check_geometry), syntax error, no physical group, unnamed groups or a
/// name used twice, cells of other shapes or of order 2, cut short, bodies that share vertices,
/// cells that no solver can use, a crash of Gmsh
/// @throws base::LimitReached if Gmsh takes more than `limits`
template <int dim>
MeshData<dim> read_geometry(const std::filesystem::path& file, double length_unit,
                            double circle_tolerance, Mesher& mesher, const MesherLimits& limits);

}  // namespace geneva::mesh
