#include "post/report/mechanism_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "post/report/html.h"
#include "post/report/shown_values.h"

namespace geneva::post {

using nlohmann::json;

namespace {

constexpr double width = 640.;
constexpr double height = 460.;
constexpr double margin = 16.;
constexpr double arrow_length = 80.;  ///< of the greatest force [pixels]

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

Place turned(const Place& place, const double angle) {
  return {place[0] * std::cos(angle) - place[1] * std::sin(angle),
          place[0] * std::sin(angle) + place[1] * std::cos(angle), place[2]};
}

bool is_spherical(const json& mechanism) {
  const json& path = mechanism.at("pin_path");
  return std::any_of(path.begin(), path.end(),
                     [](const json& place) { return place.at(2).get<double>() != 0.; });
}

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
  for (const json& place : mechanism.at("pin_path")) places.push_back(place.get<Place>());
  if (mechanism.contains("driver_axis")) places.push_back(mechanism.at("driver_axis").get<Place>());
  for (const json& step : mechanism.at("steps"))
    if (step.contains("linkage"))
      for (const json& place : step.at("linkage")) places.push_back(place.get<Place>());
  return places;
}

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
  const double scale = std::min((width - 2. * margin) / (high[0] - low[0]),
                                (height - 2. * margin) / (high[1] - low[1]));
  for (auto& row : projection.rows)
    for (double& component : row) component *= scale;
  projection.offset = {width / 2. - scale * (low[0] + high[0]) / 2.,
                       height / 2. - scale * (low[1] + high[1]) / 2.};
  return projection;
}

double pixels_per_metre(const Projection& projection) {
  const Place& row = projection.rows[0];
  return std::hypot(row[0], row[1], row[2]);
}

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

double greatest_force(const json& mechanism) {
  double greatest = 0.;
  for (const json& step : mechanism.at("steps"))
    if (!step.at("pin_force").is_null())
      greatest = std::max(greatest, std::abs(step.at("pin_force").get<double>()));
  return greatest;
}

/// The contact point, and the force on the wheel along the normal of the wall.
std::string force_arrow(const json& mechanism, const json& step, const Projection& projection) {
  if (step.at("engaged_pin").is_null() || greatest_force(mechanism) == 0.)
    return line("id=\"mechanism-force\" class=\"force\"", {0., 0.}, {0., 0.}) +
           circle("id=\"mechanism-contact\" class=\"arrow\"", {0., 0.}, 0.);
  const Place pin = step.at("pins").at(step.at("engaged_pin").get<std::size_t>()).get<Place>();
  const double force = step.at("pin_force");
  const double angle = std::atan2(pin[1], pin[0]);
  const Place normal{-std::sin(angle), std::cos(angle), 0.};
  const double side = force < 0. ? -1. : 1.;
  const double radius = mechanism.at("pin_diameter").get<double>() / 2.;
  const double length =
      arrow_length * std::abs(force) / greatest_force(mechanism) / pixels_per_metre(projection);
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

std::string drawing(const json& mechanism, const json& step, const std::string& label) {
  const Projection projection = projection_of(mechanism);
  const double scale = pixels_per_metre(projection);
  const double angle = step.at("wheel_angle");
  std::string wheel;
  for (const json& loop : mechanism.at("wheel")) wheel += path_data(loop, projection, angle) + "Z";
  std::string svg = fmt::format(
      "<svg id=\"mechanism-drawing\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n"
      "<defs><marker id=\"arrow\" viewBox=\"0 0 10 10\" refX=\"8\" refY=\"5\" markerWidth=\"5\" "
      "markerHeight=\"5\" orient=\"auto\"><path class=\"arrow\" d=\"M0 0L10 5L0 10z\"/></marker>"
      "</defs>\n<path id=\"mechanism-wheel\" class=\"{}\" fill-rule=\"evenodd\" d=\"{}\"/>\n"
      "<path class=\"way\" d=\"{}\"/>\n",
      width, height, escaped(label), is_spherical(mechanism) ? "wheel sphere" : "wheel", wheel,
      path_data(mechanism.at("pin_path"), projection, 0.));
  svg += circle("class=\"axis\"", projection.at({0., 0., 0.}), 3.);
  const bool has_axis = mechanism.contains("driver_axis");
  const Pixel axis = has_axis ? projection.at(mechanism.at("driver_axis").get<Place>()) : Pixel{};
  if (has_axis) svg += circle("class=\"axis\"", axis, 3.);
  if (mechanism.contains("locking_radius"))
    svg += circle("class=\"way\"", axis, scale * mechanism.at("locking_radius").get<double>());
  if (step.contains("linkage"))
    svg += fmt::format("<path id=\"mechanism-linkage\" class=\"link\" d=\"{}\"/>\n",
                       path_data(step.at("linkage"), projection, 0.));
  const json& pins = step.at("pins");
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const Pixel at = projection.at(pins[i].get<Place>());
    if (has_axis) svg += line("class=\"link mechanism-crank\"", axis, at);
    svg += circle("class=\"pin\"", at, scale * mechanism.at("pin_diameter").get<double>() / 2.);
  }
  return svg + force_arrow(mechanism, step, projection) + "</svg>\n";
}

