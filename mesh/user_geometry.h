#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh_data.h"
#include "mesh/mesher.h"
#include "mesh/mesher_exchange.h"

namespace geneva::mesh {

/// A file of the user's, and what a case says of it.
struct UserGeometry {
  std::filesystem::path file;  ///< may read others of its directory
  double length_unit;          ///< metres per unit of length of the file, > 0
  double circle_tolerance;     ///< how far points of a nearly round curve or surface may be off,
                               ///< as a share of the radius, >= 0
  std::vector<std::string> bodies = {};  ///< of a STEP file those that are wanted; none: all
  std::vector<Pick> picks = {};          ///< names for places of a STEP file
  std::optional<double> cell_size = {};  ///< of its coarse cells [m]; none: what suits each body
};

/// Reads a geometry (.geo, meshed with quadrilaterals, in 3-D with hexahedra as it
/// says itself), mesh (.msh, format 2.2 or 4.1), or parts of a CAD system (.step, .stp).
///
/// In the plane physical surfaces become bodies and physical curves become surfaces, by name; in
/// 3-D physical volumes become bodies and physical surfaces become surfaces. Curves that are
/// circles, surfaces that are parts of cylinders or spheres are found (.geo: from the geometry;
/// .msh: if all nodes, five on a curve and ten on a surface at least, lie on one). Nodes of nearly
/// round ones are moved onto the nearest circle, cylinder or sphere. Runs on one rank, without MPI.
///
/// Triangles are divided into three quadrilaterals, tetrahedra into four hexahedra and prisms into
/// six, with all other cells of the mesh; cells of order 2 keep their middle nodes then.
///
/// Of a STEP file solids are bodies, by the name of their product ("pin 2" where several have it),
/// faces are surfaces by their name, behind that of their body where two bodies have it; in the
/// plane faces are bodies and edges surfaces. Picks name what has no name. Length are those of the
/// file, whose unit it knows: `length_unit` is 1.
/// @throws base::InputError naming the file and what is wrong: missing, commands that a
/// geometry may not hold (check_geometry), syntax error, no physical group, unnamed groups or a
/// name used twice, pyramids or cells of order 3, cut short, bodies that share vertices,
/// cells that no solver can use, a crash of Gmsh
/// @throws base::LimitReached if Gmsh takes more than `limits`
template <int dim>
MeshData<dim> read_geometry(const UserGeometry& geometry, Mesher& mesher,
                            const MesherLimits& limits);

}  // namespace geneva::mesh
