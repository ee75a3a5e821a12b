#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/units.h"

namespace geneva::post {

/// The mechanism to scale as SVG, with its main dimensions, the pin force and the contact point.
/// @param mechanism what mechanism.json holds
/// @param step that is drawn, one of the mechanism's
/// @param label what is drawn, in words
std::string mechanism_drawing(const nlohmann::json& mechanism, const nlohmann::json& step,
                              const std::string& label, base::UnitSystem units);

/// Where places [m] appear on the drawing, for the script that moves it: two rows of a matrix and
/// the offset [pixels].
nlohmann::json drawing_projection(const nlohmann::json& mechanism);

}  // namespace geneva::post
