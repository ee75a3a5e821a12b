#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/units.h"

namespace geneva::post {

// What is made of lists has constructors: g++ 12 destroys members of nested aggregates twice where
// making one of them throws.

/// An axis of a chart: "contact pressure [psi]".
struct ChartAxis {
  ChartAxis() = default;
  ChartAxis(std::string text, const bool logarithmic = false, const double its_step = 0.)
      : label(std::move(text)), is_logarithmic(logarithmic), step(its_step) {}

  std::string label;
  bool is_logarithmic = false;
  double step = 0.;  ///< its marks are multiples of it; 0: as the range asks for
};

enum class SeriesStyle { line, dashed, markers, wide };

/// Points (x, y) joined in their order; a line is interrupted where y is not a number.
struct ChartSeries {
  ChartSeries(std::string its_name, const SeriesStyle its_style,
              std::vector<std::array<double, 2>> its_points)
      : name(std::move(its_name)), style(its_style), points(std::move(its_points)) {}

  std::string name;
  SeriesStyle style;
  std::vector<std::array<double, 2>> points;
};

/// A chart of the report; the browser draws it.
struct Chart {
  Chart() = default;
  Chart(std::string its_id, std::string its_title, std::string its_summary, ChartAxis its_x,
        ChartAxis its_y, std::vector<ChartSeries> its_series)
      : id(std::move(its_id)),
        title(std::move(its_title)),
        summary(std::move(its_summary)),
        x(std::move(its_x)),
        y(std::move(its_y)),
        series(std::move(its_series)) {}

  std::string id;
  std::string title;
  std::string summary;  ///< what the chart shows, in words, for who cannot see it
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartSeries> series;
  bool is_over_cycle = false;  ///< x is the driver angle: the drawing's position is shown in it
};

/// The axis of a chart over the driver angle: marks at multiples of 45 degrees.
ChartAxis driver_angle_axis(base::UnitSystem units);

/// What the drawing code reads; null for what is not a number.
nlohmann::json to_json(const Chart& chart);

/// The places on the page where charts appear; nothing without charts.
std::string html(const std::vector<Chart>& charts);

}  // namespace geneva::post
