#pragma once

#include <string>
#include <vector>

namespace geneva::post {

/// A figure over a grid of two parameters.
struct MapData {
  std::string name;     ///< "peak contact pressure [MPa]"
  std::string x_label;  ///< "Pin diameter [mm]"
  std::string y_label;
  std::vector<double> x;  ///< in ascending order
  std::vector<double> y;
  std::vector<double> values;  ///< row by row, x running; not a number where there is none
  std::vector<bool> exceeds;   ///< whether the limit of a point is exceeded, as `values`; or empty
};

/// The figure in colours over both parameters, the number in every cell, crossed out where the
/// limit is exceeded; as SVG with a bar of colours.
/// @param id of the bar's colours, unique on the page
std::string map_picture(const MapData& map, const std::string& id);

}  // namespace geneva::post
