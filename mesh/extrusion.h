#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// How a plane body becomes one in 3-D.
struct Extrusion {
  std::vector<double> planes;  ///< z of the layers' boundaries, two or more, ascending [m]
  std::string lower_end;       ///< surface at the first plane; may be ""
  std::string upper_end;       ///< surface at the last plane; may be ""
};

/// Draws every body of a plane mesh out along z: quadrilaterals become columns of hexahedra, edges
/// of the boundary strips of faces of the same surface and circle.
/// @param bodies one for each body of the mesh
/// @param grading of the layers that refinement makes between the planes
/// @throws base::InputError if their number differs, or if planes are fewer than two or do not
/// ascend
MeshData<3> extruded(const MeshData<2>& plane, const std::vector<Extrusion>& bodies,
                     const std::optional<Grading>& grading = std::nullopt);

}  // namespace geneva::mesh
