#include "api/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "api/design.h"
#include "api/estimate.h"
#include "api/kinematics.h"
#include "api/limits.h"
#include "api/mechanism_picture.h"
#include "api/output_directory.h"
#include "api/version.h"
#include "base/errors.h"
#include "model/case_header.h"
#include "model/mechanism_state.h"

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

/// The limit of a figure is the least one of all that are for it.
void set_limit(std::vector<SweepFigure>& figures, const std::string& quantity,
               const double allowed) {
  for (SweepFigure& figure : figures)
    if (figure.quantity == quantity)
      figure.limit = std::min(allowed, figure.limit.value_or(allowed));
}

bool is_of_pressure(const std::string& limit) {
  return limit == "peak contact pressure" || limit.rfind("contact, ", 0) == 0;
}

/// The least safety factor and all of them, and the limits of the figures that they are for.
/// @param pressures figures whose limit is that of the contact pressure
/// @param wear the figure of pressure times slip speed; may be empty
void append_limits(std::vector<SweepFigure>& figures, const std::vector<post::LimitRow>& limits,
                   const std::vector<std::string>& pressures, const std::string& wear) {
  for (const post::LimitRow& row : limits) {
    if (is_of_pressure(row.quantity))
      for (const std::string& pressure : pressures) set_limit(figures, pressure, row.allowed);
    else
      set_limit(figures, wear, row.allowed);
  }
  if (const auto least = post::least_factor(limits))
    figures.push_back({"least safety factor", Dimension::dimensionless, least, std::nullopt, 1.});
  for (const post::LimitRow& row : limits)
    figures.push_back({"safety factor: " + row.quantity, Dimension::dimensionless, row.factor(),
                       std::nullopt, 1.});
}

std::vector<SweepFigure> figures_of_design(const Case& given) {
  const post::DesignReport report = design(given).report;
  std::vector<SweepFigure> figures;
  std::vector<std::string> pressures;
  const auto add = [&](const std::string& of, const loads::DesignedWheel& wheel) {
    figures.push_back(exact("diameter, " + of, Dimension::length, wheel.diameter));
    pressures.push_back("peak contact pressure, " + of);
    figures.push_back(exact(pressures.back(), Dimension::stress, wheel.peak_pressure));
  };
  if (report.johnson) add("best wheel by Johnson", *report.johnson);
  add("best wheel as drawn", report.drawn.wheel);
  add("wheel of the case", report.own);
  const loads::PinContact contact =
      api::pin_contact(*given.mechanism, model::mechanism_dynamics(*given.mechanism).sizes);
  for (const post::LimitRow& row :
       api::pressure_limits(given, contact, {report.own.peak_pressure, 0.}))
    for (const std::string& pressure : pressures) set_limit(figures, pressure, row.allowed);
  return figures;
}

std::vector<SweepFigure> figures_of_estimate(const Case& given) {
  const post::EstimateReport report = estimate(given).report;
  std::vector<SweepFigure> figures;
  for (const post::EstimateRow& row : report.rows)
    figures.push_back(exact(row.quantity, row.dimension, row.value));
  append_limits(figures, report.limits,
                {"peak contact pressure", "greatest pressure of the engagement"}, "");
  return figures;
}

std::vector<SweepFigure> figures_of_motion(const Case& given) {
  const post::KinematicsReport report = kinematics(given, 1).report;
  std::vector<SweepFigure> figures;
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
  // In 3-D the limits are judged by line contacts, not by this pressure of an even load.
  const std::vector<std::string> judged = given.mechanism->space
                                              ? std::vector<std::string>()
                                              : std::vector<std::string>{"maximum Hertz pressure"};
  append_limits(
      figures, report.limits, judged,
      report.is_roller ? "maximum mean bore pressure x sliding speed" : "maximum pressure x slip");
  return figures;
}

/// Exit code of a command that refuses a case.
constexpr int refused = 1;

}  // namespace

/// The figures of the closing table, then the least safety factor and all of them.
std::vector<SweepFigure> figures_of_summary(const json& summary) {
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
    set_limit(figures, is_of_pressure(quantity) ? "peak contact pressure" : quantity,
              *number_in(row.at("allowed")));
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

namespace {

/// @throws base::InputError for what changes no figure
void refuse_texts(const std::vector<model::Variation>& variations) {
  for (const model::Variation& variation : variations)
    for (const char* const text : {"Title", "Project", "Author", "Source"})
      if (variation.name == text)
        throw base::InputError(fmt::format(
            "--set {}: this is a text that changes no figure; vary a number or a choice, for "
            "example 'Mechanism/Pin diameter = 8 mm .. 14 mm, 7'",
            base::in_quotes(variation.name)));
}

}  // namespace

std::vector<SweepCase> sweep_cases(const Case& given,
                                   const std::vector<model::Variation>& variations) {
  refuse_texts(variations);
  std::vector<SweepCase> cases;
  for (const std::vector<std::string>& values : model::combinations(variations)) {
    SweepCase point{values, std::nullopt, ""};
    try {
      point.given = model::case_of(model::varied(given.text, variations, values), given.directory);
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

Sweep begun_sweep(const Case& given, const std::vector<model::Variation>& variations,
                  const std::vector<SweepCase>& cases, const std::string& command) {
  Sweep sweep{given, {model::header_of(given), version, command, {}, {}, {}}};
  for (const model::Variation& variation : variations) {
    model::SectionPath path = variation.section;
    path.push_back(variation.name);
    sweep.report.parameters.push_back(fmt::format("{}", fmt::join(path, "/")));
  }
  std::vector<std::string>& notices = sweep.report.notices;
  for (const SweepCase& point : cases)
    for (const std::string& notice :
         point.given ? point.given->notices : std::vector<std::string>())
      if (std::find(notices.begin(), notices.end(), notice) == notices.end())
        notices.push_back(notice);
  for (const SweepCase& point : cases)
    sweep.report.points.push_back({point.values, "", point.given ? 0 : refused, point.refusal, {}});
  return sweep;
}

void refuse_point(post::SweepPoint& point, const std::string& message) {
  point.exit_code = refused;
  point.message = message;
}

void work_out(Sweep& sweep, const std::vector<SweepCase>& cases) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!cases[i].given) continue;
    try {
      sweep.report.points[i].figures = figures_of(*cases[i].given, sweep.report.command);
    } catch (const base::InputError& error) {
      refuse_point(sweep.report.points[i], error.what());
    }
  }
}

void require_figures(const Sweep& sweep) {
  const auto& points = sweep.report.points;
  if (std::all_of(points.begin(), points.end(),
                  [](const post::SweepPoint& point) { return point.figures.empty(); }))
    throw base::InputError(points.front().message);
}

std::string table(const Sweep& sweep) { return post::sweep_table(sweep.report, sweep.given.units); }

std::vector<SweepFigure> figures_of(const Case& given, const std::string& command) {
  if (command == "design") return figures_of_design(given);
  return command == "estimate" ? figures_of_estimate(given) : figures_of_motion(given);
}

std::vector<SweepFigure> figures_of_run(const fs::path& results) try {
  std::ifstream stream(results / "summary.json");
  return figures_of_summary(json::parse(stream));
} catch (const json::exception&) {
  throw base::InputError((results / "summary.json").string() + " is missing or damaged");
}

Written write(const Sweep& sweep, const fs::path& directory) {
  return api::write_results(directory, sweep.given, "sweep",
                            {{"sweep.json", post::sweep_summary(sweep.report).dump(2) + "\n"},
                             {"sweep.csv", post::sweep_csv(sweep.report, sweep.given.units)}});
}

}  // namespace geneva
