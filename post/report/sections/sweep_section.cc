#include "post/report/sections/sweep_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/pictures/map_picture.h"
#include "post/report/sections/limits.h"

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

bool is_leading(const Quantity& quantity) {
  return quantity.name == "least safety factor" ||
         quantity.name.rfind("peak contact pressure", 0) == 0;
}

constexpr const char* begin_of_factors = "safety factor: ";

/// Those that decide first.
/// @param of_factors the single safety factors instead of everything else
std::vector<Quantity> quantities_of(const json& points, const bool of_factors) {
  std::vector<Quantity> quantities;
  for (const json& point : points)
    for (const json& figure : point.at("figures")) {
      const std::string name = figure.at("quantity");
      const bool is_new = std::none_of(quantities.begin(), quantities.end(),
                                       [&](const Quantity& known) { return known.name == name; });
      if (is_new && (name.rfind(begin_of_factors, 0) == 0) == of_factors)
        quantities.push_back({name, base::dimension_named(figure.at("dimension"))});
    }
  std::stable_partition(quantities.begin(), quantities.end(), is_leading);
  return quantities;
}

const json* figure_of(const json& point, const std::string& quantity) {
  for (const json& figure : point.at("figures"))
    if (figure.at("quantity") == quantity) return &figure;
  return nullptr;
}

/// A safety factor keeps its limit above it, everything else below.
bool is_exceeded(const std::string& quantity, const json& figure) {
  if (figure.at("limit").is_null() || figure.at("value").is_null()) return false;
  const double value = number_of(figure.at("value"));
  const double limit = number_of(figure.at("limit"));
  return quantity.find("safety factor") != std::string::npos ? value < limit : value > limit;
}

/// Whether the points differ in a parameter.
bool varies(const json& points, const std::size_t parameter) {
  return std::any_of(points.begin(), points.end(), [&](const json& point) {
    return point.at("values")[parameter] != points.at(0).at("values")[parameter];
  });
}

/// Whether a figure is more than roundings apart at two points.
bool changes(const json& points, const std::string& quantity) {
  constexpr double rounding = 1e-6;
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const json& point : points) {
    const json* const figure = figure_of(point, quantity);
    if (figure == nullptr || figure->at("value").is_null()) continue;
    least = std::min(least, number_of(figure->at("value")));
    most = std::max(most, number_of(figure->at("value")));
  }
  return most - least > rounding * std::max(std::abs(least), std::abs(most));
}

/// A table with the number of each point and the parameters in which they differ.
HtmlTable points_table(const json& sweep, const std::string& caption) {
  const json& points = sweep.at("points");
  HtmlTable table{caption, {"point"}, {}};
  for (std::size_t point = 0; point < points.size(); ++point)
    table.rows.push_back({std::to_string(point + 1)});
  for (std::size_t i = 0; i < sweep.at("parameters").size(); ++i) {
    if (!varies(points, i)) continue;
    table.headings.push_back(escaped(short_name(sweep.at("parameters")[i])));
    for (std::size_t point = 0; point < points.size(); ++point)
      table.rows[point].push_back(escaped(shown_input(points[point].at("values")[i])));
  }
  return table;
}

/// A figure of a point; marked where its limit is exceeded.
std::string value_cell(const json& point, const Quantity& quantity, const base::UnitSystem units) {
  const json* const figure = figure_of(point, quantity.name);
  if (figure == nullptr) return "–";
  const bool is_least = quantity.name == "least safety factor";
  const bool is_factor = is_least || quantity.name.rfind(begin_of_factors, 0) == 0;
  if (figure->at("value").is_null())
    return is_factor ? "<span class=\"fail\">✗ none</span>" : "not bounded";
  constexpr int digits_of_factor = 3;
  std::string value = is_factor ? significant(number_of(figure->at("value")), digits_of_factor)
                                : shown(figure->at("value"), quantity.dimension, units);
  if (!is_factor && !figure->at("error").is_null()) value += " " + shown_error(figure->at("error"));
  const std::string marked =
      is_exceeded(quantity.name, *figure) ? "<span class=\"fail\">✗ " + value + "</span>" : value;
  return is_least ? marked + "<br><small>" + escaped(point.at("nearest_limit")) + "</small>"
                  : marked;
}

