#pragma once

#include "mesh/mesher_exchange.h"

namespace geneva::mesher {

/// Reads the parts of a STEP file into Gmsh's current model, in millimetres, with a physical group
/// for each body and each named surface.
///
/// Bodies share nothing, also where they touch.
/// @throws base::InputError where the CAD room does
template <int dim>
void read_step_model(const mesh::GeometryTask& task);

/// Meshes it with triangles or tetrahedra of order 2, which follow its curved faces: coarse, a
/// quarter turn with three cells at least.
/// @param cell_size of the quadrilaterals and hexahedra that they are divided into [mm]; 0: a
/// sixth of each body's mean extent
/// @param factor on all sizes, 1 or less
template <int dim>
void mesh_step_model(double cell_size, double factor);

}  // namespace geneva::mesher
