#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace geneva::post {

/// A picture of the von Mises stress around the contact, four half-widths up and down, in 3-D of
/// the cut across it: an SVG document with axes and colour bar in output units.
/// @param view what view.json holds
/// @throws base::InputError if it is damaged
std::string field_picture(const nlohmann::json& view);

}  // namespace geneva::post
