#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>
#include <vector>

#include "cad/part_shape.h"

namespace geneva::cad {

/// A solid, or a face that is of no solid, where it stands in its assembly; lengths in millimetres,
/// whatever the file's unit is.
struct StepBody {
  std::string name;  ///< of its product; may be empty
  TopoDS_Shape shape;
  std::vector<NamedFace> faces;  ///< all that it has
};

/// Bodies of a STEP file (AP203, AP214 or AP242) in its order.
/// @throws base::InputError if it cannot be read, or has none
std::vector<StepBody> read_step(const std::filesystem::path& file);

}  // namespace geneva::cad