/// All figures of all points, in tables that are no wider than a sheet of paper.
std::string values_tables(const json& sweep, const std::vector<Quantity>& quantities,
                          const std::string& caption, const base::UnitSystem units) {
  constexpr std::size_t most_columns = 8;
  const json& points = sweep.at("points");
  const std::size_t n_leading = points_table(sweep, "").headings.size();
  const std::size_t room = most_columns - std::min(n_leading, most_columns - 3);
  const std::size_t n_tables = (quantities.size() + room - 1) / room;
  if (n_tables == 0) return "";
  std::string text;
  for (std::size_t part = 0; part < n_tables; ++part) {  // of equal widths, up to a column
    HtmlTable table = points_table(sweep, part == 0 ? caption : caption + ", continued");
    const std::size_t end = (part + 1) * quantities.size() / n_tables;
    for (std::size_t i = part * quantities.size() / n_tables; i < end; ++i) {
      const bool is_factor = quantities[i].name.rfind(begin_of_factors, 0) == 0;
      table.headings.push_back(
          escaped(is_factor ? quantities[i].name.substr(std::string(begin_of_factors).size())
                            : labelled(quantities[i].name, quantities[i].dimension, units)));
      for (std::size_t point = 0; point < points.size(); ++point)
        table.rows[point].push_back(value_cell(points[point], quantities[i], units));
    }
    text += table.html();
  }
  return text;
}

/// What the commands said of points; empty where they said nothing.
std::string remarks_table(const json& sweep) {
  HtmlTable table = points_table(sweep, "Remarks");
  table.headings.emplace_back("remark");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t point = 0; point < table.rows.size(); ++point) {
    const std::string message = sweep.at("points")[point].at("message");
    if (message.empty()) continue;
    rows.push_back(std::move(table.rows[point]));
    rows.back().push_back(escaped(message));
  }
  table.rows = std::move(rows);
  return table.rows.empty() ? "" : table.html();
}

/// The other parameters' values of a point, in words.
std::string others_of(const json& sweep, const json& point, const std::size_t across) {
  std::string text;
  for (std::size_t i = 0; i < sweep.at("parameters").size(); ++i) {
    if (i == across || !varies(sweep.at("points"), i)) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", short_name(sweep.at("parameters")[i]),
                        shown_input(point.at("values")[i]));
  }
  return text;
}

/// The parameters whose values are numbers of one unit, and more than one.
std::vector<std::size_t> numeric_parameters(const json& sweep) {
  std::vector<std::size_t> found;
  const json& points = sweep.at("points");
  for (std::size_t i = 0; i < sweep.at("parameters").size(); ++i) {
    if (!sweep.at("units")[i].is_null() && varies(points, i)) found.push_back(i);
  }
  return found;
}

std::string parameter_label(const json& sweep, const std::size_t parameter) {
  const std::string name = short_name(sweep.at("parameters")[parameter]);
  const std::string unit = sweep.at("units")[parameter];
  return unit.empty() ? name : fmt::format("{} [{}]", name, shown_unit(unit));
}

/// Values of a parameter in ascending order.
std::vector<double> grid_of(const json& sweep, const std::size_t parameter) {
  std::set<double> values;
  for (const json& point : sweep.at("points"))
    values.insert(number_in(point.at("values")[parameter]));
  return {values.begin(), values.end()};
}

std::size_t place_in(const std::vector<double>& grid, const double value) {
  return static_cast<std::size_t>(std::lower_bound(grid.begin(), grid.end(), value) - grid.begin());
}

/// A figure over the only two parameters that vary.
MapData map_of(const json& sweep, const Quantity& quantity,
               const std::vector<std::size_t>& parameters, const base::UnitSystem units) {
  MapData map{labelled(quantity.name, quantity.dimension, units),
              parameter_label(sweep, parameters[0]),
              parameter_label(sweep, parameters[1]),
              grid_of(sweep, parameters[0]),
              grid_of(sweep, parameters[1]),
              {},
              {}};
  map.values.assign(map.x.size() * map.y.size(), std::nan(""));
  map.exceeds.assign(map.values.size(), false);
  for (const json& point : sweep.at("points")) {
    const json* const figure = figure_of(point, quantity.name);
    if (figure == nullptr || figure->at("value").is_null()) continue;
    const auto place = [&](const std::vector<double>& grid, const std::size_t parameter) {
      return place_in(grid, number_in(point.at("values")[parameter]));
    };
    const std::size_t at = place(map.y, parameters[1]) * map.x.size() + place(map.x, parameters[0]);
    map.values[at] = in_units(figure->at("value"), quantity.dimension, units);
    map.exceeds[at] = is_exceeded(quantity.name, *figure);
  }
  return map;
}

