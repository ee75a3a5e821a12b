#include "post/report/pictures/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/pictures/picture.h"

namespace geneva::post {

namespace {

constexpr double map_width = 560.;
constexpr double map_height = 420.;
constexpr double map_left = 70.;
constexpr double map_right = 20.;
constexpr double map_top = 14.;
constexpr double map_bottom = 100.;

/// Ends of the cells around places in ascending order: midway between neighbours.
std::vector<double> ends_of_cells(const std::vector<double>& places) {
  std::vector<double> ends;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    ends.push_back(0.5 * (places[i] + places[i + 1]));
  ends.insert(ends.begin(), 2. * places.front() - ends.front());
  ends.push_back(2. * places.back() - ends.back());
  return ends;
}

struct MapScale {
  double from;
  double to;
  double first_pixel;
  double last_pixel;

  [[nodiscard]] double at(const double value) const {
    return first_pixel + (value - from) / (to - from) * (last_pixel - first_pixel);
  }
};

std::array<double, 2> map_range(const std::vector<double>& values) {
  std::array<double, 2> range{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  for (const double value : values)
    if (std::isfinite(value)) {
      range[0] = std::min(range[0], value);
      range[1] = std::max(range[1], value);
    }
  constexpr double noise = 1e-6;  // a figure that the parameters do not change has one colour
  if (range[1] - range[0] < noise * std::abs(range[1])) range[1] = range[0];
  return range;
}

std::string map_text(const double x, const double y, const std::string& anchor,
                     const std::string& content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(content));
}

struct MapCell {
  std::array<double, 2> x;  ///< pixels
  std::array<double, 2> y;
  double share;  ///< of the range, 0 to 1
  std::string number;
  bool is_exceeded;
};

/// Black on the light colours, white on the dark ones.
std::string ink_on(const Colour& colour) {
  const double lightness = 0.3 * colour[0] + 0.59 * colour[1] + 0.11 * colour[2];
  return lightness > 128. ? "#000000" : "#ffffff";
}

std::string map_cell(const MapCell& cell) {
  const Colour colour = colour_of(cell.share);
  const std::string ink = ink_on(colour);
  const double x = std::min(cell.x[0], cell.x[1]);
  const double y = std::min(cell.y[0], cell.y[1]);
  const double wide = std::abs(cell.x[1] - cell.x[0]);
  const double high = std::abs(cell.y[1] - cell.y[0]);
  std::string svg = fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
      "fill=\"#{:02x}{:02x}{:02x}\"/>\n",
      x, y, wide, high, colour[0], colour[1], colour[2]);
  if (cell.is_exceeded)
    svg += fmt::format(
        "<path class=\"exceeded\" stroke=\"{}\" stroke-width=\"1.5\" d=\"M{:.1f} {:.1f}l{:.1f} "
        "{:.1f}m0 {:.1f}l{:.1f} {:.1f}\"/>\n",
        ink, x, y, wide, high, -high, -wide, high);
  constexpr double digit = 8.;
  if (wide > digit * static_cast<double>(n_letters(cell.number)) && high > 2. * digit)
    svg += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" style=\"fill:{}\">{}</text>\n",
        x + 0.5 * wide, y + 0.5 * high + 5., ink, cell.number);
  return svg;
}

std::string map_cells(const MapData& map, const MapScale& x, const MapScale& y,
                      const std::array<double, 2>& range) {
  const std::vector<double> columns = ends_of_cells(map.x);
  const std::vector<double> rows = ends_of_cells(map.y);
  std::string svg;
  for (std::size_t j = 0; j < map.y.size(); ++j)
    for (std::size_t i = 0; i < map.x.size(); ++i) {
      const std::size_t at = j * map.x.size() + i;
      if (!std::isfinite(map.values[at])) continue;
      const double extent = range[1] - range[0];
      svg += map_cell({{x.at(columns[i]), x.at(columns[i + 1])},
                       {y.at(rows[j]), y.at(rows[j + 1])},
                       extent > 0. ? (map.values[at] - range[0]) / extent : 0.5,
                       significant(map.values[at], 3),
                       !map.exceeds.empty() && map.exceeds[at]});
    }
  return svg;
}

/// The values that have room at an axis, the first one always.
/// @param room of a number [pixels]
std::vector<double> with_room(const std::vector<double>& values, const MapScale& scale,
                              const double room) {
  std::vector<double> kept;
  for (const double value : values)
    if (kept.empty() || std::abs(scale.at(value) - scale.at(kept.back())) >= room)
      kept.push_back(value);
  return kept;
}

std::string map_axes(const MapData& map, const MapScale& x, const MapScale& y) {
  constexpr double width_of_number = 52.;
  constexpr double height_of_number = 15.;
  std::string svg;
  for (const double value : with_room(map.x, x, width_of_number))
    svg += map_text(x.at(value), map_height - map_bottom + 18., "middle", significant(value, 4));
  for (const double value : with_room(map.y, y, height_of_number))
    svg += map_text(map_left - 8., y.at(value) + 5., "end", significant(value, 4));
  return svg +
         map_text(0.5 * (map_left + map_width - map_right), map_height - map_bottom + 38., "middle",
                  map.x_label) +
         fmt::format(
             "<text transform=\"translate(16 {:.1f}) rotate(-90)\" "
             "text-anchor=\"middle\">{}</text>\n",
             0.5 * (map_top + map_height - map_bottom), escaped(map.y_label));
}

/// @param id of the colours on the page
std::string map_bar(const MapData& map, const std::array<double, 2>& range, const std::string& id) {
  const MapScale scale{range[0], range[1], map_left, map_width - map_right};
  const double y = map_height - 46.;
  std::string svg =
      fmt::format("{1}<rect x=\"{2}\" y=\"{3}\" width=\"{4}\" height=\"10\" fill=\"url(#{0})\"/>\n",
                  id, colour_gradient(id), map_left, y, map_width - map_left - map_right);
  if (range[0] < range[1])
    for (const double value : round_numbers(range[0], range[1], 5))
      svg += map_text(scale.at(value), y + 24., "middle", significant(value, 4));
  return svg + map_text(0.5 * (map_left + map_width - map_right), y + 42., "middle", map.name);
}

}  // namespace

std::string map_picture(const MapData& map, const std::string& id) {
  const std::vector<double> columns = ends_of_cells(map.x);
  const std::vector<double> rows = ends_of_cells(map.y);
  const MapScale x{columns.front(), columns.back(), map_left, map_width - map_right};
  const MapScale y{rows.front(), rows.back(), map_height - map_bottom, map_top};
  const std::array<double, 2> range = map_range(map.values);
  return fmt::format(
             "<svg class=\"map\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{} over {} and "
             "{}\">\n",
             map_width, map_height, escaped(map.name), escaped(map.x_label), escaped(map.y_label)) +
         map_cells(map, x, y, range) + map_axes(map, x, y) + map_bar(map, range, id) + "</svg>\n";
}

}  // namespace geneva::post
