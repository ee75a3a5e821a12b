#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// The names of a Gmsh model's parts.
struct ModelLabels {
  struct Body {
    std::string name;
    std::vector<int> surfaces;  ///< Gmsh's tags
  };
  struct Curve {
    std::string surface;  ///< empty: no name
    int circle;           ///< index into circles; -1: straight, or no circle
  };
  std::vector<Body> bodies;
  std::map<int, Curve> curves;  ///< by Gmsh's tag
  std::vector<Circle> circles;
  std::vector<std::string> surfaces;  ///< names of the curves in the order wanted
};

/// Index of the circle in the list, to which it is added unless an equal one (to 1e-9 of its
/// radius) is there.
int circle_index(std::vector<Circle>& circles, const Circle& circle);

/// A mesh and the tags that its vertices have in Gmsh.
struct TaggedMesh {
  MeshData<2> mesh;
  std::vector<std::size_t> tags;
};

/// Cells of the current Gmsh model's mesh that are not linear quadrilaterals.
struct OtherCells {
  std::size_t triangles = 0;
  std::size_t of_higher_order = 0;
  std::size_t others = 0;  ///< neither triangles nor quadrilaterals
};
OtherCells count_other_cells();

/// The current Gmsh model's linear quadrilaterals, turned counter-clockwise, with all boundary
/// edges.
/// @throws std::invalid_argument if a vertex stands off the plane z = 0
TaggedMesh read_model(const ModelLabels& labels);

}  // namespace geneva::mesh
