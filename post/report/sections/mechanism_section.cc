#include "post/report/sections/mechanism_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/pictures/mechanism_drawing.h"

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::UnitSystem;

using nlohmann::json;

namespace {

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
<button type="button" name="run" aria-pressed="false">Play</button>
</div>
)";

/// What the drawing shows, in words; the script changes the outputs.
std::string readings(const json& step, const UnitSystem units) {
  constexpr std::array<NamedQuantity, 5> list{
      {{"driver_angle", "driver angle", Dimension::angle},
       {"wheel_angle", "wheel angle", Dimension::angle},
       {"wheel_speed", "wheel speed", Dimension::angular_speed},
       {"wheel_acceleration", "wheel acceleration", Dimension::angular_acceleration},
       {"pin_force", "pin force", Dimension::force}}};
  HtmlTable table{"At this position", {"quantity", "value"}, {}};
  for (const NamedQuantity& reading : list)
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
              driver_angle_axis(units),
              {labelled(name, dimension, units)},
              {{name, SeriesStyle::line, {}}}};
  const auto point = [&](const json& step) {
    return std::array<double, 2>{in_units(step.at("driver_angle"), Dimension::angle, units),
                                 in_units(step.at(key), dimension, units)};
  };
  for (const json& step : mechanism.at("steps")) chart.series[0].points.push_back(point(step));
  if (mechanism.contains("analysed"))
    chart.series.push_back({"analysed", SeriesStyle::markers, {point(mechanism.at("analysed"))}});
  chart.is_over_cycle = true;
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

ReportPart mechanism_part(const json& mechanism, const UnitSystem units) {
  const bool is_analysed = mechanism.contains("analysed");
  const json& step = is_analysed ? mechanism.at("analysed") : mechanism.at("steps").at(0);
  const std::string name = mechanism.at("name");
  const std::string angle = shown(step.at("driver_angle"), Dimension::angle, units);
  const std::string unit = output_unit(units, Dimension::angle).name;
  const std::string label = fmt::format("{} at a driver angle of {} {}", name, angle, unit);
  ReportPart part;
  part.charts = {
      cycle_chart(mechanism, units, "wheel_speed", "wheel speed", Dimension::angular_speed),
      cycle_chart(mechanism, units, "wheel_acceleration", "wheel acceleration",
                  Dimension::angular_acceleration),
      cycle_chart(mechanism, units, "pin_force", "pin force", Dimension::force)};
  part.html = html_section(
      "mechanism", "Mechanism",
      fmt::format(
          "<div class=\"beside\">\n<figure>\n{}<figcaption>{} at a driver angle of "
          "<output id=\"mechanism-angle\">{}</output> {}<span id=\"mechanism-analysed\">"
          "{}</span>; where the pin presses, the dot is the contact point, the arrow the pin "
          "force on the wheel"
          "</figcaption>\n{}</figure>\n<div>\n{}{}</div>\n</div>\n{}",
          mechanism_drawing(mechanism, step, label, units), escaped(name), angle, unit,
          is_analysed ? ", which is analysed" : "",
          fmt::format(fmt::runtime(controls), mechanism.at("steps").size() - 1,
                      nearest_step(mechanism, step)),
          readings(step, units), lengths_table(mechanism, units), html(part.charts)));
  return part;
}

}  // namespace geneva::post
