#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::mesher {

using mesh::Circle;
using mesh::MeshData;

/// The names of a Gmsh model's parts.
struct ModelLabels {
  struct Body {
    std::string name;
    std::vector<int> entities;  ///< Gmsh's tags of its surfaces, in 3-D of its volumes
  };
  struct BoundaryPart {
    std::string surface;  ///< empty: no name
    int circle;           ///< index into circles; -1: straight, or no circle
  };
  std::vector<Body> bodies;
  std::map<int, BoundaryPart> boundary;  ///< by Gmsh's tag of the curve, in 3-D of the surface
  std::vector<Circle> circles;
  std::vector<std::string> surfaces;  ///< names of the boundary's parts in the order wanted
};

/// Index of the circle in the list, to which it is added unless an equal one (to 1e-9 of its
/// radius) is there.
int circle_index(std::vector<Circle>& circles, const Circle& circle);

/// A mesh and the tags that its vertices have in Gmsh.
template <int dim>
struct TaggedMesh {
  MeshData<dim> mesh;
  std::vector<std::size_t> tags;
};

/// The current Gmsh model's linear quadrilaterals or hexahedra, turned counter-clockwise, with all
/// boundary faces. Bodies that have nodes in common, but no face, are separated there.
/// @throws base::InputError in the plane if a vertex stands off z = 0; if two bodies have a
/// face in common
template <int dim>
TaggedMesh<dim> read_model(const ModelLabels& labels);

/// Node tags of the elements of one type of Gmsh's in one entity, element by element.
std::vector<std::size_t> element_nodes(int dimension, int entity, int type);

/// Gmsh's numbers of the types of linear elements.
inline constexpr int line_type = 1;
inline constexpr int quad_type = 3;
inline constexpr int hexahedron_type = 5;

}  // namespace geneva::mesher
