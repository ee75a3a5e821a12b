#pragma once

#include <Eigen/Core>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// Place of a vertex [m]; in the plane z = 0.
template <int dim>
Eigen::Vector3d place_of(const MeshData<dim>& mesh, unsigned int vertex);

/// Unit normal of a face as if it were flat: to the right of an edge; of a quadrilateral that of
/// its diagonals.
template <int dim>
Eigen::Vector3d flat_normal(const MeshData<dim>& mesh, const Face<dim>& face);

}  // namespace geneva::mesh
