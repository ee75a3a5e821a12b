#include "post/output/sweep_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace geneva::post {

using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;
using nlohmann::json;

namespace {

const SweepFigure* find(const SweepPoint& point, const std::string& quantity) {
  for (const SweepFigure& figure : point.figures)
    if (figure.quantity == quantity) return &figure;
  return nullptr;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

base::Dimension dimension_of(const SweepReport& report, const std::string& quantity) {
  for (const SweepPoint& point : report.points)
    if (const SweepFigure* const figure = find(point, quantity)) return figure->dimension;
  return base::Dimension::dimensionless;
}

/// A field of a table separated by commas.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted;
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return '"' + quoted + '"';
}

/// Whether any point knows how far a figure may be off.
bool has_error(const SweepReport& report, const std::string& quantity) {
  return std::any_of(report.points.begin(), report.points.end(), [&](const SweepPoint& point) {
    const SweepFigure* const figure = find(point, quantity);
    return figure != nullptr && figure->error;
  });
}

std::optional<SweepValue> read_value(const std::string& text) {
  SweepValue value{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value.number);
  if (error != std::errc()) return std::nullopt;
  value.unit = std::string(rest, text.data() + text.size());
  value.unit.erase(0, value.unit.find_first_not_of(' '));
  // '42CrMo4 nitrided' is no quantity
  if (!value.unit.empty() && !base::is_unit(value.unit)) return std::nullopt;
  return value;
}

/// A parameter's name with its unit, and its values: as numbers where they are some of one unit.
struct ParameterColumn {
  std::string heading;
  std::vector<std::string> values;
};

ParameterColumn column_of(const SweepReport& report, const std::size_t parameter) {
  ParameterColumn column{report.parameters[parameter], {}};
  if (const auto numbers = sweep_numbers(report, parameter)) {
    column.heading = with_unit(column.heading, numbers->front().unit);
    for (const SweepValue& value : *numbers)
      column.values.push_back(fmt::format("{:.10g}", value.number));
  } else {
    for (const SweepPoint& point : report.points) column.values.push_back(point.values[parameter]);
  }
  return column;
}

/// The limit that a point's least safety factor is for; empty where there is none.
std::string nearest_limit(const SweepPoint& point) {
  const std::string begin = "safety factor: ";
  const SweepFigure* nearest = nullptr;
  for (const SweepFigure& figure : point.figures)
    if (figure.quantity.rfind(begin, 0) == 0 && figure.value &&
        (nearest == nullptr || *figure.value < *nearest->value))
      nearest = &figure;
  return nearest == nullptr ? "" : nearest->quantity.substr(begin.size());
}

json point_section(const SweepPoint& point) {
  json figures = json::array();
  for (const SweepFigure& figure : point.figures)
    figures.push_back(
        {{"quantity", figure.quantity},
         {"dimension", base::name_of(figure.dimension)},
         {"value", figure.value ? base::quantity(*figure.value, figure.dimension) : json()},
         {"error", figure.error ? base::finite(*figure.error) : json()},
         {"limit", figure.limit ? base::quantity(*figure.limit, figure.dimension) : json()}});
  return {{"values", point.values},
          {"directory", point.directory},
          {"exit_code", point.exit_code},
          {"message", point.message},
          {"nearest_limit", nearest_limit(point)},
          {"figures", figures}};
}

/// How much a figure changes over the points: its range over its greatest size; 0 to 2.
double change_of(const SweepReport& report, const std::string& quantity) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const SweepPoint& point : report.points) {
    const SweepFigure* const figure = find(point, quantity);
    if (figure == nullptr || !figure->value) continue;
    least = std::min(least, *figure->value);
    most = std::max(most, *figure->value);
  }
  const double size = std::max(std::abs(least), std::abs(most));
  return std::isfinite(size) && size > 0. ? (most - least) / size : 0.;
}

/// The figures that the terminal has room for: the first peak pressure, the least safety factor,
/// and those that change most, in the order of the report.
std::vector<std::string> told_quantities(const SweepReport& report) {
  constexpr std::size_t most_figures = 6;
  const std::vector<std::string> all = sweep_quantities(report);
  const auto rank = [&](const std::string& quantity) {
    constexpr double always = 3.;
    constexpr double single_factors = -1.;  // the least one stands for them
    if (quantity == "peak contact pressure" || quantity == "least safety factor") return always;
    if (quantity.rfind("safety factor: ", 0) == 0) return single_factors;
    return change_of(report, quantity);
  };
  std::vector<std::string> ranked = all;
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&](const std::string& a, const std::string& b) { return rank(a) > rank(b); });
  ranked.resize(std::min(ranked.size(), most_figures));
  std::vector<std::string> told;
  for (const std::string& quantity : all)
    if (std::find(ranked.begin(), ranked.end(), quantity) != ranked.end()) told.push_back(quantity);
  return told;
}

