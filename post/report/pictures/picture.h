#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace geneva::post {

using Colour = std::array<unsigned char, 3>;

/// Colours at equal distances of the colour map viridis, whose lightness grows evenly, also for the
/// colour-blind: "440154", ...
const std::vector<std::string>& palette();

/// The colour of a value between 0 and 1; beyond, that of the nearer end.
Colour colour_of(double value);

/// The colour map from left to right, for the fill of an SVG element.
/// @param id of the gradient, unique on the page
std::string colour_gradient(const std::string& id);

/// A picture of the colours of values on a background, by rows from the top.
class Picture {
 public:
  Picture(int width, int height, Colour background);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Colour at(int column, int row) const;

  struct Corner {
    double x;      ///< from the left [pixels]
    double y;      ///< from the top [pixels]
    double value;  ///< between 0 and 1
  };
  /// Paints a triangle with the colours of linearly interpolated values; pixels whose middle it
  /// covers.
  void paint(const std::array<Corner, 3>& corners);

  /// As a PNG file.
  [[nodiscard]] std::vector<unsigned char> png() const;

 private:
  [[nodiscard]] std::size_t place_of(int column, int row) const;

  static constexpr unsigned char unpainted = 255;

  int width_;
  int height_;
  Colour background_;
  std::vector<unsigned char> pixels_;  ///< shades of colour_of(), by number
};

}  // namespace geneva::post