/// Maps of the figures where two parameters alone vary, in three values each or more.
std::string maps(const json& sweep, const std::vector<Quantity>& quantities,
                 const base::UnitSystem units) {
  const std::vector<std::size_t> parameters = numeric_parameters(sweep);
  constexpr std::size_t fewest = 3;
  const bool is_grid =
      parameters.size() == 2 && sweep.at("parameters").size() == 2 &&
      std::all_of(parameters.begin(), parameters.end(), [&](const std::size_t parameter) {
        return grid_of(sweep, parameter).size() >= fewest;
      });
  if (!is_grid) return "";
  std::string text;
  int number = 0;
  for (const Quantity& quantity : quantities) {
    const MapData map = map_of(sweep, quantity, parameters, units);
    if (std::any_of(map.values.begin(), map.values.end(),
                    [](const double value) { return std::isfinite(value); }))
      text += fmt::format("<figure>\n{}<figcaption>{}{}</figcaption>\n</figure>\n",
                          map_picture(map, fmt::format("colours-of-map-{}", number++)),
                          escaped(quantity.name),
                          std::count(map.exceeds.begin(), map.exceeds.end(), true) > 0
                              ? "; crossed out where its limit is exceeded"
                              : "");
  }
  return "<div class=\"charts\">\n" + text + "</div>\n";
}

using Curves = std::map<std::string, std::vector<std::array<double, 2>>>;

/// Curves by ascending place; a single one without a name where all are the same.
Curves distinct(Curves curves) {
  for (auto& [name, points] : curves) std::sort(points.begin(), points.end());
  const bool are_same = std::all_of(curves.begin(), curves.end(), [&](const auto& curve) {
    return curve.second == curves.begin()->second;
  });
  if (curves.size() > 1 && are_same) return {{"", curves.begin()->second}};
  return curves;
}

/// A figure against the parameter, a curve for each combination of the others, and the limit.
Chart chart_of(const json& sweep, const Quantity& quantity, const std::size_t across,
               const base::UnitSystem units, const std::size_t number) {
  const double factor = base::output_unit(units, quantity.dimension).factor;
  const std::string name = short_name(sweep.at("parameters")[across]);
  Curves curves;
  Curves limits;
  std::vector<std::string> order;
  for (const json& point : sweep.at("points")) {
    const json* const figure = figure_of(point, quantity.name);
    if (figure == nullptr || figure->at("value").is_null()) continue;
    const double x = number_in(point.at("values")[across]);
    const std::string others = others_of(sweep, point, across);
    if (curves.count(others) == 0) order.push_back(others);
    curves[others].push_back({x, number_of(figure->at("value")) * factor});
    if (!figure->at("limit").is_null())
      limits[others].push_back({x, number_of(figure->at("limit")) * factor});
  }
  Chart chart{fmt::format("chart-sweep-{}", number),
              quantity.name,
              fmt::format("{} against {}", quantity.name, name),
              {parameter_label(sweep, across)},
              {labelled(quantity.name, quantity.dimension, units)},
              {}};
  for (const std::string& others : order)
    chart.series.emplace_back(others.empty() ? quantity.name : others, SeriesStyle::line,
                              curves[others]);
  for (const auto& [others, limit] : distinct(limits))
    chart.series.emplace_back(others.empty() ? "allowed" : others + ", allowed",
                              SeriesStyle::dashed, limit);
  return chart;
}

/// ", all with Accuracy 2 %"; empty where all parameters vary.
std::string what_stays(const json& sweep) {
  std::string text;
  for (std::size_t i = 0; i < sweep.at("parameters").size(); ++i)
    if (!varies(sweep.at("points"), i))
      text += fmt::format("{}{} {}", text.empty() ? ", all with " : ", ",
                          short_name(sweep.at("parameters")[i]),
                          shown_input(sweep.at("points")[0].at("values")[i]));
  return text;
}

