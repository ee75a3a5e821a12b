#pragma once

#include "fem/problem.h"
#include "mesh/mesh_data.h"

namespace geneva::fem {

/// Units in which the solver works, so that it sees the same numbers whatever the user's units and
/// size.
struct Scales {
  double length;  ///< greatest extent of the mesh [m]
  double stress;  ///< greatest Young's modulus [Pa]

  [[nodiscard]] double force() const { return stress * length * length; }
};

Scales scales_of(const Problem& problem, const mesh::MeshData<2>& mesh);

/// The same problem in those units.
Problem scaled(const Problem& problem, const Scales& scales);

}  // namespace geneva::fem
