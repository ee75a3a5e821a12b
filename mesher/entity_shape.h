#pragma once

#include <map>

#include "mesh/mesh_data.h"

namespace geneva::mesher {

using mesh::Circle;

/// A curve or surface that is part of a circle, cylinder, sphere or torus.
struct RoundEntity {
  Circle circle;
  bool is_fitted;  ///< its nodes are only near to it
};

/// The round ones of the curves of Gmsh's current model, in 3-D of the surfaces, by tag. They are
/// found in points of the geometry, or in the nodes of a mesh. Nearly round ones that have nodes in
/// common are given one circle if one is near to all of them.
/// @param tolerance maximum distance of points from the circle nearest to them, as a share of its
/// radius; 0: none but rounding
template <int dim>
std::map<int, RoundEntity> round_entities(double tolerance);

}  // namespace geneva::mesher
