#pragma once

#include "fem/discretisation/point_values.h"
#include "fem/discretisation/vector.h"

namespace geneva::fem {

/// What is carried from mesh to mesh.
struct MeshFields {
  Vector displacement;
  PointValues history;  ///< what materials remember
};

}  // namespace geneva::fem
