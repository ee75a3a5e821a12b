#include "post/report/sections/load_steps_section.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/json_values.h"
#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/sections/limits.h"

namespace geneva::post {

using base::Dimension;
using base::UnitSystem;
using nlohmann::json;

namespace {

constexpr double round_off = 1e-9;  // of a force that is none, beside another one

double length_of(const json& vector) {
  return std::hypot(number_of(vector[0]), number_of(vector[1]), number_of(vector[2]));
}

std::string name_of_pair(const json& contact) {
  return fmt::format("{} → {}", contact.at("source").get<std::string>(),
                     contact.at("target").get<std::string>());
}

/// A figure of each contact against the steps.
/// @param figure SI value of a contact
Chart chart_over_steps(const json& history, const std::string& id, const std::string& title,
                       const std::string& axis, const double factor,
                       const std::function<double(const json&)>& figure) {
  Chart chart{"chart-steps-" + id, title,  title + ", against the load step",
              {"load step"},       {axis}, {}};
  chart.is_over_cycle = true;  // the slider's place is shown in it
  const json& steps = history.at("steps");
  const json& contacts = steps.at(0).at("contacts");
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    ChartSeries series{name_of_pair(contacts[i]), SeriesStyle::line, {}};
    for (const json& step : steps)
      series.points.push_back(
          {step.at("step").get<double>(), factor * figure(step.at("contacts")[i])});
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// Of all steps and contacts, in SI units; null if nothing rubs.
json greatest_friction(const json& history) {
  json greatest;
  for (const json& step : history.at("steps"))
    for (const json& contact : step.at("contacts")) {
      const json& friction = contact.at("friction_force");
      const double least = round_off * length_of(contact.at("force"));
      if (length_of(friction) > (greatest.is_null() ? least : length_of(greatest)))
        greatest = friction;
    }
  return greatest;
}

/// Of a vector along another one.
double component(const json& vector, const json& along) {
  double product = 0.;
  for (std::size_t i = 0; i < vector.size(); ++i)
    product += number_of(vector[i]) * number_of(along[i]);
  return product / length_of(along);
}

std::vector<Chart> charts_of(const json& history, const UnitSystem units) {
  const auto factor = [&](const Dimension dimension) {
    return base::output_unit(units, dimension).factor;
  };
  std::vector<Chart> charts{
      chart_over_steps(history, "pressure", "Peak contact pressure over the load steps",
                       labelled("peak contact pressure", Dimension::stress, units),
                       factor(Dimension::stress),
                       [](const json& contact) { return number_of(contact.at("peak_pressure")); }),
      chart_over_steps(history, "force", "Contact force over the load steps",
                       labelled("contact force", Dimension::force, units), factor(Dimension::force),
                       [](const json& contact) { return length_of(contact.at("force")); })};
  if (greatest_friction(history).is_null()) return charts;
  charts.push_back(chart_over_steps(
      history, "friction", "Friction force over the load steps, along the greatest one",
      labelled("friction force", Dimension::force, units), factor(Dimension::force),
      [along = greatest_friction(history)](const json& contact) {
        return component(contact.at("friction_force"), along);
      }));
  charts.push_back(chart_over_steps(
      history, "heat", "Heat of friction since the first step", "heat of friction [J]", 1.,
      [](const json& contact) { return number_of(contact.at("dissipated")); }));
  return charts;
}

/// Without the round-off of a force that is none beside another one.
std::string force_text(const json& vector, const double beside, const UnitSystem units) {
  const double length = length_of(vector);
  return shown(base::quantity(length > round_off * beside ? length : 0., Dimension::force),
               Dimension::force, units);
}

std::string steps_table(const json& history, const UnitSystem units) {
  HtmlTable table{
      "Load steps",
      {"step", "time [s]", "contact", labelled("force", Dimension::force, units),
       labelled("friction", Dimension::force, units),
       labelled("peak pressure", Dimension::stress, units), "sticking", "slipping", "heat [J]"},
      {}};
  for (const json& step : history.at("steps"))
    for (const json& contact : step.at("contacts"))
      table.rows.push_back(
          {std::to_string(step.at("step").get<int>()),
           shown(step.at("time"), Dimension::time, units), escaped(name_of_pair(contact)),
           force_text(contact.at("force"), 0., units),
           force_text(contact.at("friction_force"), length_of(contact.at("force")), units),
           shown(contact.at("peak_pressure"), Dimension::stress, units),
           std::to_string(contact.at("sticking_nodes").get<int>()),
           std::to_string(contact.at("slipping_nodes").get<int>()),
           significant(number_of(contact.at("dissipated")), 4)});
  return table.html();
}

/// The answer first.
std::string head(const json& history, const UnitSystem units) {
  const json& greatest = history.at("greatest");
  const std::size_t n_steps = history.at("steps").size();
  std::string text;
  if (!greatest.is_null()) {
    const bool is_last = greatest.at("step") == n_steps;
    text = answer("greatest peak pressure",
                  history.at("bounded").get<bool>()
                      ? shown_with_unit(greatest.at("peak_pressure"), Dimension::stress, units)
                      : "not bounded",
                  fmt::format("{}at load step {} of {}",
                              is_last ? shown_error(history.at("error_of_last_step")) + " " : "",
                              greatest.at("step").get<int>(), n_steps));
  }
  text += nearest_limit(history.at("safety"), units);
  for (const json& notice : history.at("notices"))
    text += fmt::format("<p class=\"warning\"><strong>Note:</strong> {}</p>\n",
                        escaped(notice.get<std::string>()));
  return text;
}

}  // namespace

AnsweredPart load_steps_part(const ResultsDirectory& results, const std::string& field) {
  const json& history = *results.document("load_steps");
  const UnitSystem units = results.units();
  const std::vector<Chart> charts = charts_of(history, units);
  const std::string limits =
      limits_table(history.at("safety"), "How near to the limits over the load steps", units);
  return {{html_section("load-steps", "Over the load steps", head(history, units) + limits), {}},
          {html_section("steps", "From step to step",
                        field + html(charts) + steps_table(history, units)),
           charts}};
}

}  // namespace geneva::post
