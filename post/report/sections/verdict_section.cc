#include "post/report/sections/verdict_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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

std::string percent(const double ratio) {
  const double value = 100. * ratio;
  return std::abs(value) < 0.005 ? "0.00 %" : fmt::format("{:+.2f} %", value);
}

std::string difference(const json& row) {
  const json& computed = row.at("computed");
  const json& form = row.at("closed_form");
  const bool is_comparable = row.at("bounded") == true && !computed.is_null() && !form.is_null();
  if (!is_comparable || number_of(form) == 0.) return "–";
  return percent(number_of(computed) / number_of(form) - 1.);
}

/// Where a maximum stress of a body is, in small type; empty for everything else.
std::string place_of(const json& summary, const std::string& quantity) {
  for (const auto& [name, key] :
       {std::pair("von Mises stress, ", "von_mises"), std::pair("tensile stress, ", "tensile")}) {
    const std::string begin = name;
    if (quantity.rfind(begin, 0) != 0 || !summary.contains("strength")) continue;
    const json of_body =
        summary.at("strength").value(quantity.substr(begin.size()), json::object());
    const json stress = of_body.is_object() ? of_body.value(key, json()) : json();
    if (!stress.is_null())
      return "<br><small>" + escaped(stress.at("where").get<std::string>()) + "</small>";
  }
  return "";
}

std::string verdict_table(const json& summary, const UnitSystem units) {
  HtmlTable table{"This program beside closed forms and published values",
                  {"quantity", "this program", "± error", "closed form", "published", "difference"},
                  {}};
  for (const json& row : summary.at("comparison")) {
    const Dimension dimension = dimension_named(row.at("dimension"));
    const auto cell = [&](const char* key) { return shown(row.at(key), dimension, units); };
    table.rows.push_back({escaped(labelled(row.at("quantity"), dimension, units)) +
                              place_of(summary, row.at("quantity")),
                          row.at("bounded") == true ? cell("computed") : "not bounded",
                          "<span class=\"number\">" + shown_error(row.at("error")) + "</span>",
                          cell("closed_form"), cell("published"), difference(row)});
  }
  return table.html();
}

/// A result of unknown error is no ground for a verdict.
bool is_error_known(const json& summary) {
  return summary.at("accuracy").at("error_estimate").get<double>() < 1.;
}

/// Whether the result is as accurate as wanted, in a sentence.
std::string verdict_sentence(const json& summary) {
  const json& solver = summary.at("solver");
  const double error = summary.at("accuracy").at("error_estimate");
  const std::string of = summary.at("accuracy").at("of");
  const std::string estimate =
      is_error_known(summary)
          ? fmt::format("The estimated error of the {} is {:.2g} %", of, 100. * error)
          : fmt::format("The error of the {} is not known", of);
  std::string text = fmt::format("<p class=\"verdict\">{}; {:.2g} % was asked for.</p>\n", estimate,
                                 100. * summary.at("accuracy").at("wanted").get<double>());
  const std::string message = solver.at("message");
  if (!message.empty())
    text += fmt::format(
        "<p class=\"warning\"><strong>{}</strong> {}</p>\n",
        solver.at("converged").get<bool>() ? "Warning:" : "Not converged:", escaped(message));
  return text;
}

/// The figure that the case is about, in large type: "peak contact pressure 177.84 MPa ± 0.16 %".
std::string main_figure(const json& summary, const UnitSystem units) {
  const json* main = nullptr;
  for (const json& row : summary.at("comparison"))
    if (main == nullptr || row.at("quantity") == "peak contact pressure" ||
        (row.at("quantity") == "edge pressure" && row.at("bounded") == false))
      main = &row;
  if (main == nullptr) return "";
  const Dimension dimension = dimension_named(main->at("dimension"));
  if (main->at("bounded") == false) return answer(escaped(main->at("quantity")), "not bounded", "");
  const std::string where =
      summary.contains("load") ? " " + at_angle(summary.at("load").at("driver_angle"), units) : "";
  return answer(
      escaped(main->at("quantity")), shown_with_unit(main->at("computed"), dimension, units),
      (is_error_known(summary) ? shown_error(main->at("error")) : "(error not known)") + where);
}

