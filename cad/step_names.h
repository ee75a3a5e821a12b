#pragma once

#include <array>
#include <string>
#include <vector>

#include "cad/step_model.h"

namespace geneva::cad {

/// A name for what is nearest to a place in the shapes' unit of length.
struct PlacedName {
  std::string name;
  bool is_body;
  std::array<double, 3> place;
};

/// A face, in the plane an edge, of a body, and the surface that it belongs to.
struct NamedBoundary {
  TopoDS_Shape shape;
  std::string surface;
};

/// A body with the names that a case may use.
struct SelectedBody {
  std::string name;
  TopoDS_Shape shape;
  std::vector<NamedBoundary> boundary;
};

/// Bodies of a dimension (3: solids, bounded by faces; 2: faces, bounded by edges) by name.
///
/// A body has the name of its product, with a number where several have it, "solid 2" ("face 2")
/// without one. A surface has the name of its faces, behind that of the body where two bodies have
/// it; where it has none, that of the body and its number there, "wheel face 3" ("wheel edge 3").
/// Picks come before both.
/// @param wanted names of bodies; empty: all
/// @throws base::InputError if there are no bodies of the dimension, a wanted one is missing, or a
/// pick's place is far from all, or as near to another one
std::vector<SelectedBody> select(const std::vector<StepBody>& bodies, int dimension,
                                 const std::vector<std::string>& wanted,
                                 const std::vector<PlacedName>& picks);

}  // namespace geneva::cad
