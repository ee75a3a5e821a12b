#include "post/report/sections/run_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"

namespace geneva::post {

using base::Dimension;
using base::dimension_named;
using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;

using nlohmann::json;

namespace {

ChartSeries series(const std::string& name, const SeriesStyle style, const std::vector<double>& x,
                   const std::vector<double>& y) {
  ChartSeries result{name, style, {}};
  for (std::size_t i = 0; i < x.size(); ++i) result.points.push_back({x[i], y[i]});
  return result;
}

/// Every third point: a curve below the markers stays visible.
void thin_out(ChartSeries& series) {
  std::vector<std::array<double, 2>> kept;
  for (std::size_t i = 0; i < series.points.size(); i += 3) kept.push_back(series.points[i]);
  series.points = kept;
}

std::string axis_label(const std::string& name, const CsvColumn& column) {
  return column.unit.empty() ? name : fmt::format("{} [{}]", name, shown_unit(column.unit));
}

/// "pin -> driving wall".
std::string name_of_pair(const json& contact) {
  return fmt::format("{} -> {}", contact.at("source").get<std::string>(),
                     contact.at("target").get<std::string>());
}

/// The rows of the contact pair with the maximum pressure.
CsvTable leading_rows(const ResultsDirectory& results, const std::string& table) {
  return results.table(table)->rows_with("pair",
                                         name_of_pair(results.document("summary")->at("contact")));
}

/// Hertz's pressure, p0 sqrt(1 - (x/b)^2), over twice the half-width b to either side.
ChartSeries hertz_curve(const json& contact, const UnitSystem units, const bool is_axis) {
  const double peak = in_units(contact.at("hertz").at("peak_pressure"), Dimension::stress, units);
  const double half_width =
      in_units(contact.at("hertz").at("half_width"), Dimension::length, units);
  constexpr int n_per_half_width = 100;
  ChartSeries curve{"Hertz", SeriesStyle::line, {}};
  for (int i = is_axis ? 0 : -2 * n_per_half_width; i <= 2 * n_per_half_width; ++i) {
    const double x = static_cast<double>(i) / n_per_half_width;
    curve.points.push_back({x * half_width, peak * std::sqrt(std::max(0., 1. - x * x))});
  }
  return curve;
}

/// What tells the chart of one contact from that of another.
struct ChartOfContact {
  const char* id;
  const char* title;
  const char* where;
};

/// Friction on the source along its surface, towards greater arc length.
std::vector<double> friction_along(const CsvTable& rows) {
  const std::vector<double>& x = rows.column("x").values;
  const std::vector<double>& y = rows.column("y").values;
  const std::vector<double>& qx = rows.column("friction_x").values;
  const std::vector<double>& qy = rows.column("friction_y").values;
  std::vector<double> along;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : i;
    const std::size_t after = i + 1 < x.size() ? i + 1 : i;
    const double dx = x[after] - x[before];
    const double dy = y[after] - y[before];
    const double length = std::hypot(dx, dy);
    along.push_back(length > 0. ? (qx[i] * dx + qy[i] * dy) / length : 0.);
  }
  return along;
}

/// Pressure along a contact of a plane model, two half-widths to either side of its middle.
/// @param contact one of `contact_pairs`
Chart pressure_chart(const ResultsDirectory& results, const json& contact,
                     const ChartOfContact& about) {
  const UnitSystem units = results.units();
  const CsvTable rows = results.table("contact")->rows_with("pair", name_of_pair(contact));
  const CsvColumn& arc = rows.column("arc_length");
  const CsvColumn& pressure = rows.column("contact_pressure");
  double force = 0.;
  double moment = 0.;
  for (std::size_t i = 0; i < arc.values.size(); ++i) {
    force += pressure.values[i];
    moment += pressure.values[i] * arc.values[i];
  }
  const double half_width = in_units(contact.at("half_width"), Dimension::length, units);
  const bool is_axis = std::abs(arc.values.front()) < half_width && pressure.values.front() > 0.;
  const double middle = is_axis ? arc.values.front() : force > 0. ? moment / force : 0.;
  Chart chart{about.id,
              about.title,
              fmt::format("Contact pressure along {}; its maximum value is {} {}", about.where,
                          shown(contact.at("peak_pressure"), Dimension::stress, units),
                          shown_unit(pressure.unit)),
              {axis_label("distance from the middle of the contact", arc)},
              {axis_label("contact pressure", pressure)},
              {{"this program", SeriesStyle::markers, {}}}};
  std::vector<double> friction;
  if (contact.contains("friction")) {
    friction = friction_along(rows);
    chart.series.push_back({"friction on the source", SeriesStyle::markers, {}});
    chart.y = {axis_label("contact pressure, friction", pressure)};
  }
  for (std::size_t i = 0; i < arc.values.size(); ++i) {
    const double at = arc.values[i] - middle;
    if (std::abs(at) > 2. * half_width) continue;
    chart.series[0].points.push_back({at, pressure.values[i]});
    if (!friction.empty()) chart.series[1].points.push_back({at, friction[i]});
  }
  constexpr std::size_t dense = 100;  // markers would hide the curve below them
  if (chart.series[0].points.size() > dense)
    for (ChartSeries& series : chart.series) series.style = SeriesStyle::line;
  if (contact.contains("hertz")) chart.series.push_back(hertz_curve(contact, units, is_axis));
  return chart;
}

/// Of the contact with the maximum pressure and, of a roller, of its bore.
std::vector<Chart> pressure_charts(const ResultsDirectory& results) {
  const json& summary = *results.document("summary");
  const std::string leading = name_of_pair(summary.at("contact"));
  std::vector<Chart> charts;
  for (const json& contact : summary.at("contact_pairs")) {
    if (name_of_pair(contact) == leading)
      charts.push_back(pressure_chart(
          results, contact, {"chart-pressure", "Contact pressure beside Hertz's", "the contact"}));
    if (contact.at("source") == "stud" && summary.contains("roller"))
      charts.push_back(pressure_chart(
          results, contact,
          {"chart-bore", "Contact pressure in the roller's bore", "the roller's bore"}));
  }
  return charts;
}

Chart depth_chart(const ResultsDirectory& results) {
  const CsvTable table = leading_rows(results, "depth");
  const CsvColumn& depth = table.column("depth");
  Chart chart{"chart-depth",
              "Stress below the middle of the contact beside McEwen's",
              "Normal stresses and maximum shear against the depth below the contact",
              {axis_label("depth", depth)},
              {axis_label("stress", table.column("stress_along"))},
              {}};
  const std::array<std::array<const char*, 2>, 3> stresses{{{"stress_along", "along the contact"},
                                                            {"stress_across", "across it"},
                                                            {"maximum_shear", "maximum shear"}}};
  for (const auto& [column, name] : stresses) {
    chart.series.push_back(
        series(name, SeriesStyle::markers, depth.values, table.column(column).values));
    thin_out(chart.series.back());
    const std::vector<double>& exact = table.column(std::string("mcewen_") + column).values;
    if (std::any_of(exact.begin(), exact.end(), [](const double x) { return std::isfinite(x); }))
      chart.series.push_back(
          series(std::string(name) + ", McEwen", SeriesStyle::line, depth.values, exact));
  }
  return chart;
}

/// Slope of the straight line through the last points of log y over log x.
double last_slope(const std::vector<std::array<double, 2>>& points) {
  if (points.size() < 2) return std::nan("");
  const auto& [x0, y0] = points[points.size() - 2];
  const auto& [x1, y1] = points.back();
  return std::log(y1 / y0) / std::log(x1 / x0);
}

Chart error_chart(const json& summary) {
  const std::string of = summary.at("accuracy").at("of");
  Chart chart{"chart-error",
              "",
              "",
              {"unknowns", true},
              {"estimated relative error", true},
              {{"error estimate", SeriesStyle::line, {}}, {"asked for", SeriesStyle::dashed, {}}}};
  const double accuracy = summary.at("case").at("accuracy");
  for (const json& level : summary.at("solver").at("levels")) {
    const double error = level.at("error_estimate");
    if (error >= 1.) continue;
    chart.series[0].points.push_back({level.at("dofs").get<double>(), error});
    chart.series[1].points.push_back({level.at("dofs").get<double>(), accuracy});
  }
  const double slope = last_slope(chart.series[0].points);
  chart.title =
      std::isfinite(slope) && std::abs(slope) > 0.005  // a mesh for stresses elsewhere has none
          ? fmt::format("Estimated error of the {}; slope {:.2f} over the last two meshes", of,
                        slope)
          : "Estimated error of the " + of;
  chart.summary = chart.title;
  return chart;
}

/// The peak contact pressure on every mesh, without contact the maximum von Mises stress.
Chart convergence_chart(const json& summary, const UnitSystem units) {
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const bool has_contact = summary.contains("contact");
  const bool is_unbounded = has_contact && summary.at("contact").contains("edge") &&
                            summary.at("contact").at("edge").at("bounded") == false;
  const std::string title = is_unbounded  ? "Pressure at the edge, which is not bounded"
                            : has_contact ? "Peak contact pressure"
                                          : "Maximum von Mises stress";
  const std::string label = has_contact ? "peak contact pressure" : "maximum von Mises stress";
  const char* const key = has_contact ? "peak_pressure" : "maximum_von_mises";
  Chart chart{"chart-convergence",
              title + ", mesh by mesh",
              title + " against the number of unknowns",
              {"unknowns", true},
              {fmt::format("{} [{}]", label, stress.name), true},
              {{"this program", SeriesStyle::line, {}}}};
  for (const json& level : summary.at("solver").at("levels"))
    chart.series[0].points.push_back(
        {level.at("dofs").get<double>(), number_of(level.at(key)) * stress.factor});
  return chart;
}

Chart line_load_chart(const ResultsDirectory& results, const UnitSystem units) {
  const CsvTable table = leading_rows(results, "sections");
  const CsvColumn& z = table.column("z");
  const CsvColumn& load = table.column("line_load");
  Chart chart{"chart-line-load",
              "Line load along the pin",
              "Line load along the pin, beside that of an even load",
              {axis_label("place along the pin, z", z)},
              {axis_label("line load", load)},
              {series("this program", SeriesStyle::line, z.values, load.values)}};
  if (table.has_column("line_load_half_space_and_beam"))
    chart.series.push_back(series("half-space and beam", SeriesStyle::dashed, z.values,
                                  table.column("line_load_half_space_and_beam").values));
  else
    for (const json& row : results.document("summary")->at("comparison"))
      if (row.at("quantity") == "line load, middle" && !row.at("closed_form").is_null()) {
        const double even = in_units(row.at("closed_form"), Dimension::force_per_length, units);
        chart.series.push_back({"even load",
                                SeriesStyle::dashed,
                                {{z.values.front(), even}, {z.values.back(), even}}});
      }
  return chart;
}

Chart section_pressure_chart(const ResultsDirectory& results) {
  const CsvTable table = leading_rows(results, "sections");
  const CsvColumn& z = table.column("z");
  const CsvColumn& pressure = table.column("peak_pressure");
  return {"chart-section-pressure",
          "Maximum contact pressure along the pin",
          "Maximum contact pressure of each section along the pin",
          {axis_label("place along the pin, z", z)},
          {axis_label("contact pressure", pressure)},
          {series("this program", SeriesStyle::line, z.values, pressure.values)}};
}

std::vector<Chart> contact_charts(const ResultsDirectory& results, const UnitSystem units) {
  if (results.document("summary")->at("case").at("dimension") == 2) {
    std::vector<Chart> charts = pressure_charts(results);
    charts.push_back(depth_chart(results));
    return charts;
  }
  if (leading_rows(results, "sections").n_rows() < 2) return {};
  return {line_load_chart(results, units), section_pressure_chart(results)};
}

std::string effort_table(const json& summary) {
  HtmlTable table{
      "What it took, mesh by mesh",
      {"mesh", "unknowns", "nodes in contact", "active-set steps", "error estimate", "time [s]"},
      {}};
  const json& levels = summary.at("solver").at("levels");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double error = levels[i].at("error_estimate");
    table.rows.push_back({std::to_string(i + 1), grouped(levels[i].at("dofs").dump()),
                          grouped(levels[i].at("active_nodes").dump()),
                          levels[i].at("active_set_iterations").dump(),
                          error < 1. ? fmt::format("{:.2g} %", 100. * error) : "–",
                          fmt::format("{:.2f}", number_of(levels[i].at("elapsed")))});
  }
  return table.html();
}

}  // namespace

ReportPart contact_part(const ResultsDirectory& results) {
  if (!results.document("summary")->contains("contact")) return {};
  const std::vector<Chart> charts = contact_charts(results, results.units());
  if (charts.empty()) return {};
  return {html_section("contact", "Contact", html(charts)), charts};
}

ReportPart convergence_part(const ResultsDirectory& results) {
  const json& summary = *results.document("summary");
  const std::vector<Chart> charts{convergence_chart(summary, results.units()),
                                  error_chart(summary)};
  return {html_section("convergence", "Convergence", html(charts) + effort_table(summary)), charts};
}

}  // namespace geneva::post
