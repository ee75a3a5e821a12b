#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace geneva::post {

/// One picture of the von Mises stress for every instant of a cycle, with one range of colours.
struct CycleFrames {
  std::array<double, 2> range;      ///< of the colours, in output units
  std::array<double, 2> size;       ///< width and height, in output units
  std::vector<std::string> images;  ///< PNG files in base 64
};

/// Of the same instants.
struct CyclePictures {
  CycleFrames whole;  ///< wheel and pin, in the wheel's frame; the range without the contact's own
  CycleFrames contact;  ///< around the greatest stress of each instant
};

/// @param view what cycle_view.json holds
/// @param half_width greatest of the contact, in output units, greater than 0
/// @throws base::InputError if the view is damaged
CyclePictures cycle_pictures(const nlohmann::json& view, double half_width);

}  // namespace geneva::post
