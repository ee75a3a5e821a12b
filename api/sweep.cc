#include "api/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "api/design.h"
#include "api/estimate.h"
#include "api/kinematics.h"
#include "api/output_directory.h"
#include "base/errors.h"

namespace geneva {

namespace {

namespace fs = std::filesystem;
using base::Dimension;
using nlohmann::json;
using post::SweepFigure;

SweepFigure exact(const std::string& quantity, const Dimension dimension, const double value) {
  return {quantity, dimension, value, std::nullopt, std::nullopt};
}

std::optional<double> number_in(const json& quantity) {
  if (quantity.is_number()) return quantity.get<double>();
  if (!quantity.is_object() || quantity.at("value").is_null()) return std::nullopt;
  return quantity.at("value").get<double>();
}

std::vector<SweepFigure> figures_of_design(const Case& given) {
  const post::DesignReport report = design(given).report;
  std::vector<SweepFigure> figures;
  const auto add = [&](const std::string& of, const loads::DesignedWheel& wheel) {
    figures.push_back(exact("diameter, " + of, Dimension::length, wheel.diameter));
    figures.push_back(
        exact("peak contact pressure, " + of, Dimension::stress, wheel.peak_pressure));
  };
  if (report.johnson) add("best wheel by Johnson", *report.johnson);
  add("best wheel as drawn", report.drawn.wheel);
  add("wheel of the case", report.own);
  return figures;
}

/// The figures of the closing table, then the least safety factor and all of them.
std::vector<SweepFigure> figures_in(const json& summary) {
  std::vector<SweepFigure> figures;
  for (const json& row : summary.at("comparison")) {
    const bool is_closed_form = row.at("bounded").get<bool>() && row.at("computed").is_null();
    const json& value = is_closed_form ? row.at("closed_form") : row.at("computed");
    if (is_closed_form && value.is_null()) continue;
    figures.push_back({row.at("quantity"), base::dimension_named(row.at("dimension")),
                       number_in(value), number_in(row.value("error", json())), std::nullopt});
  }
  std::optional<double> least;
  bool is_bounded = true;
  for (const json& row : summary.at("safety")) {
    const std::string quantity = row.at("quantity");
    const std::optional<double> factor = number_in(row.at("factor"));
    for (SweepFigure& figure : figures)
      if (figure.quantity == quantity) figure.limit = number_in(row.at("allowed"));
    if (factor) least = std::min(*factor, least.value_or(*factor));
    is_bounded = is_bounded && factor;
  }
  if (!is_bounded) least.reset();
  if (!summary.at("safety").empty())
    figures.push_back({"least safety factor", Dimension::dimensionless, least, std::nullopt, 1.});
  for (const json& row : summary.at("safety"))
    figures.push_back({"safety factor: " + row.at("quantity").get<std::string>(),
                       Dimension::dimensionless, number_in(row.at("factor")), std::nullopt, 1.});
  return figures;
}

}  // namespace

std::vector<SweepCase> sweep_cases(const fs::path& directory,
                                   const std::vector<model::Variation>& variations) {
  const Case whole = read_case(directory);
  const model::ParameterText text = model::read_parameter_text(whole.directory / "case.prm");
  std::vector<SweepCase> cases;
  for (const std::vector<std::string>& values : model::combinations(variations)) {
    SweepCase point{values, std::nullopt, ""};
    try {
      point.given = model::case_of(model::varied(text, variations, values), whole.directory);
    } catch (const base::InputError& error) {
      point.refusal = error.what();
    }
    cases.push_back(std::move(point));
  }
  const bool is_any = std::any_of(cases.begin(), cases.end(),
                                  [](const SweepCase& point) { return point.given.has_value(); });
  if (!is_any) throw base::InputError(cases.front().refusal);
  return cases;
}

std::vector<SweepFigure> figures_of(const Case& given, const std::string& command) {
  std::vector<SweepFigure> figures;
  if (command == "design") return figures_of_design(given);
  if (command == "estimate") {
    for (const post::EstimateRow& row : estimate(given).report.rows)
      figures.push_back(exact(row.quantity, row.dimension, row.value));
    return figures;
  }
  const post::KinematicsReport report = kinematics(given, 1).report;
  std::string above;  // an indented row belongs to it
  for (const post::CharacteristicRow& row :
       post::characteristic_rows(report.values, report.reference_speed)) {
    const std::size_t indent = row.quantity.find_first_not_of(' ');
    if (indent == 0) above = row.quantity;
    const std::string name =
        indent == 0 ? row.quantity : above + ", " + row.quantity.substr(indent);
    const auto same = std::count_if(figures.begin(), figures.end(), [&](const SweepFigure& figure) {
      return figure.quantity.rfind(name, 0) == 0;
    });
    figures.push_back(
        exact(same == 0 ? name : fmt::format("{} ({})", name, same + 1), row.dimension, row.value));
  }
  return figures;
}

std::vector<SweepFigure> figures_of_run(const fs::path& results) try {
  std::ifstream stream(results / "summary.json");
  return figures_in(json::parse(stream));
} catch (const json::exception&) {
  throw base::InputError((results / "summary.json").string() + " is missing or damaged");
}

Written write(const Sweep& sweep, const fs::path& directory) {
  return api::write_results(directory, sweep.given, "sweep",
                            {{"sweep.json", post::sweep_summary(sweep.report).dump(2) + "\n"},
                             {"sweep.csv", post::sweep_csv(sweep.report, sweep.given.units)}});
}

}  // namespace geneva
