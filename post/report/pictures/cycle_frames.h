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

/// The whole wheel and the pin, in the wheel's frame; the range leaves out the contact's own
/// stress.
/// @param view what cycle_view.json holds
/// @throws base::InputError if it is damaged
CycleFrames wheel_frames(const nlohmann::json& view);

/// Around the greatest stress of each instant.
/// @param half_width greatest of the contact, in output units, greater than 0
CycleFrames contact_frames(const nlohmann::json& view, double half_width);

}  // namespace geneva::post
