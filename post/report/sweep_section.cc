#include "post/report/sweep_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "post/report/html.h"
#include "post/report/shown_values.h"

namespace geneva::post {

using nlohmann::json;

namespace {

/// The number that a value begins with.
double number_in(const std::string& text) {
  double number = 0.;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// The last part of "Mechanism/Pin diameter".
std::string short_name(const std::string& parameter) {
  return parameter.substr(parameter.rfind('/') + 1);
}

struct Quantity {
  std::string name;
  base::Dimension dimension;
};

std::vector<Quantity> quantities_of(const json& points) {
  std::vector<Quantity> quantities;
  for (const json& point : points)
    for (const json& figure : point.at("figures")) {
      const std::string name = figure.at("quantity");
      const bool is_new = std::none_of(quantities.begin(), quantities.end(),
                                       [&](const Quantity& known) { return known.name == name; });
      // Of the safety factors the least one is shown; sweep.csv holds all.
      if (is_new && name.rfind("safety factor: ", 0) != 0)
        quantities.push_back({name, base::dimension_named(figure.at("dimension"))});
    }
  return quantities;
}

const json* figure_of(const json& point, const std::string& quantity) {
  for (const json& figure : point.at("figures"))
    if (figure.at("quantity") == quantity) return &figure;
  return nullptr;
}

std::string values_table(const json& sweep, const std::vector<Quantity>& quantities,
                         const base::UnitSystem units) {
  HtmlTable table{"Every point", {"point"}, {}};
  for (const json& parameter : sweep.at("parameters"))
    table.headings.push_back(escaped(short_name(parameter)));
  for (const Quantity& quantity : quantities)
    table.headings.push_back(escaped(labelled(quantity.name, quantity.dimension, units)));
  table.headings.emplace_back("remark");
  int number = 0;
  for (const json& point : sweep.at("points")) {
    std::vector<std::string> row{std::to_string(++number)};
    for (const json& value : point.at("values")) row.push_back(escaped(value));
    for (const Quantity& quantity : quantities) {
      const json* const figure = figure_of(point, quantity.name);
      row.push_back(figure == nullptr ? "–"
                                      : shown(figure->at("value"), quantity.dimension, units));
    }
    row.push_back(escaped(point.at("message")));
    table.rows.push_back(row);
  }
  return table.html();
}

/// The other parameters' values of a point, in words.
std::string others_of(const json& sweep, const json& point, const std::size_t across) {
  std::string text;
  for (std::size_t i = 0; i < sweep.at("parameters").size(); ++i) {
    if (i == across) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", short_name(sweep.at("parameters")[i]),
                        point.at("values")[i].get<std::string>());
  }
  return text;
}

/// The first parameter whose values are numbers of one unit, and more than one.
std::optional<std::size_t> parameter_across(const json& sweep) {
  const json& points = sweep.at("points");
  for (std::size_t i = 0; i < sweep.at("parameters").size(); ++i) {
    const bool varies = std::any_of(points.begin(), points.end(), [&](const json& point) {
      return point.at("values")[i] != points.at(0).at("values")[i];
    });
    if (!sweep.at("units")[i].is_null() && varies) return i;
  }
  return std::nullopt;
}

/// A figure against the parameter, a curve for each combination of the others, and the limit.
Chart chart_of(const json& sweep, const Quantity& quantity, const std::size_t across,
               const base::UnitSystem units, const std::size_t number) {
  const double factor = base::output_unit(units, quantity.dimension).factor;
  const std::string name = short_name(sweep.at("parameters")[across]);
  const std::string unit = sweep.at("units")[across];
  std::map<std::string, std::vector<std::array<double, 2>>> curves;
  std::vector<std::string> order;
  std::vector<std::array<double, 2>> limit;
  for (const json& point : sweep.at("points")) {
    const json* const figure = figure_of(point, quantity.name);
    if (figure == nullptr || figure->at("value").is_null()) continue;
    const double x = number_in(point.at("values")[across]);
    const std::string others = others_of(sweep, point, across);
    if (curves.count(others) == 0) order.push_back(others);
    curves[others].push_back({x, number_of(figure->at("value")) * factor});
    if (!figure->at("limit").is_null())
      limit.push_back({x, number_of(figure->at("limit")) * factor});
  }
  Chart chart{fmt::format("chart-sweep-{}", number),
              quantity.name,
              fmt::format("{} against {}", quantity.name, name),
              {unit.empty() ? name : fmt::format("{} [{}]", name, unit)},
              {labelled(quantity.name, quantity.dimension, units)},
              {}};
  for (const std::string& others : order)
    chart.series.emplace_back(others.empty() ? quantity.name : others, SeriesStyle::line,
                              curves[others]);
  if (limit.empty()) return chart;
  std::sort(limit.begin(), limit.end());
  chart.series.emplace_back("allowed", SeriesStyle::dashed, limit);
  return chart;
}

}  // namespace

ReportPart sweep_part(const ResultsDirectory& results) {
  const json& sweep = *results.document("sweep");
  const std::vector<Quantity> quantities = quantities_of(sweep.at("points"));
  std::vector<Chart> charts;
  if (const auto across = parameter_across(sweep))
    for (const Quantity& quantity : quantities) {
      Chart chart = chart_of(sweep, quantity, *across, results.units(), charts.size());
      if (!chart.series.empty()) charts.push_back(std::move(chart));
    }
  const std::string head = fmt::format("<p>'geneva {}' for {} combinations.</p>\n",
                                       escaped(sweep.at("command")), sweep.at("points").size());
  return {html_section("sweep", "Sweep",
                       head + html(charts) + values_table(sweep, quantities, results.units())),
          charts};
}

}  // namespace geneva::post