std::string notices(const json& summary) {
  std::string text;
  for (const json& notice : summary.at("notices"))
    text += fmt::format("<p class=\"warning\"><strong>Note:</strong> {}</p>\n",
                        escaped(notice.get<std::string>()));
  return text;
}

std::string checks_table(const json& summary) {
  HtmlTable table{"What must be small in a sound result",
                  {"check", "value", "limit", "verdict", "meaning"},
                  {}};
  for (const json& check : summary.at("checks")) {
    const bool is_passed = check.at("passed");
    table.rows.push_back({escaped(check.at("name")),
                          check.at("value").is_null()
                              ? "not known"
                              : fmt::format("{:.2g}", check.at("value").get<double>()),
                          fmt::format("{:.2g}", check.at("limit").get<double>()),
                          is_passed ? "<span class=\"pass\">✓ passed</span>"
                                    : "<span class=\"fail\">✗ failed</span>",
                          escaped(check.at("meaning"))});
  }
  return table.html();
}

/// A figure of cycle.json that a limit of the run is for: its value and its driver angle.
struct OverCycle {
  const json* value;
  const json* driver_angle;
};

bool begins_with(const std::string& text, const std::string& begin) {
  return text.rfind(begin, 0) == 0;
}

/// What the instants of a cycle say of the quantity of a limit; nothing where they do not know it.
std::optional<OverCycle> over_cycle(const std::string& quantity, const json& cycle) {
  const json& greatest = cycle.at("greatest");
  if (begins_with(quantity, "contact, ") || quantity == "peak contact pressure") {
    if (greatest.is_null()) return std::nullopt;
    return OverCycle{&greatest.at("contact").at("peak_pressure"), &greatest.at("driver_angle")};
  }
  for (const json& range : cycle.at("stresses")) {
    const std::string name = range.at("quantity").get<std::string>() + " away from the contact";
    const std::string body = ", " + range.at("body").get<std::string>();
    if (quantity == name + body) return OverCycle{&range.at("value"), &range.at("driver_angle")};
    if (quantity == name + " (fatigue)" + body)
      return OverCycle{&range.at("range"), &range.at("driver_angle")};
  }
  return std::nullopt;
}

/// The limits beside what `geneva cycle` found over the engagement; empty without either.
std::string cycle_table(const json& summary, const json* const cycle, const UnitSystem units) {
  if (cycle == nullptr) return "";
  HtmlTable table{"The same limits over the engagement, by finite elements at every instant",
                  {"quantity", "greatest", labelled("driver angle", Dimension::angle, units),
                   "allowed", "safety factor", "verdict"},
                  {}};
  for (const json& row : summary.at("safety")) {
    const auto found = over_cycle(row.at("quantity"), *cycle);
    if (!found) continue;
    const double factor = number_of(row.at("allowed")) / number_of(*found->value);
    table.rows.push_back({escaped(labelled(row.at("quantity"), Dimension::stress, units)),
                          shown(*found->value, Dimension::stress, units),
                          shown(*found->driver_angle, Dimension::angle, units),
                          shown(row.at("allowed"), Dimension::stress, units),
                          significant(factor, 3), verdict_cell(factor)});
  }
  return table.rows.empty() ? "" : table.html();
}

}  // namespace

std::string run_answer(const ResultsDirectory& results, const UnitSystem units) {
  const json& summary = *results.document("summary");
  const json& safety = summary.at("safety");
  if (is_error_known(summary) || safety.empty())
    return main_figure(summary, units) + nearest_limit(safety, units);
  return main_figure(summary, units) +
         answer("least safety factor", "not judged", "as the error is not known");
}

ReportPart verdict_part(const ResultsDirectory& results) {
  const json& summary = *results.document("summary");
  return {html_section(
              "verdict", "Verdict",
              run_answer(results, results.units()) + verdict_sentence(summary) + notices(summary) +
                  verdict_table(summary, results.units()) +
                  run_limits_table(summary.at("safety"), results.units(), is_error_known(summary)) +
                  cycle_table(summary, results.document("cycle"), results.units())),
          {}};
}

ReportPart checks_part(const ResultsDirectory& results) {
  return {html_section("checks", "Is it right?", checks_table(*results.document("summary"))), {}};
}

}  // namespace geneva::post
