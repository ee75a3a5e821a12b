#include "post/report/pictures/field_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/base64.h"
#include "base/errors.h"
#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/pictures/picture.h"
#include "post/view/quantised.h"

namespace geneva::post {

using nlohmann::json;

namespace {

constexpr int width = 900;
constexpr int height = 540;
constexpr double left = 116.;
constexpr double top = 20.;
constexpr std::size_t letters = 68;  // beside each other in the picture's width
constexpr double half_widths_up = 4.;

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Directions to the right and up on the picture of a plane with this normal; y is up if it can be.
struct PictureAxes {
  Vector right;
  Vector up;
};
PictureAxes axes_of(const Vector& normal) {
  const Vector given = std::abs(normal[1]) < 0.9 ? Vector{0., 1., 0.} : Vector{1., 0., 0.};
  Vector right = cross(given, normal);
  const double length = std::sqrt(dot(right, right));
  for (double& component : right) component /= length;
  return {right, cross(normal, right)};
}

/// A flat mesh, on the picture's axes [output units] from the contact.
struct FlatMesh {
  PictureAxes axes;
  std::vector<double> right;
  std::vector<double> up;
  std::vector<float> values;
  std::vector<unsigned int> triangles;
};

std::vector<float> restored_numbers(const json& section) {
  return restored({section.at("low"), section.at("high"),
                   base::decoded<std::uint16_t>(section.at("steps").get<std::string>())});
}

FlatMesh flat_mesh(const json& view) {
  const std::string name = view.at("dimension") == 3 ? "across" : "model";
  const json& meshes = view.at("meshes");
  const auto mesh = std::find_if(meshes.begin(), meshes.end(),
                                 [&](const json& one) { return one.at("name") == name; });
  if (mesh == meshes.end()) throw base::InputError("view.json lacks the mesh " + name);
  const auto normal = mesh->value("normal", std::vector<double>{0., 0., 1.});
  const PictureAxes axes = axes_of({normal.at(0), normal.at(1), normal.at(2)});
  const auto points = base::decoded<float>(mesh->at("points"));
  FlatMesh result{axes,
                  {},
                  {},
                  restored_numbers(mesh->at("fields").at("von_mises")),
                  base::decoded<unsigned int>(mesh->at("triangles"))};
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const Vector place{points[i], points[i + 1], points[i + 2]};
    result.right.push_back(dot(place, axes.right));
    result.up.push_back(dot(place, axes.up));
  }
  if (result.values.size() != result.right.size())
    throw base::InputError("view.json is damaged: points and stresses differ in number");
  return result;
}

/// From places [output units] to pixels.
struct Window {
  double scale;         ///< pixels per unit of length
  double right = 0.;    ///< in the middle
  double up = 0.;       ///< in the middle
  double omitted = 0.;  ///< distance from the origin within which colours may be beyond the range

  [[nodiscard]] double column(const double at) const { return 0.5 * width + scale * (at - right); }
  [[nodiscard]] double row(const double at) const { return 0.5 * height - scale * (at - up); }
  [[nodiscard]] bool shows(const double right_of, const double up_of) const {
    return std::abs(column(right_of) - 0.5 * width) < 0.5 * width &&
           std::abs(row(up_of) - 0.5 * height) < 0.5 * height;
  }
};

Window window_on_contact(const json& view) {
  return {0.5 * height / (half_widths_up * view.at("half_width").get<double>())};
}

/// The contact's own stress would leave no colours for the rest.
Window window_on_model(const json& view, const FlatMesh& mesh) {
  constexpr double margin = 1.06;
  const auto [left_end, right_end] = std::minmax_element(mesh.right.begin(), mesh.right.end());
  const auto [lower_end, upper_end] = std::minmax_element(mesh.up.begin(), mesh.up.end());
  const double wide = *right_end - *left_end;
  const double high = *upper_end - *lower_end;
  Window window{std::min(width / wide, height / high) / margin, 0.5 * (*left_end + *right_end),
                0.5 * (*lower_end + *upper_end)};
  if (view.at("focus") == "contact")
    window.omitted =
        std::max(6. * view.at("half_width").get<double>(), 0.05 * std::max(wide, high));
  return window;
}

std::array<double, 2> range_in(const FlatMesh& mesh, const Window& window) {
  std::array<double, 2> range{std::numeric_limits<double>::max(), 0.};
  for (std::size_t i = 0; i < mesh.values.size(); ++i)
    if (window.shows(mesh.right[i], mesh.up[i]) &&
        std::hypot(mesh.right[i], mesh.up[i]) >= window.omitted) {
      range[0] = std::min<double>(range[0], mesh.values[i]);
      range[1] = std::max<double>(range[1], mesh.values[i]);
    }
  return range[0] < range[1] ? range : std::array<double, 2>{0., 1.};
}

Picture painted(const FlatMesh& mesh, const Window& window, const std::array<double, 2>& range) {
  Picture picture(width, height, {255, 255, 255});
  const auto corner = [&](const unsigned int point) {
    return Picture::Corner{window.column(mesh.right.at(point)), window.row(mesh.up.at(point)),
                           (mesh.values.at(point) - range[0]) / (range[1] - range[0])};
  };
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3)
    picture.paint(
        {corner(mesh.triangles[i]), corner(mesh.triangles[i + 1]), corner(mesh.triangles[i + 2])});
  return picture;
}

std::string text(const double x, const double y, const char* anchor, const std::string& content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(content));
}

