#include "post/report/pictures/drawing_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

namespace geneva::post {

using nlohmann::json;

Place turned(const Place& place, const double angle) {
  return {place[0] * std::cos(angle) - place[1] * std::sin(angle),
          place[0] * std::sin(angle) + place[1] * std::cos(angle), place[2]};
}

bool is_spherical(const json& mechanism) {
  const json& path = mechanism.at("pin_path");
  return std::any_of(path.begin(), path.end(),
                     [](const json& place) { return place.at(2).get<double>() != 0.; });
}

namespace {

constexpr double side_margin = 16.;

/// Directions that are to the right and down on the drawing: y is up in the plane; a sphere is seen
/// from above the line of centres.
std::array<Place, 2> directions(const json& mechanism) {
  if (!is_spherical(mechanism)) return {{{1., 0., 0.}, {0., -1., 0.}}};
  const double around = 0.6;
  const double above = 0.55;
  return {{{std::cos(around), std::sin(around), 0.},
           {std::sin(around) * std::sin(above), -std::cos(around) * std::sin(above),
            -std::cos(above)}}};
}

/// Everything that the drawing has to hold; the wheel in any position.
std::vector<Place> extremes(const json& mechanism) {
  std::vector<Place> places;
  for (const json& loop : mechanism.at("wheel"))
    for (const json& place : loop)
      for (int eighth = 0; eighth < 8; ++eighth)
        places.push_back(turned(place.get<Place>(), eighth * std::acos(-1.) / 4.));
  const double radius = mechanism.at("pin_diameter").get<double>() / 2.;
  for (const json& at : mechanism.at("pin_path"))
    for (const double side : {-radius, radius})
      for (std::size_t i = 0; i < 2; ++i) {
        places.push_back(at.get<Place>());
        places.back()[i] += side;
      }
  if (mechanism.contains("driver_axis")) places.push_back(mechanism.at("driver_axis").get<Place>());
  for (const json& step : mechanism.at("steps"))
    if (step.contains("linkage"))
      for (const json& place : step.at("linkage")) places.push_back(place.get<Place>());
  return places;
}

}  // namespace

Projection projection_of(const json& mechanism) {
  Projection projection{directions(mechanism), {0., 0.}};
  Pixel low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Pixel high{-low[0], -low[1]};
  for (const Place& place : extremes(mechanism)) {
    const Pixel at = projection.at(place);
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], at[i]);
      high[i] = std::max(high[i], at[i]);
    }
  }
  const double scale =
      std::min((drawing_width - 2. * side_margin) / (high[0] - low[0]),
               (drawing_height - side_margin - bottom_margin) / (high[1] - low[1]));
  for (auto& row : projection.rows)
    for (double& component : row) component *= scale;
  projection.offset = {
      drawing_width / 2. - scale * (low[0] + high[0]) / 2.,
      (drawing_height + side_margin - bottom_margin) / 2. - scale * (low[1] + high[1]) / 2.};
  return projection;
}

double pixels_per_metre(const Projection& projection) {
  const Place& row = projection.rows[0];
  return std::hypot(row[0], row[1], row[2]);
}

}  // namespace geneva::post
