#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace geneva::post {

/// An axis of a chart: "contact pressure [psi]".
struct ChartAxis {
  std::string label;
  bool is_logarithmic = false;
};

enum class SeriesStyle { line, dashed, markers };

/// Points (x, y) joined in their order; a line is interrupted where y is not a number.
struct ChartSeries {
  std::string name;
  SeriesStyle style;
  std::vector<std::array<double, 2>> points;
};

/// A chart of the report; the browser draws it.
struct Chart {
  std::string id;
  std::string title;
  std::string summary;  ///< what the chart shows, in words, for who cannot see it
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartSeries> series;
};

/// What the drawing code reads; null for what is not a number.
nlohmann::json to_json(const Chart& chart);

/// The places on the page where charts appear; nothing without charts.
std::string html(const std::vector<Chart>& charts);

}  // namespace geneva::post
