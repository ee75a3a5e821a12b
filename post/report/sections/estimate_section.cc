#include "post/report/sections/estimate_section.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"

namespace geneva::post {

using nlohmann::json;

namespace {

std::string figures_table(const json& estimate, const base::UnitSystem units) {
  HtmlTable table{"The contact without finite elements", {"quantity", "estimate", "by"}, {}};
  for (const json& row : estimate.at("estimate")) {
    const base::Dimension dimension = base::dimension_named(row.at("dimension"));
    table.rows.push_back({escaped(labelled(row.at("quantity"), dimension, units)),
                          shown(row.at("value"), dimension, units), escaped(row.at("basis"))});
  }
  return table.html();
}

std::string left_out_list(const json& estimate) {
  std::string text = "<p>Left out:</p>\n<ul>\n";
  for (const json& sentence : estimate.at("left_out"))
    text += "<li>" + escaped(sentence.get<std::string>()) + "</li>\n";
  return text + "</ul>\n";
}

/// Of the second column against the first one, in the units of the file.
Chart chart_of(const CsvTable& table, const char* const across, const std::string& across_label,
               const char* const up, const std::string& up_label) {
  Chart chart{fmt::format("chart-estimate-{}", up),
              up_label,
              fmt::format("Estimate of the {}", up_label),
              {fmt::format("{} [{}]", across_label, shown_unit(table.column(across).unit))},
              {fmt::format("{} [{}]", up_label, shown_unit(table.column(up).unit))},
              {}};
  ChartSeries series{up_label, SeriesStyle::line, {}};
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    series.points.push_back({table.column(across).values[i], table.column(up).values[i]});
  chart.series.push_back(series);
  return chart;
}

/// Pressure over the engagements: Hertz's of an even load, and that of line contacts.
Chart engagement_chart(const json& estimate, const base::UnitSystem units) {
  const json& points = estimate.at("engagement");
  const double degrees = base::output_unit(units, base::Dimension::angle).factor;
  const double factor = base::output_unit(units, base::Dimension::stress).factor;
  Chart chart{"chart-estimate-engagement",
              "Contact pressure over the engagement",
              "Estimate of the contact pressure against the driver angle",
              {labelled("driver angle", base::Dimension::angle, units)},
              {labelled("contact pressure", base::Dimension::stress, units)},
              {{"even load", SeriesStyle::dashed, {}}}};
  ChartSeries peak{"half-space and beam", SeriesStyle::line, {}};
  for (std::size_t i = 0; i < points.at("driver_angle").size(); ++i) {
    const double angle = points.at("driver_angle")[i].get<double>() * degrees;
    chart.series[0].points.push_back({angle, points.at("even_pressure")[i].get<double>() * factor});
    if (const json& pressure = points.at("peak_pressure")[i]; !pressure.is_null())
      peak.points.push_back({angle, pressure.get<double>() * factor});
  }
  if (!peak.points.empty()) chart.series.push_back(peak);
  return chart;
}

}  // namespace

ReportPart estimate_part(const ResultsDirectory& results) {
  const json& estimate = *results.document("estimate");
  const CsvTable& table = *results.table("estimate");
  const bool has_line = estimate.contains("half_space_and_beam");
  const std::vector<Chart> charts{
      has_line ? chart_of(table, "z", "place along the pin, z", "pressure",
                          "maximum pressure along the pin")
               : chart_of(table, "depth", "depth", "shear", "shear below the contact"),
      engagement_chart(estimate, results.units())};
  return {html_section(
              "estimate", "Estimate",
              figures_table(estimate, results.units()) + left_out_list(estimate) + html(charts)),
          charts};
}

}  // namespace geneva::post
