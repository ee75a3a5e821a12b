#include "post/report/sections/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"

namespace geneva::post {

using base::Dimension;
using base::dimension_named;
using base::UnitSystem;
using nlohmann::json;

namespace {

/// Quantity with its unit, and what its limit means.
std::string heading_of(const json& row, const UnitSystem units) {
  const std::string meaning = row.value("meaning", "");
  return escaped(labelled(row.at("quantity"), dimension_named(row.at("dimension")), units)) +
         (meaning.empty() ? "" : "<br><small>" + escaped(meaning) + "</small>");
}

/// The row of the least factor; none is less than any.
const json* nearest_of(const json& safety) {
  const json* nearest = nullptr;
  for (const json& row : safety) {
    const bool is_nearer =
        nearest == nullptr || (!nearest->at("factor").is_null() &&
                               (row.at("factor").is_null() ||
                                number_of(row.at("factor")) < number_of(nearest->at("factor"))));
    if (is_nearer) nearest = &row;
  }
  return nearest;
}

}  // namespace

std::string answer(const std::string& name, const std::string& figure, const std::string& more) {
  return fmt::format("<p class=\"answer\"><span>{}</span> <strong>{}</strong> {}</p>\n", name,
                     figure, more);
}

std::string shown_with_unit(const json& quantity, const Dimension dimension,
                            const UnitSystem units) {
  const std::string unit = shown_unit(base::output_unit(units, dimension).name);
  const std::string value = shown(quantity, dimension, units);
  return quantity.is_null() || unit.empty() ? value : value + " " + escaped(unit);
}

std::string at_angle(const json& driver_angle, const UnitSystem units) {
  if (driver_angle.is_null()) return "";
  return "at a driver angle of " + shown_with_unit(driver_angle, Dimension::angle, units);
}

std::string verdict_cell(const double factor) {
  return factor >= 1. ? "<span class=\"pass\">✓ allowed</span>"
                      : "<span class=\"fail\">✗ exceeded</span>";
}

std::string nearest_limit(const json& safety, const UnitSystem units) {
  const json* const nearest = nearest_of(safety);
  if (nearest == nullptr) return "";
  const double factor = number_of(nearest->at("factor"));
  return answer(
      "least safety factor", std::isnan(factor) ? "none" : significant(factor, 3),
      fmt::format("{} {} {}",
                  factor >= 1. ? "<span class=\"pass\">✓ pass</span>"
                               : "<span class=\"fail\">✗ EXCEEDED</span>",
                  escaped(nearest->at("quantity")), at_angle(nearest->at("driver_angle"), units)));
}

std::string run_limits_table(const json& safety, const UnitSystem units, const bool is_judged) {
  if (safety.empty()) return "";
  const bool has_cycle = std::any_of(safety.begin(), safety.end(), [](const json& row) {
    return !row.at("driver_angle").is_null();
  });
  HtmlTable table{"How near to the limits of case and materials", {"quantity", "as analysed"}, {}};
  if (has_cycle) table.headings.emplace_back("maximum in the cycle");
  table.headings.insert(table.headings.end(), {"allowed", "safety factor"});
  if (has_cycle) table.headings.push_back(labelled("driver angle", Dimension::angle, units));
  table.headings.emplace_back("verdict");
  for (const json& row : safety) {
    const Dimension dimension = dimension_named(row.at("dimension"));
    const bool is_known = !row.at("factor").is_null();
    const double factor = number_of(row.at("factor"));
    const auto value = [&](const char* const key) {
      return is_known ? shown(row.at(key), dimension, units) : std::string("not bounded");
    };
    std::vector<std::string> cells{heading_of(row, units), value("computed")};
    if (has_cycle) cells.push_back(value("cycle"));
    cells.push_back(shown(row.at("allowed"), dimension, units));
    cells.push_back(is_known ? significant(factor, 3) : "none");
    if (has_cycle) cells.push_back(shown(row.at("driver_angle"), Dimension::angle, units));
    cells.push_back(is_judged ? verdict_cell(factor) : "not judged");
    table.rows.push_back(std::move(cells));
  }
  table.kind = "limits";
  return table.html();
}

std::string limits_table(const json& safety, const std::string& caption, const UnitSystem units) {
  if (safety.empty()) return "";
  HtmlTable table{caption,
                  {"quantity", "greatest", "allowed", "safety factor",
                   labelled("driver angle", Dimension::angle, units), "verdict"},
                  {}};
  for (const json& row : safety) {
    const Dimension dimension = dimension_named(row.at("dimension"));
    const double factor = number_of(row.at("factor"));
    table.rows.push_back({heading_of(row, units), shown(row.at("computed"), dimension, units),
                          shown(row.at("allowed"), dimension, units), significant(factor, 3),
                          shown(row.at("driver_angle"), Dimension::angle, units),
                          verdict_cell(factor)});
  }
  table.kind = "limits";
  return table.html();
}

}  // namespace geneva::post
