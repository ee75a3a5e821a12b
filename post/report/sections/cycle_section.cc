#include "post/report/sections/cycle_section.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/sections/limits.h"

namespace geneva::post {

using base::Dimension;
using base::UnitSystem;
using nlohmann::json;

namespace {

double angle_of(const json& instant, const UnitSystem units) {
  return in_units(instant.at("driver_angle"), Dimension::angle, units);
}

Chart chart_over_angle(const std::string& id, const std::string& title, const std::string& quantity,
                       const Dimension dimension, const UnitSystem units) {
  Chart chart{"chart-cycle-" + id,
              title,
              title + ", against the driver angle",
              driver_angle_axis(units),
              {labelled(quantity, dimension, units)},
              {}};
  chart.is_over_cycle = true;
  return chart;
}

/// A column of the curve between the instants.
ChartSeries curve_series(const json& curve, const char* const column, const std::string& name,
                         const SeriesStyle style, const Dimension dimension,
                         const UnitSystem units) {
  const double degrees = base::output_unit(units, Dimension::angle).factor;
  const double factor = base::output_unit(units, dimension).factor;
  ChartSeries series{name, style, {}};
  const json& angles = curve.at("driver_angle");
  for (std::size_t i = 0; i < angles.size(); ++i)
    if (const json& value = curve.at(column)[i]; !value.is_null())
      series.points.push_back({angles[i].get<double>() * degrees, value.get<double>() * factor});
  return series;
}

/// What the contact of each instant says, where it says it.
ChartSeries instants_series(const json& cycle, const char* const key, const std::string& name,
                            const SeriesStyle style, const Dimension dimension,
                            const UnitSystem units) {
  ChartSeries series{name, style, {}};
  for (const json& instant : cycle.at("instants")) {
    const json& contact = instant.at("contact");
    if (contact.is_null() || contact.at(key).is_null()) continue;
    series.points.push_back(
        {angle_of(instant, units), in_units(contact.at(key), dimension, units)});
  }
  return series;
}

Chart pressure_chart(const json& cycle, const UnitSystem units) {
  constexpr Dimension stress = Dimension::stress;
  const json& curve = cycle.at("curve");
  Chart chart = chart_over_angle("pressure", "Peak contact pressure over the engagement",
                                 "peak contact pressure", stress, units);
  chart.series = {
      curve_series(curve, "peak_pressure", "finite elements", SeriesStyle::line, stress, units),
      curve_series(curve, "hertz_pressure", "Hertz", SeriesStyle::dashed, stress, units),
      instants_series(cycle, "peak_pressure", "instants solved", SeriesStyle::markers, stress,
                      units)};
  return chart;
}

Chart force_chart(const json& cycle, const UnitSystem units) {
  Chart chart = chart_over_angle("force", "Pin force; negative: on the braking wall", "pin force",
                                 Dimension::force, units);
  chart.series = {curve_series(cycle.at("curve"), "pin_force", "pin force", SeriesStyle::line,
                               Dimension::force, units)};
  return chart;
}

Chart torque_chart(const json& cycle, const UnitSystem units) {
  Chart chart = chart_over_angle("torque", "Torque that the wheel's shaft takes", "torque",
                                 Dimension::moment, units);
  chart.series = {instants_series(cycle, "bore_torque", "finite elements", SeriesStyle::markers,
                                  Dimension::moment, units),
                  instants_series(cycle, "expected_bore_torque", "load", SeriesStyle::dashed,
                                  Dimension::moment, units)};
  return chart;
}

/// Pressure times slip at the wall: wear and heat.
Chart slip_chart(const json& cycle, const UnitSystem units) {
  constexpr Dimension wear = Dimension::pressure_times_speed;
  Chart chart = chart_over_angle("slip", "Peak pressure times slip speed on the wall",
                                 "pressure times slip", wear, units);
  const json& curve = cycle.at("curve");
  const double degrees = base::output_unit(units, Dimension::angle).factor;
  const double factor = base::output_unit(units, wear).factor;
  ChartSeries series{"pressure times slip", SeriesStyle::line, {}};
  for (std::size_t i = 0; i < curve.at("driver_angle").size(); ++i)
    if (const json& pressure = curve.at("peak_pressure")[i]; !pressure.is_null())
      series.points.push_back(
          {curve.at("driver_angle")[i].get<double>() * degrees,
           factor * pressure.get<double>() * std::abs(curve.at("slip_speed")[i].get<double>())});
  chart.series = {series};
  return chart;
}

/// Maximum stresses away from the contact, each body and kind a line.
Chart stress_chart(const json& cycle, const UnitSystem units) {
  Chart chart = chart_over_angle("stress", "Maximum stresses away from the contact",
                                 "maximum stress", Dimension::stress, units);
  for (const json& range : cycle.at("stresses")) {
    ChartSeries series{fmt::format("{}, {}", range.at("body").get<std::string>(),
                                   range.at("quantity").get<std::string>()),
                       chart.series.empty() ? SeriesStyle::line : SeriesStyle::dashed,
                       {}};
    for (const json& instant : cycle.at("instants")) {
      if (instant.at("contact").is_null()) continue;
      for (const json& stress : instant.at("contact").at("stresses"))
        if (stress.at("body") == range.at("body") && stress.at("quantity") == range.at("quantity"))
          series.points.push_back(
              {angle_of(instant, units), in_units(stress.at("value"), Dimension::stress, units)});
    }
    chart.series.push_back(series);
  }
  return chart;
}

std::string instants_table(const json& cycle, const UnitSystem units) {
  HtmlTable table{"Instants",
                  {labelled("driver angle", Dimension::angle, units), "why", "wall",
                   labelled("pin force", Dimension::force, units),
                   labelled("peak pressure", Dimension::stress, units), "± error",
                   labelled("Hertz", Dimension::stress, units)},
                  {}};
  for (const json& instant : cycle.at("instants")) {
    const json& contact = instant.at("contact");
    table.rows.push_back(
        {shown(instant.at("driver_angle"), Dimension::angle, units), escaped(instant.at("role")),
         escaped(instant.at("wall")), shown(instant.at("pin_force"), Dimension::force, units),
         contact.is_null() ? "–" : shown(contact.at("peak_pressure"), Dimension::stress, units),
         contact.is_null() ? "–" : shown_error(contact.at("error")),
         shown(instant.at("hertz_pressure"), Dimension::stress, units)});
  }
  return table.html();
}

std::string stresses_table(const json& cycle, const UnitSystem units) {
  HtmlTable table{"Maximum stresses away from the contact over the engagement",
                  {"body", "stress", labelled("greatest", Dimension::stress, units), "± error",
                   labelled("at", Dimension::angle, units), "where",
                   labelled("range", Dimension::stress, units)},
                  {}};
  for (const json& range : cycle.at("stresses"))
    table.rows.push_back(
        {escaped(range.at("body")), escaped(range.at("quantity")),
         shown(range.at("value"), Dimension::stress, units), shown_error(range.at("error")),
         shown(range.at("driver_angle"), Dimension::angle, units), escaped(range.at("where")),
         shown(range.at("range"), Dimension::stress, units)});
  return table.html();
}

/// Earlier versions have none.
json limits_of(const json& cycle) { return cycle.value("safety", json::array()); }

/// The answer first.
std::string head(const json& cycle, const UnitSystem units) {
  const json& greatest = cycle.at("greatest");
  std::string text;
  if (!greatest.is_null())
    text = answer(
        "greatest peak pressure",
        shown_with_unit(greatest.at("contact").at("peak_pressure"), Dimension::stress, units),
        fmt::format("{} {}, on the {} wall", shown_error(greatest.at("contact").at("error")),
                    at_angle(greatest.at("driver_angle"), units), escaped(greatest.at("wall"))));
  text += nearest_limit(limits_of(cycle), units);
  for (const json& notice : cycle.at("notices"))
    text += fmt::format("<p class=\"warning\"><strong>Note:</strong> {}</p>\n",
                        escaped(notice.get<std::string>()));
  const json& work = cycle.at("work");
  if (const double friction = work.at("friction").at("value"); friction > 0.)
    text +=
        fmt::format("<p>Friction in the slot takes {:.4g} J of each engagement{}.</p>\n", friction,
                    work.at("driving_efficiency").is_null()
                        ? ""
                        : fmt::format(", {:.2f} % of what drives the wheel",
                                      100. * (1. - work.at("driving_efficiency").get<double>())));
  return text;
}

}  // namespace

AnsweredPart cycle_part(const ResultsDirectory& results, const std::string& field) {
  const json& cycle = *results.document("cycle");
  const UnitSystem units = results.units();
  std::vector<Chart> charts{pressure_chart(cycle, units), force_chart(cycle, units),
                            slip_chart(cycle, units)};
  if (Chart torque = torque_chart(cycle, units); !torque.series.front().points.empty())
    charts.push_back(std::move(torque));
  if (Chart stress = stress_chart(cycle, units); !stress.series.empty())
    charts.push_back(std::move(stress));
  const bool stand_in_verdict = results.document("summary") != nullptr;
  const std::string limits =
      stand_in_verdict
          ? ""
          : limits_table(limits_of(cycle), "How near to the limits over the engagement", units);
  return {{html_section("cycle", "Over the engagement", head(cycle, units) + limits), {}},
          {html_section(
               "instants", "From instant to instant",
               field + html(charts) + stresses_table(cycle, units) + instants_table(cycle, units)),
           charts}};
}

}  // namespace geneva::post
