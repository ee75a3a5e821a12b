#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace geneva::post {

/// What a picture shows.
enum class PicturePart {
  contact,  ///< four half-widths of the contact up and down, in 3-D in the cut across it
  model     ///< all of the model, in 3-D of that cut, with the numbered places of the maximum
            ///< stresses
};

/// Scales of a picture; without one that of what the picture shows.
struct PictureScales {
  std::optional<std::array<double, 2>> range;  ///< of the colours, in output units
  std::optional<double> pixels;                ///< per output unit of length, on both axes
};

/// A picture of the von Mises stress: an SVG document with axes and colour bar in output units.
/// @param view what view.json holds
/// @throws base::InputError if it is damaged
std::string field_picture(const nlohmann::json& view, PicturePart part,
                          const PictureScales& scales = {});

/// Pixels per output unit of length of such a picture.
/// @throws base::InputError if the view is damaged
double picture_scale(const nlohmann::json& view, PicturePart part);

/// The range of the stress that such a picture shows, in output units.
/// @throws base::InputError if the view is damaged
std::array<double, 2> field_range(const nlohmann::json& view, PicturePart part);

}  // namespace geneva::post
