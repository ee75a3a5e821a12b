#include "post/output/optimum_output.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace geneva::post {

using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;
using nlohmann::json;

namespace {

json optional_quantity(const std::optional<double>& value, const base::Dimension dimension) {
  return value ? base::quantity(*value, dimension) : json();
}

std::string cell(const std::optional<double>& value, const double factor) {
  return value ? fmt::format("{:.5g}", *value * factor) : std::string("-");
}

/// What keeps the optimum from being better: bounds and limits.
std::vector<std::string> binding(const OptimumReport& report) {
  std::vector<std::string> words;
  for (const OptimumDimension& dimension : report.dimensions)
    if (!dimension.bound.empty())
      words.push_back(fmt::format("the {} bound of '{}'", dimension.bound, dimension.name));
  for (const OptimumDimension& dimension : report.dimensions)
    if (!dimension.edge.empty())
      words.push_back(
          fmt::format("another '{}' cannot be worked out: {}", dimension.name, dimension.edge));
  for (const OptimumFigure& figure : report.figures)
    if (figure.binds)
      words.push_back("the limit of the " + figure.quantity +
                      (figure.place.empty() ? "" : " between " + figure.place));
  return words;
}

}  // namespace

json optimum_summary(const OptimumReport& report) {
  json dimensions = json::array();
  for (const OptimumDimension& dimension : report.dimensions)
    dimensions.push_back({{"name", dimension.name},
                          {"before", dimension.before},
                          {"after", dimension.after},
                          {"bound", dimension.bound},
                          {"has_effect", dimension.has_effect}});
  json figures = json::array();
  for (const OptimumFigure& figure : report.figures)
    figures.push_back({{"quantity", figure.quantity},
                       {"dimension", base::name_of(figure.dimension)},
                       {"before", optional_quantity(figure.before, figure.dimension)},
                       {"after", base::quantity(figure.after, figure.dimension)},
                       {"limit", optional_quantity(figure.limit, figure.dimension)},
                       {"place", figure.place},
                       {"binds", figure.binds},
                       {"confirmed", optional_quantity(figure.confirmed, figure.dimension)},
                       {"confirmed_error", figure.error ? json(*figure.error) : json()}});
  return {{"case", base::case_section(report.about)},
          {"versions", base::versions_section(report.geneva_version)},
          {"goal", report.goal},
          {"basis", report.basis},
          {"dimensions", dimensions},
          {"figures", figures},
          {"binds", binding(report)},
          {"safety", limits_section(report.limits)},
          {"trials", report.trials}};
}

bool OptimumFigure::is_exceeded() const {
  return limit && confirmed && *confirmed > *limit * (1. + error.value_or(0.));
}

std::string optimum_csv(const OptimumReport& report, const UnitSystem units) {
  std::string text = "quantity,unit,before,after,limit,finite elements\n";
  for (const OptimumFigure& figure : report.figures) {
    const OutputUnit unit = output_unit(units, figure.dimension);
    const auto field = [&](const std::optional<double>& value) {
      return value ? fmt::format("{:.9g}", *value * unit.factor) : std::string();
    };
    text += fmt::format("{},{},{},{},{},{}\n", figure.quantity, unit.name, field(figure.before),
                        field(figure.after), field(figure.limit), field(figure.confirmed));
  }
  return text;
}

std::string optimum_table(const OptimumReport& report, const UnitSystem units) {
  std::string text =
      fmt::format("least {}, {} candidates; pressures by {}\n\n{:<44} {:>17} {:>17}\n", report.goal,
                  report.trials, report.basis, "", "as it is", "best");
  for (const OptimumDimension& dimension : report.dimensions)
    text += fmt::format("{:<44} {:>17} {:>17}\n", dimension.name,
                        dimension.before.empty() ? "by rule" : dimension.before, dimension.after) +
            (dimension.has_effect ? "" : "  has no effect: any value is as good\n");
  text += fmt::format("\n{:<44}{:>14}{:>14}{:>14}{:>18}\n", "", "as it is", "best", "limit",
                      "finite elements");
  for (const OptimumFigure& figure : report.figures) {
    const OutputUnit unit = output_unit(units, figure.dimension);
    const std::string error =
        figure.error ? fmt::format(" +- {:.2g} %", 100. * *figure.error) : std::string();
    text += fmt::format(
        "{:<44}{:>14}{:>14}{:>14}{:>18}\n", fmt::format("{} [{}]", figure.quantity, unit.name),
        cell(figure.before, unit.factor), cell(figure.after, unit.factor),
        cell(figure.limit, unit.factor), cell(figure.confirmed, unit.factor) + error);
  }
  for (const OptimumFigure& figure : report.figures)
    if (figure.is_exceeded())
      text += fmt::format("EXCEEDED by finite elements: {}; ask for {:.2g} % less\n",
                          figure.quantity, 100. * (1. - *figure.limit / *figure.confirmed));
  const std::vector<std::string> binds = binding(report);
  text += binds.empty() ? "\nnothing binds: it is a minimum within all bounds and limits\n"
                        : fmt::format("\nwhat binds: {}\n", fmt::join(binds, ", "));
  return text + limit_lines(report.limits, units);
}

}  // namespace geneva::post
