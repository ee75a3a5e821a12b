#include "post/report/estimate_section.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "post/report/html.h"
#include "post/report/shown_values.h"

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
              {fmt::format("{} [{}]", across_label, table.column(across).unit)},
              {fmt::format("{} [{}]", up_label, table.column(up).unit)},
              {}};
  ChartSeries series{up_label, SeriesStyle::line, {}};
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    series.points.push_back({table.column(across).values[i], table.column(up).values[i]});
  chart.series.push_back(series);
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
               : chart_of(table, "depth", "depth", "shear", "shear below the contact")};
  return {html_section(
              "estimate", "Estimate",
              figures_table(estimate, results.units()) + left_out_list(estimate) + html(charts)),
          charts};
}

}  // namespace geneva::post
