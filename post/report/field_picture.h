#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace geneva::post {

/// What a picture shows.
enum class PicturePart {
  contact,  ///< four half-widths of the contact up and down, in 3-D in the cut across it
  model     ///< all of the model, in 3-D of that cut, with the numbered places of the maximum
            ///< stresses
};

/// A picture of the von Mises stress: an SVG document with axes and colour bar in output units.
/// @param view what view.json holds
/// @throws base::InputError if it is damaged
std::string field_picture(const nlohmann::json& view, PicturePart part);

}  // namespace geneva::post