std::string lengths_table(const json& mechanism, const UnitSystem units) {
  HtmlTable table{
      "Lengths of the mechanism", {"length", output_unit(units, Dimension::length).name}, {}};
  for (const json& length : mechanism.at("lengths"))
    table.rows.push_back(
        {escaped(length.at("name")), shown(length.at("length"), Dimension::length, units)});
  return table.html();
}

constexpr const char* controls = R"(<div id="mechanism-controls" class="controls">
<label>Position in the cycle <input type="range" name="step" min="0" max="{}" value="{}"></label>
<button type="button" name="run" aria-pressed="false">Run</button>
</div>
)";

/// What the drawing shows, in words; the script changes the outputs.
std::string readings(const json& step, const UnitSystem units) {
  struct Reading {
    const char* key;
    const char* name;
    Dimension dimension;
  };
  constexpr std::array<Reading, 5> list{
      {{"driver_angle", "driver angle", Dimension::angle},
       {"wheel_angle", "wheel angle", Dimension::angle},
       {"wheel_speed", "wheel speed", Dimension::angular_speed},
       {"wheel_acceleration", "wheel acceleration", Dimension::angular_acceleration},
       {"pin_force", "pin force", Dimension::force}}};
  HtmlTable table{"At this position", {"quantity", "value"}, {}};
  for (const Reading& reading : list)
    table.rows.push_back({escaped(labelled(reading.name, reading.dimension, units)),
                          fmt::format("<output data-key=\"{}\" data-factor=\"{:.17g}\">{}</output>",
                                      reading.key, output_unit(units, reading.dimension).factor,
                                      shown(step.at(reading.key), reading.dimension, units))});
  return "<div id=\"mechanism-readings\">\n" + table.html() + "</div>\n";
}

Chart cycle_chart(const json& mechanism, const UnitSystem units, const char* key,
                  const std::string& name, const Dimension dimension) {
  Chart chart{fmt::format("chart-{}", key),
              fmt::format("The {} over the cycle", name),
              fmt::format("The {} against the driver angle", name),
              {labelled("driver angle", Dimension::angle, units)},
              {labelled(name, dimension, units)},
              {{name, SeriesStyle::line, {}}}};
  const auto point = [&](const json& step) {
    return std::array<double, 2>{in_units(step.at("driver_angle"), Dimension::angle, units),
                                 in_units(step.at(key), dimension, units)};
  };
  for (const json& step : mechanism.at("steps")) chart.series[0].points.push_back(point(step));
  if (mechanism.contains("analysed"))
    chart.series.push_back({"analysed", SeriesStyle::markers, {point(mechanism.at("analysed"))}});
  return chart;
}

/// The step nearest to a driver angle.
std::size_t nearest_step(const json& mechanism, const json& step) {
  const json& steps = mechanism.at("steps");
  const double angle = step.at("driver_angle");
  const auto distance = [&](const json& one) {
    return std::abs(one.at("driver_angle").get<double>() - angle);
  };
  const auto nearest =
      std::min_element(steps.begin(), steps.end(),
                       [&](const json& a, const json& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - steps.begin());
}

}  // namespace

json drawing_projection(const json& mechanism) {
  const Projection projection = projection_of(mechanism);
  return {{"rows", projection.rows}, {"offset", projection.offset}, {"arrow", arrow_length}};
}

ReportPart mechanism_part(const json& mechanism, const UnitSystem units) {
  const bool is_analysed = mechanism.contains("analysed");
  const json& step = is_analysed ? mechanism.at("analysed") : mechanism.at("steps").at(0);
  const std::string label =
      fmt::format("{} at a driver angle of {} {}", mechanism.at("name").get<std::string>(),
                  shown(step.at("driver_angle"), Dimension::angle, units),
                  output_unit(units, Dimension::angle).name);
  ReportPart part;
  part.charts = {
      cycle_chart(mechanism, units, "wheel_speed", "wheel speed", Dimension::angular_speed),
      cycle_chart(mechanism, units, "wheel_acceleration", "wheel acceleration",
                  Dimension::angular_acceleration),
      cycle_chart(mechanism, units, "pin_force", "pin force", Dimension::force)};
  part.html = html_section(
      "mechanism", "Mechanism",
      fmt::format("<div class=\"beside\">\n<figure>\n{}<figcaption>{}{}</figcaption>\n{}</figure>\n"
                  "<div>\n{}{}</div>\n</div>\n{}",
                  drawing(mechanism, step, label), escaped(label),
                  is_analysed ? ", which is analysed; the dot is the contact point, the arrow the "
                                "pin force on the wheel"
                              : "",
                  fmt::format(fmt::runtime(controls), mechanism.at("steps").size() - 1,
                              nearest_step(mechanism, step)),
                  readings(step, units), lengths_table(mechanism, units), html(part.charts)));
  return part;
}

}  // namespace geneva::post
