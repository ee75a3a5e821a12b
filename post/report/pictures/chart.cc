#include "post/report/pictures/chart.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_values.h"
#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"

namespace geneva::post {

using base::finite;
using base::output_unit;

using nlohmann::json;

namespace {

const char* name_of(const SeriesStyle style) {
  switch (style) {
    case SeriesStyle::dashed:
      return "dashed";
    case SeriesStyle::markers:
      return "markers";
    case SeriesStyle::wide:
      return "wide";
    case SeriesStyle::line:
      break;
  }
  return "line";
}

json axis(const ChartAxis& axis) {
  return {{"label", axis.label}, {"logarithmic", axis.is_logarithmic}, {"step", axis.step}};
}

std::string place_of(const Chart& chart) {
  return fmt::format(
      "<figure class=\"chart\">\n<div class=\"canvas\"><canvas id=\"{}\" role=\"img\" "
      "aria-label=\"{}\"></canvas></div>\n<figcaption>{}</figcaption>\n</figure>\n",
      chart.id, escaped(chart.summary), escaped(chart.title));
}

}  // namespace

ChartAxis driver_angle_axis(const base::UnitSystem units) {
  const double step = std::acos(-1.) / 4. * output_unit(units, base::Dimension::angle).factor;
  return {labelled("driver angle", base::Dimension::angle, units), false, step};
}

json to_json(const Chart& chart) {
  json series = json::array();
  for (const ChartSeries& one : chart.series) {
    json points = json::array();
    for (const auto& [x, y] : one.points) points.push_back({finite(x), finite(y)});
    series.push_back({{"name", one.name}, {"style", name_of(one.style)}, {"points", points}});
  }
  return {{"id", chart.id},
          {"over_cycle", chart.is_over_cycle},
          {"x", axis(chart.x)},
          {"y", axis(chart.y)},
          {"series", series}};
}

std::string html(const std::vector<Chart>& charts) {
  if (charts.empty()) return "";
  std::string text = "<div class=\"charts\">\n";
  for (const Chart& chart : charts) text += place_of(chart);
  return text + "</div>\n";
}

}  // namespace geneva::post
