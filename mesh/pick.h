#pragma once

#include <array>
#include <string>

namespace geneva::mesh {

/// A name for what is nearest to a place: for a body, or for a face of one, in the plane an edge.
struct Pick {
  std::string name;
  bool is_body;
  std::array<double, 3> place;  ///< [m]; z is 0 in the plane
};

}  // namespace geneva::mesh
