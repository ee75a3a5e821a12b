#pragma once

#include <filesystem>
#include <vector>

#include "loads/outline.h"
#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// How fine the coarse mesh of an outline is.
struct MeshSizing {
  double general;           ///< target cell size away from the contact [m]
  double at_contact;        ///< target cell size at the contact [m]
  loads::Point contact;     ///< where the bodies touch [m]
  double contact_distance;  ///< cells grow from at_contact to general over this distance [m]
};

/// Sizing that gives a few hundred cells for a Geneva wheel and its pin.
MeshSizing default_sizing(const loads::GenevaDimensions &dimensions, double pin_distance);

/// Meshes the outlines with all-quadrilateral cells; every segment's surface becomes a named surface.
/// @throws std::runtime_error if Gmsh fails
MeshData mesh_outlines(const std::vector<loads::Outline> &outlines, const MeshSizing &sizing);

/// Reads a plane geometry (.geo, run through Gmsh in a sandbox of refused commands) or mesh (.msh).
///
/// Physical surfaces become bodies and physical curves become surfaces, by name. Triangles are recombined (.geo) or
/// refused (.msh).
/// @param file the .geo or .msh file
/// @param length_unit metres per unit of length of the file, > 0
/// @throws std::invalid_argument naming the file and what is wrong: missing, commands that a geometry may not hold,
/// syntax error, no plane physical group, unnamed groups, triangles, cells of order 2, cut short, bodies that share
/// vertices
MeshData read_geometry(const std::filesystem::path &file, double length_unit);

}  // namespace geneva::mesh