/// @param origin of the numbers, on the picture's axes
std::string axes(const Window& window, const std::array<double, 2>& origin,
                 const std::string& label) {
  std::string result;
  const double half_wide = 0.5 * width / window.scale;
  const double half_high = 0.5 * height / window.scale;
  const double right = window.right + origin[0];
  const double up = window.up + origin[1];
  for (const double at : numbers_that_fit(right - half_wide, right + half_wide, 6, 4, letters)) {
    const double x = left + window.column(at - origin[0]);
    result += fmt::format("<path stroke=\"#1b2126\" d=\"M{:.1f} {:.1f}v6\"/>\n", x, top + height);
    result += text(x, top + height + 28., "middle", significant(at, 4));
  }
  for (const double at : round_numbers(up - half_high, up + half_high, 6)) {
    const double y = top + window.row(at - origin[1]);
    result += fmt::format("<path stroke=\"#1b2126\" d=\"M{:.1f} {:.1f}h-6\"/>\n", left, y);
    result += text(left - 10., y + 8., "end", significant(at, 4));
  }
  return result + text(left + 0.5 * width, top + height + 58., "middle", label);
}

/// The numbered places of the maximum stresses.
std::string marks(const json& view, const FlatMesh& mesh, const Window& window) {
  std::string result;
  int number = 0;
  for (const json& mark : view.at("marks")) {
    const Vector place = mark.at("place");
    ++number;
    const double right = dot(place, mesh.axes.right);
    const double up = dot(place, mesh.axes.up);
    if (!window.shows(right, up)) continue;
    const double x = left + window.column(right);
    const double y = top + window.row(up);
    result += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"14\" fill=\"#ffffff\" fill-opacity=\"0.85\" "
        "stroke=\"#1b2126\" stroke-width=\"2\"/>\n",
        x, y);
    result += text(x, y + 8., "middle", std::to_string(number));
  }
  return result;
}

/// @param is_exceeded whether there are greater values
/// @param id on the page
std::string colour_bar(const std::array<double, 2>& range, const std::string& unit,
                       const bool is_exceeded, const std::string& id) {
  const double y = top + height + 76.;
  std::string result =
      fmt::format("{1}<rect x=\"{2}\" y=\"{3}\" width=\"{4}\" height=\"16\" fill=\"url(#{0})\"/>\n",
                  id, colour_gradient(id), left, y, width);
  for (const double at : numbers_that_fit(range[0], range[1], 6, 4, letters)) {
    const double x = left + (at - range[0]) / (range[1] - range[0]) * width;
    result += fmt::format("<path stroke=\"#1b2126\" d=\"M{:.1f} {:.1f}v5\"/>\n", x, y + 16.);
    result += text(x, y + 42., "middle", significant(at, 4));
  }
  return result +
         text(left + 0.5 * width, y + 72., "middle",
              fmt::format("von Mises stress [{}], {} to {}{}", unit, significant(range[0], 4),
                          significant(range[1], 4), is_exceeded ? ", more at the contact" : ""));
}

/// @throws base::InputError if the view has no window
Window window_of(const json& view, const PicturePart part, const FlatMesh& mesh) {
  if (!(view.at("half_width").get<double>() > 0.))
    throw base::InputError("view.json is damaged: the half-width is not positive");
  return part == PicturePart::model ? window_on_model(view, mesh) : window_on_contact(view);
}

}  // namespace

std::array<double, 2> field_range(const json& view, const PicturePart part) {
  const FlatMesh mesh = flat_mesh(view);
  return range_in(mesh, window_of(view, part, mesh));
}

double picture_scale(const json& view, const PicturePart part) {
  return window_of(view, part, flat_mesh(view)).scale;
}

std::string field_picture(const json& view, const PicturePart part, const PictureScales& scales) {
  const FlatMesh mesh = flat_mesh(view);
  const bool is_model = part == PicturePart::model;
  Window window = window_of(view, part, mesh);
  window.scale = scales.pixels.value_or(window.scale);
  const std::array<double, 2> range = scales.range ? *scales.range : range_in(mesh, window);
  const std::string image = base::encoded_bytes(painted(mesh, window, range).png());
  const std::string unit = view.at("length_unit");
  const Vector origin = view.at("origin");
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
             "aria-label=\"von Mises stress {8}, at most {2:.4g} {3}\" "
             "style=\"font-family:DejaVu Sans,sans-serif;font-size:22px;fill:#1b2126\">\n"
             "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
             "<image x=\"{4}\" y=\"{5}\" width=\"{6}\" height=\"{7}\" "
             "href=\"data:image/png;base64,{9}\"/>\n<g stroke=\"#1b2126\" fill=\"none\">"
             "<rect x=\"{4}\" y=\"{5}\" width=\"{6}\" height=\"{7}\"/></g>\n",
             width + left + 30., height + top + 164., range[1],
             view.at("stress_unit").get<std::string>(), left, top, width, height,
             is_model ? "of the model" : "around the contact", image) +
         (is_model ? marks(view, mesh, window) +
                         axes(window, {dot(origin, mesh.axes.right), dot(origin, mesh.axes.up)},
                              fmt::format("coordinates [{}]", unit))
                   : axes(window, {0., 0.},
                          fmt::format("distance from the middle of the contact [{}]", unit))) +
         colour_bar(range, view.at("stress_unit"), window.omitted > 0.,
                    is_model ? "colours-of-model" : "colours-of-contact") +
         "</svg>\n";
}

}  // namespace geneva::post