/// Exit code, message and figures of a point, separated by commas.
std::string point_fields(const SweepReport& report, const SweepPoint& point,
                         const UnitSystem units) {
  std::string text = fmt::format("{},{}", point.exit_code, field(point.message));
  for (const std::string& quantity : sweep_quantities(report)) {
    const SweepFigure* const figure = find(point, quantity);
    const bool has_value = figure != nullptr && figure->value;
    const double factor = output_unit(units, dimension_of(report, quantity)).factor;
    text += has_value ? fmt::format(",{:.9g}", *figure->value * factor) : ",";
    if (!has_error(report, quantity)) continue;
    text += has_value && figure->error ? fmt::format(",{:.3g}", *figure->error) : ",";
  }
  return text;
}

}  // namespace

std::vector<std::string> sweep_quantities(const SweepReport& report) {
  std::vector<std::string> names;
  for (const SweepPoint& point : report.points)
    for (const SweepFigure& figure : point.figures)
      if (std::find(names.begin(), names.end(), figure.quantity) == names.end())
        names.push_back(figure.quantity);
  return names;
}

std::optional<std::vector<SweepValue>> sweep_numbers(const SweepReport& report,
                                                     const std::size_t parameter) {
  std::vector<SweepValue> numbers;
  for (const SweepPoint& point : report.points) {
    const auto value = read_value(point.values[parameter]);
    if (!value || (!numbers.empty() && value->unit != numbers.front().unit)) return std::nullopt;
    numbers.push_back(*value);
  }
  if (numbers.empty()) return std::nullopt;
  return numbers;
}

json sweep_summary(const SweepReport& report) {
  json points = json::array();
  for (const SweepPoint& point : report.points) points.push_back(point_section(point));
  json units = json::array();
  for (std::size_t i = 0; i < report.parameters.size(); ++i) {
    const auto numbers = sweep_numbers(report, i);
    units.push_back(numbers ? json(numbers->front().unit) : json());
  }
  return {{"case", base::case_section(report.about)},
          {"versions", base::versions_section(report.geneva_version)},
          {"command", report.command},
          {"parameters", report.parameters},
          {"units", units},
          {"notices", report.notices},
          {"points", points}};
}

std::string sweep_csv(const SweepReport& report, const UnitSystem units) {
  std::vector<ParameterColumn> columns;
  std::string text;
  for (std::size_t i = 0; i < report.parameters.size(); ++i) {
    columns.push_back(column_of(report, i));
    text += field(columns.back().heading) + ",";
  }
  text += "exit code,message";
  for (const std::string& quantity : sweep_quantities(report)) {
    const OutputUnit unit = output_unit(units, dimension_of(report, quantity));
    text += "," + field(with_unit(quantity, unit.name));
    if (has_error(report, quantity)) text += "," + field("error of " + quantity);
  }
  text += '\n';
  for (std::size_t row = 0; row < report.points.size(); ++row) {
    for (const ParameterColumn& column : columns) text += field(column.values[row]) + ",";
    text += point_fields(report, report.points[row], units) + '\n';
  }
  return text;
}

std::string sweep_table(const SweepReport& report, const UnitSystem units) {
  const std::vector<std::string> quantities = told_quantities(report);
  std::vector<std::vector<std::string>> columns;
  for (std::size_t i = 0; i < report.parameters.size(); ++i) {
    ParameterColumn column = column_of(report, i);
    const std::size_t name = column.heading.rfind('/');
    columns.push_back(
        {name == std::string::npos ? column.heading : column.heading.substr(name + 1)});
    columns.back().insert(columns.back().end(), column.values.begin(), column.values.end());
  }
  for (const std::string& quantity : quantities) {
    const OutputUnit unit = output_unit(units, dimension_of(report, quantity));
    columns.push_back({with_unit(quantity, unit.name)});
    for (const SweepPoint& point : report.points) {
      const SweepFigure* const figure = find(point, quantity);
      columns.back().push_back(figure != nullptr && figure->value
                                   ? fmt::format("{:.5g}", *figure->value * unit.factor)
                                   : "-");
    }
    if (quantity != "least safety factor") continue;
    columns.push_back({"of"});
    for (const SweepPoint& point : report.points) columns.back().push_back(nearest_limit(point));
  }
  std::string text;
  for (std::size_t row = 0; row <= report.points.size(); ++row) {
    for (const std::vector<std::string>& column : columns) {
      std::size_t width = 0;
      for (const std::string& cell : column) width = std::max(width, cell.size());
      text += fmt::format("{:>{}}  ", column[row], width);
    }
    if (row > 0 && report.points[row - 1].exit_code != 0) text += report.points[row - 1].message;
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

}  // namespace geneva::post
