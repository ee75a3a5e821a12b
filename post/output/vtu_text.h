#pragma once

#include <string>
#include <vector>

#include "post/output/nodal_fields.h"

namespace geneva::post {

/// An array of a VTK file.
struct VtuArray {
  std::string name;
  std::size_t components;
  std::vector<float> values;
};

/// A VTK unstructured grid of the fields' cells with arrays at their nodes.
/// @param length_factor from metres to the unit of the points
std::string vtu_text(const NodalFields& fields, const std::vector<VtuArray>& arrays,
                     double length_factor);

}  // namespace geneva::post
