#pragma once

#include <vector>

#include "loads/wheel/geneva_dimensions.h"
#include "loads/wheel/internal_dimensions.h"
#include "loads/wheel/local_outline.h"
#include "loads/wheel/outline.h"
#include "mesh/mesh_data.h"
#include "mesh/mesh_sizing.h"
#include "mesh/mesher.h"

namespace geneva::mesh {

/// Sizing that gives some 250 cells for a wheel of four stations and its pin, and 900 for 24
/// stations.
/// @param pin_distance wheel axis to pin axis [m]
MeshSizing default_sizing(const loads::GenevaDimensions& dimensions, double pin_distance);

/// The same for an internal wheel.
MeshSizing default_sizing(const loads::InternalDimensions& dimensions, double pin_distance);

/// Sizing that gives a few hundred cells for a pin on a block.
MeshSizing default_sizing(const loads::LocalDimensions& dimensions);

/// Meshes the outlines with all-quadrilateral cells; every segment's surface becomes a named
/// surface.
///
/// The vertices of the outlines are vertices of the mesh; boundary vertices lie on the lines and
/// circles to round-off. A ring (an outer loop and one hole, of the same number of arcs) becomes a
/// regular mesh of layers, a quadrilateral one of rows. The result does not depend on the unit of
/// length. Runs on one rank, without MPI.
/// @throws base::InputError if sizes or outlines are unfit: not positive, an open loop
/// @throws base::InputError if Gmsh fails or finds no mesh of good cells
/// @throws base::LimitReached if it takes more than `limits`
MeshData<2> mesh_outlines(const std::vector<loads::Outline>& outlines, const MeshSizing& sizing,
                          Mesher& mesher, const MesherLimits& limits);

}  // namespace geneva::mesh
