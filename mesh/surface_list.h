#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// A surface of a coarse mesh, as one would look for it.
struct ListedSurface {
  std::string name;
  std::string body;
  std::string shape;            ///< "plane", "cylinder of radius 12 mm", "curved"; of several faces
  double size;                  ///< area [m^2], in the plane length [m], of the coarse faces
  std::array<double, 3> place;  ///< middle of the face that is nearest to the surface's middle [m]
  std::vector<std::vector<std::array<double, 3>>> faces;  ///< corners of the coarse faces [m]
};

/// The named surfaces of a mesh in the order of their bodies.
/// @param length_unit of the radii in words, "mm", and metres in it
template <int dim>
std::vector<ListedSurface> list_surfaces(const MeshData<dim>& mesh, const std::string& length_unit,
                                         double metres);

}  // namespace geneva::mesh
