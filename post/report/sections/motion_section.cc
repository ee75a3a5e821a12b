#include "post/report/sections/motion_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/sections/limits.h"

namespace geneva::post {

using base::Dimension;
using base::dimension_named;
using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;

using nlohmann::json;

namespace {

/// "t_m" with its letter lowered, on one line.
std::string html_symbol(const std::string& symbol) {
  if (symbol.empty()) return "";
  std::string html = "<span class=\"symbol\">";
  for (std::size_t i = 0; i < symbol.size(); ++i)
    if (symbol[i] == '_' && i + 1 < symbol.size())
      html += fmt::format("<sub>{}</sub>", symbol[++i]);
    else
      html += symbol[i];
  return html + "</span>";
}

std::string characteristics_table(const json& kinematics, const UnitSystem units) {
  HtmlTable table{
      "Characteristic values of the motion",
      {"quantity", "symbol", "value", labelled("at a driver angle of", Dimension::angle, units)},
      {}};
  for (const json& row : kinematics.at("characteristics")) {
    const Dimension dimension = dimension_named(row.at("dimension"));
    const std::string quantity = row.at("quantity");
    const std::string symbol = row.value("symbol", "");
    const std::size_t first = quantity.find_first_not_of(' ');
    const std::size_t name_end = symbol.empty() ? std::string::npos : quantity.find(", " + symbol);
    const std::string name = quantity.substr(first, name_end - first);
    table.rows.push_back(
        {fmt::format("{}<abbr title=\"{}\">{}</abbr>", first > 0 ? "&emsp;" : "",
                     escaped(row.value("meaning", "")), escaped(labelled(name, dimension, units))),
         html_symbol(symbol), shown(row.at("value"), dimension, units),
         shown(row.at("driver_angle"), Dimension::angle, units)});
  }
  return table.html();
}

/// A roller beside a fixed pin; empty for a fixed pin.
std::string choice_table(const json& kinematics, const UnitSystem units) {
  if (!kinematics.contains("roller_or_fixed_pin")) return "";
  HtmlTable table{
      "The roller beside a pin of its diameter that is fixed to its carrier and has its "
      "coefficient of friction",
      {"quantity", "roller", "fixed pin"},
      {}};
  for (const json& row : kinematics.at("roller_or_fixed_pin")) {
    const Dimension dimension = dimension_named(row.at("dimension"));
    table.rows.push_back({escaped(labelled(row.at("quantity"), dimension, units)),
                          shown(row.at("roller"), dimension, units),
                          shown(row.at("fixed"), dimension, units)});
  }
  return table.html();
}

std::string unbounded_warnings(const json& kinematics, const UnitSystem units) {
  std::string text;
  for (const json& place : kinematics.at("unbounded"))
    text += fmt::format(
        "<p class=\"warning\"><strong>Not bounded:</strong> the {} at {} {}: {}</p>\n",
        escaped(place.at("quantity")), shown(place.at("driver_angle"), Dimension::angle, units),
        output_unit(units, Dimension::angle).name, escaped(place.at("cause")));
  return text;
}

Chart column_chart(const CsvTable& table, const std::string& x_column, const std::string& x_name,
                   const std::string& column, const std::string& name) {
  const CsvColumn& x = table.column(x_column);
  const CsvColumn& y = table.column(column);
  Chart chart{"chart-" + column,
              fmt::format("The {}", name),
              fmt::format("The {} against the {}", name, x_name),
              {fmt::format("{} [{}]", x_name, shown_unit(x.unit))},
              {fmt::format("{} [{}]", name, shown_unit(y.unit))},
              {{name, SeriesStyle::line, {}}}};
  for (std::size_t i = 0; i < x.values.size(); ++i)
    chart.series[0].points.push_back({x.values[i], y.values[i]});
  return chart;
}

/// How the pin slides: its surface on the wall that carries, or a roller on its stud, beside its
/// axis along the slot.
Chart slip_chart(const CsvTable& table, const bool is_roller) {
  Chart chart = is_roller ? column_chart(table, "driver_angle", "driver angle", "bore_speed",
                                         "sliding speed of the roller on its stud")
                          : column_chart(table, "driver_angle", "driver angle", "slip_speed",
                                         "slip speed of the pin on the wall that carries");
  const Chart travel = column_chart(table, "driver_angle", "driver angle", "travel_speed",
                                    "speed of the pin's axis along the slot");
  chart.series.push_back({travel.series[0].name, SeriesStyle::dashed, travel.series[0].points});
  chart.y.label = fmt::format("speed [{}]", shown_unit(table.column("travel_speed").unit));
  return chart;
}

/// Makes a chart one over the driver angle, and marks the angle that a run of the case analyses.
void lay_over_cycle(const ResultsDirectory& results, Chart& chart) {
  chart.x = driver_angle_axis(results.units());
  chart.is_over_cycle = true;
  const json* const mechanism = results.document("mechanism");
  if (mechanism == nullptr || !mechanism->contains("analysed")) return;
  const double angle =
      in_units(mechanism->at("analysed").at("driver_angle"), Dimension::angle, results.units());
  const auto& curve = chart.series.front().points;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const auto& [x0, y0] = curve[i];
    const auto& [x1, y1] = curve[i + 1];
    if (!(x0 <= angle && angle <= x1 && x0 < x1)) continue;
    chart.series.push_back(
        {"analysed", SeriesStyle::markers, {{angle, y0 + (angle - x0) / (x1 - x0) * (y1 - y0)}}});
    return;
  }
}

/// The wheels of a design side by side; the keys of design.json.
std::string wheels_table(const json& design, const UnitSystem units) {
  struct Line {
    const char* name;
    Dimension dimension;
    const char* of_best;  ///< key of the two best wheels
    const char* of_case;  ///< key of the case's wheel
  };
  constexpr std::array<Line, 7> lines{
      {{"diameter", Dimension::length, "optimum_diameter", "diameter"},
       {"pin diameter", Dimension::length, "pin_diameter", "pin_diameter"},
       {"thickness", Dimension::length, "thickness", "thickness"},
       {"locking radius", Dimension::length, "locking_radius", "locking_radius"},
       {"moment of inertia", Dimension::inertia, "optimum_inertia", "inertia"},
       {"pin force", Dimension::force, "force", "force"},
       {"peak contact pressure", Dimension::stress, "peak_pressure", "peak_pressure"}}};
  HtmlTable table{"Johnson's wheel of minimum contact stress beside the wheel of the case",
                  {"", "best, Johnson's proportions", "best as drawn", "wheel of the case"},
                  {}};
  for (const Line& line : lines) {
    const auto cell = [&](const json& wheel, const char* key) {
      return wheel.contains(key) ? shown(wheel.at(key), line.dimension, units) : "–";
    };
    table.rows.push_back({escaped(labelled(line.name, line.dimension, units)),
                          cell(design, line.of_best), cell(design.at("geometry"), line.of_best),
                          cell(design.at("wheel"), line.of_case)});
  }
  return table.html();
}

/// A wheel's diameter and pressure as one point.
ChartSeries wheel_point(const std::string& name, const json& wheel, const char* diameter,
                        const UnitSystem units) {
  return {name,
          SeriesStyle::markers,
          {{in_units(wheel.at(diameter), Dimension::length, units),
            in_units(wheel.at("peak_pressure"), Dimension::stress, units)}}};
}

constexpr double flat_share = 0.01;

/// The part of the curve of drawn wheels with at most 1 % more than the least pressure.
std::vector<std::array<double, 2>> flat_range(const CsvTable& table) {
  const std::vector<double>& diameters = table.column("diameter").values;
  const std::vector<double>& pressures = table.column("stress_geometry").values;
  double least = std::numeric_limits<double>::infinity();
  for (const double pressure : pressures)
    if (std::isfinite(pressure)) least = std::min(least, pressure);
  std::vector<std::array<double, 2>> range;
  for (std::size_t i = 0; i < diameters.size(); ++i)
    if (pressures[i] <= (1. + flat_share) * least) range.push_back({diameters[i], pressures[i]});
  return range;
}

/// The best wheel in large type, with the inertia that the case's wheel has, and how far the
/// diameter may be off it.
std::string design_answer(const ResultsDirectory& results) {
  const json& design = *results.document("design");
  const UnitSystem units = results.units();
  const std::string length = output_unit(units, Dimension::length).name;
  const bool is_johnsons =
      design.contains("optimum_diameter") && design.at("wheel").at("has_johnsons_inertia") == true;
  const auto wheel_in_words = [&](const json& wheel) {
    return fmt::format("⌀ {} {}", shown(wheel.at("optimum_diameter"), Dimension::length, units),
                       length);
  };
  const json& best = is_johnsons ? design : design.at("geometry");
  std::string text = answer(is_johnsons ? "best wheel, Johnson's inertia" : "best wheel, as drawn",
                            wheel_in_words(best),
                            shown_with_unit(best.at("peak_pressure"), Dimension::stress, units));
  if (is_johnsons)
    text += fmt::format(
        "<p>With the inertia of the drawn wheel it would be {} and {}.</p>\n",
        wheel_in_words(design.at("geometry")),
        shown_with_unit(design.at("geometry").at("peak_pressure"), Dimension::stress, units));
  const auto range = flat_range(*results.table("design"));
  if (range.size() > 1)
    text += fmt::format(
        "<p class=\"verdict\">As drawn, from {} to {} {} the peak contact pressure is at most 1 % "
        "higher.</p>\n",
        significant(range.front()[0], 4), significant(range.back()[0], 4), length);
  return text;
}

Chart stress_chart(const ResultsDirectory& results, const UnitSystem units) {
  const json& design = *results.document("design");
  const CsvTable& table = *results.table("design");
  Chart chart =
      column_chart(table, "diameter", "wheel diameter", "stress_johnson", "peak contact pressure");
  chart.id = "chart-design";
  chart.title = "Peak contact pressure against the wheel's diameter";
  chart.series[0].name = "Johnson's proportions";
  chart.series.push_back({"as drawn", SeriesStyle::dashed, {}});
  const CsvColumn& x = table.column("diameter");
  const CsvColumn& drawn = table.column("stress_geometry");
  for (std::size_t i = 0; i < x.values.size(); ++i)
    chart.series[1].points.push_back({x.values[i], drawn.values[i]});
  chart.series.push_back({"as drawn, within 1 %", SeriesStyle::wide, flat_range(table)});
  if (design.contains("optimum_diameter"))
    chart.series.push_back(wheel_point("best, Johnson", design, "optimum_diameter", units));
  chart.series.push_back(
      wheel_point("best as drawn", design.at("geometry"), "optimum_diameter", units));
  chart.series.push_back(wheel_point("wheel of the case", design.at("wheel"), "diameter", units));
  return chart;
}

/// Stresses of the wheel away from the contact against its diameter.
Chart strength_chart(const json& design, const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const std::string title = "Maximum stresses of the wheel away from the contact";
  Chart chart{"chart-strength",
              title + " against its diameter",
              title + " against its diameter",
              {fmt::format("wheel diameter [{}]", length.name)},
              {fmt::format("stress [{}]", stress.name)},
              {{"von Mises", SeriesStyle::line, {}}, {"tensile", SeriesStyle::dashed, {}}}};
  for (const json& wheel : design.at("strength")) {
    const double diameter = in_units(wheel.at("diameter"), Dimension::length, units);
    chart.series[0].points.push_back(
        {diameter, in_units(wheel.at("von_mises"), Dimension::stress, units)});
    chart.series[1].points.push_back(
        {diameter, in_units(wheel.at("tensile"), Dimension::stress, units)});
  }
  return chart;
}

std::string shaft_table(const json& design, const UnitSystem units) {
  if (!design.contains("shaft")) return "";
  const json& shaft = design.at("shaft");
  HtmlTable table{
      "The load on its shaft when the pin has left the slot", {"quantity", "value"}, {}};
  const auto add = [&](const char* name, const char* key, const Dimension dimension) {
    if (shaft.contains(key))
      table.rows.push_back(
          {escaped(labelled(name, dimension, units)), shown(shaft.at(key), dimension, units)});
  };
  add("torque", "torque", Dimension::moment);
  add("twist", "twist", Dimension::slope);
  add("double amplitude", "double_amplitude", Dimension::length);
  add("at the radius", "amplitude_radius", Dimension::length);
  table.rows.push_back(
      {"natural frequency [Hz]", significant(number_of(shaft.at("frequency")), 5)});
  return table.html();
}

}  // namespace

ReportPart kinematics_part(const ResultsDirectory& results) {
  const json& kinematics = *results.document("kinematics");
  const CsvTable& table = *results.table("kinematics");
  std::vector<Chart> charts{
      column_chart(table, "driver_angle", "driver angle", "hertz_pressure", "Hertz pressure"),
      slip_chart(table, kinematics.at("pin_type") == "roller")};
  for (Chart& chart : charts) lay_over_cycle(results, chart);
  return {html_section("kinematics", "Motion over the cycle",
                       unbounded_warnings(kinematics, results.units()) +
                           characteristics_table(kinematics, results.units()) +
                           choice_table(kinematics, results.units()) + html(charts)),
          charts};
}

AnsweredPart design_part(const ResultsDirectory& results) {
  const json& design = *results.document("design");
  std::vector<Chart> charts{stress_chart(results, results.units())};
  if (design.contains("strength")) charts.push_back(strength_chart(design, results.units()));
  return {{html_section("design", "Choice of the wheel",
                        design_answer(results) + wheels_table(design, results.units())),
           {}},
          {html_section("diameters", "Stress against the wheel's diameter",
                        html(charts) + shaft_table(design, results.units())),
           charts}};
}

}  // namespace geneva::post
