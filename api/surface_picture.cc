#include "api/surface_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "post/report/html/html.h"

namespace geneva::api {

namespace {

using Place = std::array<double, 3>;
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
  [[nodiscard]] std::array<double, 2> pixel(const Place& place) const {
    return {margin + scale_ * (dot(place, view_.right) - frame_.left),
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

/// A face as it is drawn.
struct DrawnFace {
  double depth;  ///< towards the eye
  std::string text;
};

/// A line in the plane; in 3-D a face that the eye sees from outside.
std::string drawn(const std::vector<Place>& face, const Screen& screen, const std::size_t surface,
                  const std::string& name) {
  std::string points;
  for (const Place& place : face) {
    const auto [x, y] = screen.pixel(place);
    points += fmt::format("{:.1f},{:.1f} ", x, y);
  }
  const bool is_line = face.size() == 2;
  return fmt::format(
      "<{} points=\"{}\" {}><title>{}</title></{}>\n", is_line ? "polyline" : "polygon", points,
      is_line ? fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"5\"", colour(surface))
              : fmt::format("fill=\"{}\"", colour(surface)),
      post::escaped(name), is_line ? "polyline" : "polygon");
}

/// Numbers of the surfaces that the eye sees at their places.
std::string labels(const SurfaceList& list, const Screen& screen, const View& view) {
  std::string text;
  for (std::size_t i = 0; i < list.surfaces.size(); ++i) {
    const ListedSurface& surface = list.surfaces[i];
    const auto at = std::min_element(
        surface.faces.begin(), surface.faces.end(), [&](const auto& one, const auto& other) {
          const auto away = [&](const auto& face) {
            Place middle{};
            for (const Place& place : face)
              for (std::size_t k = 0; k < 3; ++k)
                middle[k] += place[k] / static_cast<double>(face.size());
            return std::hypot(middle[0] - surface.place[0], middle[1] - surface.place[1],
                              middle[2] - surface.place[2]);
          };
          return away(one) < away(other);
        });
    if (list.dimension == 3 && dot(normal(*at), view.eye) <= 0.) continue;
    const auto [x, y] = screen.pixel(surface.place);
    text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, y, i + 1);
  }
  return text;
}

std::string picture(const SurfaceList& list, const View& view) {
  const Screen screen(list, view);
  std::vector<DrawnFace> faces;
  for (std::size_t i = 0; i < list.surfaces.size(); ++i)
    for (const auto& face : list.surfaces[i].faces) {
      if (list.dimension == 3 && dot(normal(face), view.eye) <= 0.) continue;
      double depth = 0.;
      for (const Place& place : face) depth += dot(place, view.eye);
      faces.push_back({depth, drawn(face, screen, i, list.surfaces[i].name)});
    }
  std::stable_sort(faces.begin(), faces.end(), [](const DrawnFace& one, const DrawnFace& other) {
    return one.depth < other.depth;
  });
  std::string text = fmt::format(
      "<figure><svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" aria-label=\"surfaces, {2}\">\n",
      width, screen.height(), view.title);
  for (const DrawnFace& face : faces) text += face.text;
  return text + labels(list, screen, view) +
         fmt::format("</svg><figcaption>{}</figcaption></figure>\n", view.title);
}

constexpr const char* style = R"(
body { margin: 0 auto; max-width: 76rem; padding: 1rem; font: 1rem/1.5 system-ui, "DejaVu Sans", sans-serif; color: #1b2126; }
.views { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { flex: 1 1 20rem; margin: 0; }
figcaption { color: #56616b; text-align: center; }
svg { width: 100%; background: #f3f5f7; }
polygon { stroke: #1b212640; stroke-width: 0.4; }
text { font-weight: bold; text-anchor: middle; dominant-baseline: middle; paint-order: stroke; stroke: #fff; stroke-width: 4px; }
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
