#include "post/report/pictures/mechanism_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/pictures/drawing_projection.h"

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::UnitSystem;

using nlohmann::json;

namespace {

constexpr double arrow_length = 80.;  ///< of the maximum force [pixels]

std::string path_data(const json& places, const Projection& projection, const double angle) {
  std::string data;
  for (const json& place : places) {
    const Pixel at = projection.at(turned(place.get<Place>(), angle));
    data += fmt::format("{}{:.2f} {:.2f}", data.empty() ? "M" : "L", at[0], at[1]);
  }
  return data;
}

std::string circle(const std::string& attributes, const Pixel& centre, const double radius) {
  return fmt::format("<circle {} cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", attributes,
                     centre[0], centre[1], radius);
}

std::string line(const std::string& attributes, const Pixel& from, const Pixel& to) {
  return fmt::format("<line {} x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>\n",
                     attributes, from[0], from[1], to[0], to[1]);
}

double maximum_force(const json& mechanism) {
  double maximum = 0.;
  for (const json& step : mechanism.at("steps"))
    if (!step.at("pin_force").is_null())
      maximum = std::max(maximum, std::abs(step.at("pin_force").get<double>()));
  return maximum;
}

/// The contact point, and the force on the wheel along the normal of the wall.
std::string force_arrow(const json& mechanism, const json& step, const Projection& projection) {
  if (step.at("engaged_pin").is_null() || maximum_force(mechanism) == 0.)
    return line("id=\"mechanism-force\" class=\"force\"", {0., 0.}, {0., 0.}) +
           circle("id=\"mechanism-contact\" class=\"arrow\"", {0., 0.}, 0.);
  const Place pin = step.at("pins").at(step.at("engaged_pin").get<std::size_t>()).get<Place>();
  const double force = step.at("pin_force");
  const double angle = std::atan2(pin[1], pin[0]);
  const Place normal{-std::sin(angle), std::cos(angle), 0.};
  const double side = force < 0. ? -1. : 1.;
  const double radius = mechanism.at("pin_diameter").get<double>() / 2.;
  const double length =
      arrow_length * std::abs(force) / maximum_force(mechanism) / pixels_per_metre(projection);
  Place contact = pin;
  Place tip = pin;
  for (std::size_t i = 0; i < 3; ++i) {
    contact[i] += side * radius * normal[i];
    tip[i] += side * (radius + length) * normal[i];
  }
  return line("id=\"mechanism-force\" class=\"force\" marker-end=\"url(#arrow)\"",
              projection.at(contact), projection.at(tip)) +
         circle("id=\"mechanism-contact\" class=\"arrow\"", projection.at(contact), 4.);
}

std::optional<Pixel> driver_axis(const json& mechanism, const Projection& projection) {
  if (!mechanism.contains("driver_axis")) return std::nullopt;
  return projection.at(mechanism.at("driver_axis").get<Place>());
}

std::string wheel_and_path(const json& mechanism, const json& step, const Projection& projection) {
  const double angle = step.at("wheel_angle");
  std::string wheel;
  for (const json& loop : mechanism.at("wheel")) wheel += path_data(loop, projection, angle) + "Z";
  return fmt::format(
             "<path id=\"mechanism-wheel\" class=\"{}\" fill-rule=\"evenodd\" d=\"{}\"/>\n"
             "<path class=\"way\" d=\"{}\"/>\n",
             is_spherical(mechanism) ? "wheel sphere" : "wheel", wheel,
             path_data(mechanism.at("pin_path"), projection, 0.)) +
         circle("class=\"axis\"", projection.at({0., 0., 0.}), 3.);
}

std::string driver(const json& mechanism, const json& step, const Projection& projection) {
  const double scale = pixels_per_metre(projection);
  const std::optional<Pixel> axis = driver_axis(mechanism, projection);
  std::string svg;
  if (axis) svg += circle("class=\"axis\"", *axis, 3.);
  if (axis && mechanism.contains("locking_radius"))
    svg += circle("class=\"way\"", *axis, scale * mechanism.at("locking_radius").get<double>());
  if (step.contains("linkage"))
    svg += fmt::format("<path id=\"mechanism-linkage\" class=\"link\" d=\"{}\"/>\n",
                       path_data(step.at("linkage"), projection, 0.));
  for (const json& pin : step.at("pins")) {
    const Pixel at = projection.at(pin.get<Place>());
    if (axis) svg += line("class=\"link mechanism-crank\"", *axis, at);
    svg += circle("class=\"pin\"", at, scale * mechanism.at("pin_diameter").get<double>() / 2.);
  }
  return svg;
}

constexpr double label_height = 18.;

/// Of a label [pixels].
double label_width(const std::string& content) {
  return 7.4 * static_cast<double>(n_letters(content)) + 6.;
}

/// A text in the middle of a ground that interrupts the lines below it.
std::string label_at(const std::string& id, const Pixel& at, const std::string& content) {
  const double wide = label_width(content);
  return fmt::format(
      "<g{} class=\"label\" transform=\"translate({:.2f} {:.2f})\">"
      "<rect x=\"{:.2f}\" y=\"-9\" width=\"{:.2f}\" height=\"18\"/>"
      "<text class=\"dimension-text\" y=\"5\">{}</text></g>\n",
      id.empty() ? "" : " id=\"" + id + "\"", at[0], at[1], -wide / 2., wide, escaped(content));
}

/// Lines of dimensions, and their labels, which come last, above everything else.
struct Dimensions {
  std::string lines;
  std::string labels;

