#pragma once

#include "fem/problem/problem.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Units in which the solver works, so that it sees the same numbers whatever the user's units and
/// size.
struct Scales {
  double length;  ///< maximum extent of the mesh [m]
  double stress;  ///< maximum Young's modulus [Pa]

  [[nodiscard]] double force() const { return stress * length * length; }
};

template <int dim>
Scales scales_of(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh);

/// The same problem in those units.
template <int dim>
Problem<dim> scaled(const Problem<dim>& problem, const Scales& scales);

}  // namespace geneva::fem