/// "with Pin diameter 8 mm"; empty where nothing varies.
std::string with_values(const json& sweep, const json& point) {
  const std::string values = others_of(sweep, point, sweep.at("parameters").size());
  return values.empty() ? "" : "with " + escaped(values);
}

/// The value of a figure of a point; not a number where it has none.
double value_of(const json& point, const std::string& quantity) {
  const json* const figure = figure_of(point, quantity);
  return figure == nullptr || figure->at("value").is_null() ? std::nan("")
                                                            : number_of(figure->at("value"));
}

/// The point at which a figure is greatest, times a sign; none where no point has it.
const json* best_point(const json& points, const std::string& quantity, const double sign) {
  const json* best = nullptr;
  for (const json& point : points)
    if (const double value = sign * value_of(point, quantity);
        std::isfinite(value) && (best == nullptr || value > sign * value_of(*best, quantity)))
      best = &point;
  return best;
}

/// How many points exceed a limit, in words; empty where none has one.
std::string count_of_exceeded(const json& points) {
  std::size_t n_limited = 0;
  std::size_t n_exceeded = 0;
  for (const json& point : points) {
    const auto& figures = point.at("figures");
    n_limited += std::any_of(figures.begin(), figures.end(),
                             [](const json& figure) { return !figure.at("limit").is_null(); });
    n_exceeded += std::any_of(figures.begin(), figures.end(), [](const json& figure) {
      return is_exceeded(figure.at("quantity"), figure);
    });
  }
  if (n_limited == 0) return "";
  return n_exceeded == 0
             ? "<p>No point exceeds a limit.</p>\n"
             : fmt::format("<p>{} of {} points exceed a limit.</p>\n", n_exceeded, points.size());
}

/// The point that keeps its limits best, or without limits the one of the least peak pressure.
std::string answer_of_sweep(const json& sweep, const base::UnitSystem units) {
  const json& points = sweep.at("points");
  const std::string factor_name = "least safety factor";
  if (const json* const best = best_point(points, factor_name, 1.)) {
    const double factor = value_of(*best, factor_name);
    return answer(
        "greatest safety factor", significant(factor, 3),
        fmt::format("{} {} {}", escaped(best->at("nearest_limit")), with_values(sweep, *best),
                    factor >= 1. ? "<span class=\"pass\">✓ pass</span>"
                                 : "<span class=\"fail\">✗ EXCEEDED</span>"));
  }
  const std::string pressure = "peak contact pressure";
  const json* const best = best_point(points, pressure, -1.);
  if (best == nullptr) return "";
  return answer(
      "least " + pressure,
      shown_with_unit(figure_of(*best, pressure)->at("value"), base::Dimension::stress, units),
      with_values(sweep, *best));
}

}  // namespace

AnsweredPart sweep_part(const ResultsDirectory& results) {
  const json& sweep = *results.document("sweep");
  const json& points = sweep.at("points");
  const std::vector<Quantity> quantities = quantities_of(points, false);
  std::vector<Chart> charts;
  const std::vector<std::size_t> numeric = numeric_parameters(sweep);
  if (!numeric.empty())
    for (const Quantity& quantity : quantities) {
      if (!changes(points, quantity.name)) continue;
      Chart chart = chart_of(sweep, quantity, numeric.front(), results.units(), charts.size());
      if (!chart.series.empty()) charts.push_back(std::move(chart));
    }
  std::string notices;
  for (const json& notice : sweep.value("notices", json::array()))
    notices += fmt::format("<p class=\"warning\"><strong>Note:</strong> {}</p>\n",
                           escaped(notice.get<std::string>()));
  const std::string head =
      fmt::format("<p>'geneva {}' for {} combinations{}.</p>\n", escaped(sweep.at("command")),
                  points.size(), escaped(what_stays(sweep)));
  const base::UnitSystem units = results.units();
  const std::vector<Quantity> factors = quantities_of(points, true);
  const std::string details = html(charts) + maps(sweep, quantities, units) +
                              values_tables(sweep, quantities, "Every point", units) +
                              values_tables(sweep, factors, "Safety factors", units) +
                              remarks_table(sweep);
  return {{html_section("sweep", "Sweep",
                        answer_of_sweep(sweep, units) + count_of_exceeded(points) + head + notices),
           {}},
          {html_section("points", "All points", details), charts}};
}

}  // namespace geneva::post
