#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/extrusion.h"
#include "model/mechanism_state.h"

namespace geneva::model {

/// How wheel (or block) and pin are extruded along z. Surfaces: "faces" of the wheel, "pin root",
/// "pin tip"; of a half model "wheel middle" and "pin middle".
/// @param cell maximum size of the plane cells at the contact [m]
/// @return by the names of the bodies
std::vector<mesh::Extrusion> extrusions(const std::vector<std::string>& bodies,
                                        const MechanismCase& mechanism, const MechanismState& state,
                                        double cell);

/// Of the layers towards the wheel's faces, or to where its broken edges begin; none with a crown
/// whose Hertz contact is shorter, nor with a logarithmic profile, which unloads its ends.
std::optional<mesh::Grading> grading(const MechanismCase& mechanism, const MechanismState& state);

}  // namespace geneva::model