  void add(const std::string& line, const Pixel& at, const std::string& label) {
    lines += line;
    labels += label_at("", at, label);
  }
};

/// [m]; nothing if the mechanism has no length of that name.
std::optional<double> length_named(const json& mechanism, const std::string& name) {
  for (const json& length : mechanism.at("lengths"))
    if (length.at("name") == name) return number_of(length.at("length"));
  return std::nullopt;
}

/// "R 2.5 in".
std::string dimension_text(const std::string& sign, const double length, const UnitSystem units) {
  return fmt::format("{}{} {}", sign, shown(length, Dimension::length, units),
                     output_unit(units, Dimension::length).name);
}

/// Where on an arrow its label stands [pixels from its beginning]: before the head, or behind it
/// where the arrow is too short.
double label_place(const double length, const double direction, const std::string& label) {
  constexpr double head = 12.;
  const double half = std::min(label_width(label) / 2. / std::abs(std::cos(direction)),
                               label_height / 2. / std::abs(std::sin(direction)));
  const double before = std::min(0.62 * length, length - head - half);
  return before > half ? before : length + half + 2.;
}

/// An arrow from the middle of a circle to its line.
void add_radius(Dimensions& dimensions, const Pixel& centre, const double radius,
                const double direction, const std::string& label) {
  const auto on_arrow = [&](const double length) {
    return Pixel{centre[0] + length * std::cos(direction),
                 centre[1] - length * std::sin(direction)};
  };
  dimensions.add(line("class=\"dimension\" marker-end=\"url(#dimension-end)\"", on_arrow(0.),
                      on_arrow(radius)),
                 on_arrow(label_place(radius, direction, label)), label);
}

/// The distance of two places of one height, below the drawing.
void add_distance_below(Dimensions& dimensions, const Pixel& from, const Pixel& to,
                        const std::string& label) {
  const double below = drawing_height - bottom_margin + 18.;
  const auto lowered = [&](const Pixel& at, const double by) { return Pixel{at[0], below + by}; };
  dimensions.add(line("class=\"dimension\"", from, lowered(from, 5.)) +
                     line("class=\"dimension\"", to, lowered(to, 5.)) +
                     line("class=\"dimension\" marker-start=\"url(#dimension-end)\" "
                          "marker-end=\"url(#dimension-end)\"",
                          lowered(from, 0.), lowered(to, 0.)),
                 {(from[0] + to[0]) / 2., below + 14.}, label);
}

/// The dimensions that hold in every position; those of a sphere do not lie in the plane of the
/// drawing.
Dimensions dimensions(const json& mechanism, const Projection& projection, const UnitSystem units) {
  Dimensions result;
  if (is_spherical(mechanism)) return result;
  const double scale = pixels_per_metre(projection);
  const Pixel centre = projection.at({0., 0., 0.});
  const auto radius = [&](const Pixel& middle, const double length, const double direction) {
    add_radius(result, middle, scale * length, direction, dimension_text("R ", length, units));
  };
  if (const auto diameter = length_named(mechanism, "wheel diameter")) {
    result.lines += circle("class=\"way\"", centre, scale * *diameter / 2.);
    radius(centre, *diameter / 2., 2.);
  }
  const std::optional<Pixel> axis = driver_axis(mechanism, projection);
  if (!axis) return result;
  if (const auto crank = length_named(mechanism, "crank radius")) radius(*axis, *crank, 1.1);
  if (mechanism.contains("locking_radius")) radius(*axis, mechanism.at("locking_radius"), -0.6);
  if (const auto distance = length_named(mechanism, "centre distance"))
    add_distance_below(result, centre, *axis, dimension_text("", *distance, units));
  return result;
}

/// The diameter of a pin, beside the pin.
std::string pin_label(const json& mechanism, const json& step, const Projection& projection,
                      const UnitSystem units) {
  const double diameter = mechanism.at("pin_diameter");
  const Pixel pin = projection.at(step.at("pins").at(0).get<Place>());
  const double away = pixels_per_metre(projection) * diameter / 2. + 14.;
  return label_at("mechanism-pin-label", {pin[0], pin[1] + away},
                  dimension_text("⌀ ", diameter, units));
}

constexpr const char* markers =
    R"(<defs><marker id="arrow" viewBox="0 0 10 10" refX="8" refY="5" markerWidth="5" markerHeight="5" orient="auto"><path class="arrow" d="M0 0L10 5L0 10z"/></marker>
<marker id="dimension-end" viewBox="0 0 10 6" refX="10" refY="3" markerWidth="9" markerHeight="6" markerUnits="userSpaceOnUse" orient="auto-start-reverse"><path class="dimension-end" d="M0 0L10 3L0 6z"/></marker></defs>
)";

}  // namespace

std::string mechanism_drawing(const json& mechanism, const json& step, const std::string& label,
                              const UnitSystem units) {
  const Projection projection = projection_of(mechanism);
  const Dimensions dimensioned = dimensions(mechanism, projection, units);
  return fmt::format(
             "<svg id=\"mechanism-drawing\" viewBox=\"0 0 {} {}\" role=\"img\" "
             "aria-label=\"{}\">\n{}",
             drawing_width, drawing_height, escaped(label), markers) +
         wheel_and_path(mechanism, step, projection) + dimensioned.lines +
         driver(mechanism, step, projection) + dimensioned.labels +
         pin_label(mechanism, step, projection, units) + force_arrow(mechanism, step, projection) +
         "</svg>\n";
}

json drawing_projection(const json& mechanism) {
  const Projection projection = projection_of(mechanism);
  return {{"rows", projection.rows}, {"offset", projection.offset}, {"arrow", arrow_length}};
}

}  // namespace geneva::post
