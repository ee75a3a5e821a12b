#pragma once

#include <filesystem>
#include <vector>

#include "mesh/outline_mesh.h"
#include "mesh/user_geometry.h"

namespace geneva::mesh {

/// The mesher of these tests, which MESHER names.
inline Mesher& test_mesher() {
  static Mesher mesher(MESHER);
  return mesher;
}

inline constexpr MesherLimits test_limits{8e9, 600.};

inline MeshData<2> mesh_outlines(const std::vector<loads::Outline>& outlines,
                                 const MeshSizing& sizing) {
  return mesh_outlines(outlines, sizing, test_mesher(), test_limits);
}

template <int dim>
MeshData<dim> read_geometry(const std::filesystem::path& file, const double length_unit,
                            const double circle_tolerance = 0.) {
  return read_geometry<dim>({file, length_unit, circle_tolerance}, test_mesher(), test_limits);
}

}  // namespace geneva::mesh
