#include "api/surface_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "post/report/html/html.h"

namespace geneva::api {

namespace {

using Place = std::array<double, 3>;
using Pixel = std::array<double, 2>;
using mesh::ListedSurface;

/// Directions on the screen and towards the eye, orthonormal.
struct View {
  const char* title;
  Place right;
  Place up;
  Place eye;
};

double dot(const Place& one, const Place& other) {
  return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
}

std::vector<View> views(const int dimension) {
  if (dimension == 2) return {{"", {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
  const double s = std::sqrt(0.5);
  const double t = std::sqrt(1. / 6.);
  const double r = std::sqrt(1. / 3.);
  return {{"from +x, +y, +z", {s, 0., -s}, {-t, 2. * t, -t}, {r, r, r}},
          {"from -x, -y, -z", {-s, 0., s}, {-t, 2. * t, -t}, {-r, -r, -r}}};
}

/// What the screen shows of the places.
struct Frame {
  double left = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();

  void take(const double x, const double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    bottom = std::min(bottom, y);
    top = std::max(top, y);
  }
};

constexpr double width = 560.;  // of a view in pixels
constexpr double margin = 24.;

/// Places of a view in pixels.
class Screen {
 public:
  Screen(const SurfaceList& list, const View& view) : view_(view) {
    for (const ListedSurface& surface : list.surfaces)
      for (const auto& face : surface.faces)
        for (const Place& place : face) frame_.take(dot(place, view.right), dot(place, view.up));
    const double extent = std::max(frame_.right - frame_.left, frame_.top - frame_.bottom);
    scale_ = (width - 2. * margin) / extent;
  }

  [[nodiscard]] double height() const {
    return 2. * margin + scale_ * (frame_.top - frame_.bottom);
  }
  [[nodiscard]] Pixel pixel(const Place& place) const {
    const double middle = (frame_.left + frame_.right) / 2.;
    return {width / 2. + scale_ * (dot(place, view_.right) - middle),
            margin + scale_ * (frame_.top - dot(place, view_.up))};
  }

 private:
  const View& view_;
  Frame frame_;
  double scale_;
};

/// Hues that follow each other at the golden angle are far apart.
std::string colour(const std::size_t surface) {
  constexpr double golden = 137.508;
  return fmt::format("hsl({:.0f} 65% 72%)", std::fmod(golden * static_cast<double>(surface), 360.));
}

Place normal(const std::vector<Place>& face) {
  const auto minus = [](const Place& a, const Place& b) {
    return Place{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const Place u = minus(face[2], face[0]);
  const Place v = minus(face[3], face[1]);
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// A line in the plane; in 3-D a face that the eye sees from outside.
struct DrawnFace {
  std::size_t surface;
  double depth;  ///< towards the eye [m]
  Place middle;
  std::vector<Pixel> corners;
};

Place middle_of(const std::vector<Place>& face) {
  Place middle{};
  for (const Place& place : face)
    for (std::size_t k = 0; k < 3; ++k) middle[k] += place[k] / static_cast<double>(face.size());
  return middle;
}

/// From the farthest to the nearest, as they are painted.
std::vector<DrawnFace> drawn_faces(const SurfaceList& list, const View& view,
                                   const Screen& screen) {
  std::vector<DrawnFace> faces;
  for (std::size_t i = 0; i < list.surfaces.size(); ++i)
    for (const auto& face : list.surfaces[i].faces) {
      if (list.dimension == 3 && dot(normal(face), view.eye) <= 0.) continue;
      const Place middle = middle_of(face);
      DrawnFace drawn{i, dot(middle, view.eye), middle, {}};
      for (const Place& place : face) drawn.corners.push_back(screen.pixel(place));
      faces.push_back(std::move(drawn));
    }
  std::stable_sort(faces.begin(), faces.end(), [](const DrawnFace& one, const DrawnFace& other) {
    return one.depth < other.depth;
  });
  return faces;
}

std::string painted(const DrawnFace& face, const std::string& name) {
  std::string points;
  for (const auto& [x, y] : face.corners) points += fmt::format("{:.1f},{:.1f} ", x, y);
  const bool is_line = face.corners.size() == 2;
  return fmt::format(
      "<{0} points=\"{1}\" {2}><title>{3}</title></{0}>\n", is_line ? "polyline" : "polygon",
      points,
      is_line ? fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"5\"", colour(face.surface))
              : fmt::format("fill=\"{}\"", colour(face.surface)),
      post::escaped(name));
}

/// By the number of edges to the right of it.
bool covers(const DrawnFace& face, const Pixel& pixel) {
  bool is_inside = false;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const auto& [x1, y1] = face.corners[i];
    const auto& [x2, y2] = face.corners[(i + 1) % face.corners.size()];
    if ((y1 > pixel[1]) != (y2 > pixel[1]) &&
        pixel[0] < x1 + (pixel[1] - y1) / (y2 - y1) * (x2 - x1))
      is_inside = !is_inside;
  }
  return is_inside;
}

bool is_hidden(const std::vector<DrawnFace>& faces, const std::size_t face, const Pixel& pixel) {
  for (std::size_t i = face + 1; i < faces.size(); ++i)
    if (faces[i].surface != faces[face].surface && covers(faces[i], pixel)) return true;
  return false;
}

/// Where a surface is numbered: on the face in sight that is nearest to its place.
std::optional<Pixel> place_of_number(const std::vector<DrawnFace>& faces, const Screen& screen,
                                     const ListedSurface& surface, const std::size_t number) {
  std::vector<std::pair<double, std::size_t>> own;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (faces[i].surface == number)
      own.emplace_back(
          std::hypot(faces[i].middle[0] - surface.place[0], faces[i].middle[1] - surface.place[1],
                     faces[i].middle[2] - surface.place[2]),
          i);
  std::sort(own.begin(), own.end());
  for (const auto& [away, face] : own) {
    const Pixel pixel = screen.pixel(faces[face].middle);
    if (!is_hidden(faces, face, pixel)) return pixel;
  }
  return std::nullopt;
}

/// The three axes as seen, in the lower left corner; nothing in the plane, where they lie as usual.
std::string axes(const Screen& screen, const View& view) {
  constexpr double length = 34.;
  const Pixel origin{44., screen.height() - 44.};
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = length * view.right[axis];
    const double y = -length * view.up[axis];
    text += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{3:.1f}\"/>\n"
        "<text class=\"axis\" x=\"{4:.1f}\" y=\"{5:.1f}\">{6}</text>\n",
        origin[0], origin[1], origin[0] + x, origin[1] + y, origin[0] + 1.3 * x,
        origin[1] + 1.3 * y, "xyz"[axis]);
  }
  return text;
}

std::string picture(const SurfaceList& list, const View& view) {
  const Screen screen(list, view);
  const std::vector<DrawnFace> faces = drawn_faces(list, view, screen);
  std::string text = fmt::format(
      "<figure><svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" aria-label=\"surfaces, {2}\">\n",
      width, screen.height(), view.title);
  for (const DrawnFace& face : faces) text += painted(face, list.surfaces[face.surface].name);
  for (std::size_t i = 0; i < list.surfaces.size(); ++i)
    if (const auto at = place_of_number(faces, screen, list.surfaces[i], i); at)
      text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", (*at)[0], (*at)[1], i + 1);
  if (list.dimension == 3) text += axes(screen, view);
  return text + fmt::format("</svg><figcaption>{}</figcaption></figure>\n", view.title);
}

constexpr const char* style = R"(
body { margin: 0 auto; max-width: 76rem; padding: 1rem; font: 1rem/1.5 system-ui, "DejaVu Sans", sans-serif; color: #1b2126; }
.views { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { flex: 1 1 20rem; margin: 0; }
figcaption { color: #56616b; text-align: center; }
svg { width: 100%; background: #f3f5f7; }
polygon { stroke: #1b212640; stroke-width: 0.4; }
line { stroke: #56616b; stroke-width: 1.5; }
text { font-weight: bold; text-anchor: middle; dominant-baseline: middle; paint-order: stroke; stroke: #fff; stroke-width: 4px; }
text.axis { fill: #56616b; font-weight: normal; font-style: italic; }
div.table { overflow-x: auto; }
table { border-collapse: collapse; margin-top: 1rem; }
th, td { padding: 0.2rem 0.8rem; text-align: left; border-bottom: 1px solid #cfd6dc; white-space: nowrap; }
i { display: inline-block; width: 1.6rem; text-align: center; font-style: normal; }
)";

}  // namespace

std::string surface_page(const SurfaceList& list) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>Surfaces of {0}</title><style>{1}</style></head><body>\n<h1>Surfaces of {0}</h1>\n"
      "<div class=\"views\">\n",
      post::escaped(list.file.filename().string()), style);
  for (const View& view : views(list.dimension)) text += picture(list, view);
  text +=
      "</div>\n<div class=\"table\"><table><tr><th></th><th>surface</th><th>body</th>"
      "<th>shape</th><th>size</th><th>place</th></tr>\n";
  for (std::size_t i = 0; i < list.surfaces.size(); ++i) {
    const SurfaceRow row = row_of(list, list.surfaces[i]);
    text += fmt::format(
        "<tr><td><i style=\"background:{}\">{}</i></td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td><td>nearest {}</td></tr>\n",
        colour(i), i + 1, post::escaped(list.surfaces[i].name),
        post::escaped(list.surfaces[i].body), list.surfaces[i].shape, row.size, row.place);
  }
  return text + "</table></div>\n</body></html>\n";
}

}  // namespace geneva::api
