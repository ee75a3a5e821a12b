#include "post/report/chart.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/json_values.h"
#include "post/report/html.h"

namespace geneva::post {

using base::finite;

using nlohmann::json;

namespace {

const char* name_of(const SeriesStyle style) {
  switch (style) {
    case SeriesStyle::dashed:
      return "dashed";
    case SeriesStyle::markers:
      return "markers";
    case SeriesStyle::line:
      break;
  }
  return "line";
}

json axis(const ChartAxis& axis) {
  return {{"label", axis.label}, {"logarithmic", axis.is_logarithmic}};
}

std::string place_of(const Chart& chart) {
  return fmt::format(
      "<figure class=\"chart\">\n<div class=\"canvas\"><canvas id=\"{}\" role=\"img\" "
      "aria-label=\"{}\"></canvas></div>\n<figcaption>{}</figcaption>\n</figure>\n",
      chart.id, escaped(chart.summary), escaped(chart.title));
}

}  // namespace

json to_json(const Chart& chart) {
  json series = json::array();
  for (const ChartSeries& one : chart.series) {
    json points = json::array();
    for (const auto& [x, y] : one.points) points.push_back({finite(x), finite(y)});
    series.push_back({{"name", one.name}, {"style", name_of(one.style)}, {"points", points}});
  }
  return {{"id", chart.id}, {"x", axis(chart.x)}, {"y", axis(chart.y)}, {"series", series}};
}

std::string html(const std::vector<Chart>& charts) {
  if (charts.empty()) return "";
  std::string text = "<div class=\"charts\">\n";
  for (const Chart& chart : charts) text += place_of(chart);
  return text + "</div>\n";
}

}  // namespace geneva::post
