#pragma once

#include <vector>

#include "fem/boundary_tractions.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Why the stress of linear elasticity has no bound at a place.
enum class Singularity {
  end_of_support,    ///< a support or rigid tie ends where the surface beside it is free
  re_entrant_corner  ///< a sharp corner or edge that points into the body
};

/// A vertex of the coarse mesh, in 3-D an edge, with unbounded stress, and how far around it
/// stresses are left out: as far as the coarse cells reach there. SI units.
template <int dim>
struct SingularPlace {
  Components<dim> begin, end;  ///< the same in the plane
  double radius;
  Singularity why;
  unsigned int surface;  ///< that is held, or one at the corner; index into MeshData::surfaces
};

/// @param tractions of the same mesh
template <int dim>
std::vector<SingularPlace<dim>> singular_places(const mesh::MeshData<dim>& mesh,
                                                const BoundaryTractions<dim>& tractions);

}  // namespace geneva::fem
