#include "post/report/pictures/picture.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace geneva::post {

namespace {

unsigned char channel(const std::string& colour, const std::size_t index) {
  return static_cast<unsigned char>(std::stoi(colour.substr(2 * index, 2), nullptr, 16));
}

/// What one byte can name beside the background.
constexpr std::size_t n_shades = 255;

/// The palette, linearly between its colours.
std::array<Colour, n_shades> all_shades() {
  const auto& colours = palette();
  std::array<Colour, n_shades> shades{};
  for (std::size_t shade = 0; shade < n_shades; ++shade) {
    const double at = static_cast<double>(shade * (colours.size() - 1)) / (n_shades - 1);
    const std::size_t first = std::min(static_cast<std::size_t>(at), colours.size() - 2);
    const double share = at - static_cast<double>(first);
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = channel(colours[first], i);
      const double b = channel(colours[first + 1], i);
      shades[shade][i] = static_cast<unsigned char>(std::lround(a + share * (b - a)));
    }
  }
  return shades;
}

const std::array<Colour, n_shades>& shades() {
  static const std::array<Colour, n_shades> known = all_shades();
  return known;
}

/// The nearest to a value between 0 and 1.
std::size_t shade_of(const double value) {
  return static_cast<std::size_t>(
      std::lround(std::clamp(value, 0., 1.) * static_cast<double>(n_shades - 1)));
}

/// Where a horizontal line enters and leaves a triangle.
std::array<double, 2> ends_at(const double y, const std::array<Picture::Corner, 3>& corners) {
  std::array<double, 2> ends{std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::lowest()};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Picture::Corner& one = corners[i];
    const Picture::Corner& other = corners[(i + 1) % corners.size()];
    if (one.y == other.y || (one.y - y) * (other.y - y) > 0.) continue;
    const double x = one.x + (y - one.y) / (other.y - one.y) * (other.x - one.x);
    ends = {std::min(ends[0], x), std::max(ends[1], x)};
  }
  return ends;
}

}  // namespace

const std::vector<std::string>& palette() {
  static const std::vector<std::string> colours{"440154", "482475", "414487", "355f8d",
                                                "2a788e", "21918c", "22a884", "44bf70",
                                                "7ad151", "bddf26", "fde725"};
  return colours;
}

std::string colour_gradient(const std::string& id) {
  std::string stops;
  for (std::size_t i = 0; i < palette().size(); ++i)
    stops += fmt::format("<stop offset=\"{:.2f}\" stop-color=\"#{}\"/>",
                         static_cast<double>(i) / static_cast<double>(palette().size() - 1),
                         palette()[i]);
  return fmt::format("<defs><linearGradient id=\"{}\">{}</linearGradient></defs>\n", id, stops);
}

Colour colour_of(const double value) { return shades()[shade_of(value)]; }

Picture::Picture(const int width, const int height, const Colour background)
    : width_(width),
      height_(height),
      background_(background),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), unpainted) {}

std::size_t Picture::place_of(const int column, const int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
         static_cast<std::size_t>(column);
}

Colour Picture::at(const int column, const int row) const {
  const unsigned char pixel = pixels_.at(place_of(column, row));
  return pixel == unpainted ? background_ : shades()[pixel];
}

void Picture::paint(const std::array<Corner, 3>& corners) {
  const auto& [a, b, c] = corners;
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0. || !std::isfinite(a.value + b.value + c.value)) return;
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  if (right < 0. || left > width_ || bottom < 0. || top > height_) return;
  const int first_row = std::max(0, static_cast<int>(std::ceil(top - 0.5)));
  const int last_row = std::min(height_ - 1, static_cast<int>(std::floor(bottom - 0.5)));
  for (int row = first_row; row <= last_row; ++row) {
    const double y = row + 0.5;
    const auto [first, last] = ends_at(y, corners);
    const int first_column = std::max(0, static_cast<int>(std::floor(first - 0.5)));
    const int last_column = std::min(width_ - 1, static_cast<int>(std::ceil(last - 0.5)));
    for (int column = first_column; column <= last_column; ++column) {
      const double x = column + 0.5;
      const double of_b = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
      const double of_c = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
      if (of_b < 0. || of_c < 0. || of_b + of_c > 1.) continue;
      pixels_[place_of(column, row)] = static_cast<unsigned char>(
          shade_of(a.value + of_b * (b.value - a.value) + of_c * (c.value - a.value)));
    }
  }
}

std::vector<unsigned char> Picture::png() const {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width_);
  image.height = static_cast<png_uint_32>(height_);
  image.format = PNG_FORMAT_RGB_COLORMAP;
  image.colormap_entries = n_shades + 1;
  image.flags = PNG_IMAGE_FLAG_FAST;
  std::vector<Colour> colours(shades().begin(), shades().end());
  colours.push_back(background_);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<unsigned char> bytes(size);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels_.data(), 0,
                                colours.data()) == 0)
    throw std::runtime_error(std::string("cannot write a picture: ") + image.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace geneva::post
