#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "loads/wheel/solid_part.h"

namespace geneva::cad {

/// Unit of lengths in shapes [m].
inline constexpr double kernel_unit = 1e-3;

/// A face of a solid and the name of the surface that it belongs to.
struct NamedFace {
  TopoDS_Shape face;
  std::string name;  ///< may be empty
};

/// A part as one solid with true planes and cylinders, in its own frame; lengths in
/// millimetres.
struct PartShape {
  TopoDS_Shape solid;
  std::vector<NamedFace> faces;
};

/// @throws std::logic_error if the kernel finds no valid solid (a bug: outlines are checked)
PartShape shape_of(const loads::SolidPart& part);

}  // namespace geneva::cad
