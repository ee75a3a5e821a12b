#pragma once

#include <string>
#include <vector>

#include "loads/wheel/outline.h"
#include "mesh/outline_mesh.h"
#include "model/mechanism_state.h"

namespace geneva::model {

/// What is meshed of a mechanism: wheel, or block of slot wall, and pin.
struct ContactGeometry {
  std::vector<loads::Outline> outlines;
  mesh::MeshSizing sizing;
  std::string held_surface;  ///< of the wheel or block
};

/// Pin and wheel at the analysed driver angle, or pin and block.
/// @throws base::InputError where the loads room does
ContactGeometry contact_geometry(const MechanismCase& mechanism, const MechanismState& state);

}  // namespace geneva::model
