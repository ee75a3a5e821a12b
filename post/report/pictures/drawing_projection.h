#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>

namespace geneva::post {

inline constexpr double drawing_width = 640.;
inline constexpr double drawing_height = 490.;
inline constexpr double bottom_margin = 46.;  ///< [pixels], for the centre distance

using Place = std::array<double, 3>;
using Pixel = std::array<double, 2>;

/// Rows of a matrix from places [m] to pixels, and an offset.
struct Projection {
  std::array<Place, 2> rows;
  Pixel offset;

  [[nodiscard]] Pixel at(const Place& place) const {
    Pixel result = offset;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 3; ++k) result[i] += rows[i][k] * place[k];
    return result;
  }
};

/// A place turned about the z axis.
Place turned(const Place& place, double angle);

/// Whether the pin leaves the plane z = 0.
bool is_spherical(const nlohmann::json& mechanism);

/// The drawing of a mechanism holds everything in every position.
Projection projection_of(const nlohmann::json& mechanism);

double pixels_per_metre(const Projection& projection);

}  // namespace geneva::post
