#pragma once

#include "loads/wheel/outline.h"

namespace geneva::mesh {

/// How fine the coarse mesh of an outline is; short and strongly curved segments get finer cells by
/// themselves.
struct MeshSizing {
  double general;           ///< target cell size away from the contact [m]
  double at_contact;        ///< target cell size at the contact [m]
  loads::Point contact;     ///< where the bodies touch [m]
  double contact_distance;  ///< cells grow from at_contact to general over this distance [m]
};

}  // namespace geneva::mesh
