#include "post/report/sections/optimum_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/sections/limits.h"

namespace geneva::post {

using nlohmann::json;

namespace {

std::string dimensions_table(const json& optimum) {
  HtmlTable table{"Dimensions", {"dimension", "as it is", "best", "bound"}, {}};
  for (const json& row : optimum.at("dimensions")) {
    const std::string before = row.at("before");
    table.rows.push_back({escaped(row.at("name")),
                          before.empty() ? "by rule" : escaped(shown_input(before)),
                          escaped(shown_input(row.at("after"))), escaped(row.at("bound"))});
  }
  return table.html();
}

std::string optimum_table(const json& optimum, const base::UnitSystem units) {
  HtmlTable table{"As it is, and with the best dimensions",
                  {"quantity", "as it is", "best", "limit", "finite elements", "± error"},
                  {}};
  for (const json& row : optimum.at("figures")) {
    const base::Dimension dimension = base::dimension_named(row.at("dimension"));
    const auto cell = [&](const char* const key) { return shown(row.at(key), dimension, units); };
    table.rows.push_back({escaped(labelled(row.at("quantity"), dimension, units)), cell("before"),
                          cell("after"), cell("limit"), cell("confirmed"),
                          shown_error(row.at("confirmed_error"))});
  }
  return table.html();
}

/// What was to be least, in large type, beside what it is, and how near the nearest limit is.
std::string answer_of_optimum(const json& optimum, const base::UnitSystem units) {
  std::string text;
  const json* nearest = nullptr;
  const auto used = [](const json& row) {  // of what is allowed; "least ..." is a limit from below
    const double limit = number_of(row.at("limit"));
    const double share = number_of(row.at("after")) / limit;
    const bool is_from_below = row.at("quantity").get<std::string>().rfind("least ", 0) == 0;
    if (is_from_below || row.at("confirmed").is_null()) return is_from_below ? 1. / share : share;
    const json& error = row.at("confirmed_error");
    const double by_elements =
        number_of(row.at("confirmed")) / (1. + (error.is_null() ? 0. : error.get<double>()));
    return std::max(share, by_elements / limit);
  };
  for (const json& row : optimum.at("figures")) {
    const base::Dimension dimension = base::dimension_named(row.at("dimension"));
    if (row.at("quantity") == optimum.at("goal"))
      text = answer("least " + escaped(row.at("quantity")),
                    shown_with_unit(row.at("after"), dimension, units),
                    row.at("before").is_null()
                        ? ""
                        : "instead of " + shown_with_unit(row.at("before"), dimension, units));
    if (!row.at("limit").is_null() && (nearest == nullptr || used(row) > used(*nearest)))
      nearest = &row;
  }
  if (nearest == nullptr) return text;
  constexpr double rounding = 1e-6;
  const base::Dimension dimension = base::dimension_named(nearest->at("dimension"));
  return text + answer("nearest limit", shown_with_unit(nearest->at("after"), dimension, units),
                       fmt::format("{}, {} allowed {}", escaped(nearest->at("quantity")),
                                   shown_with_unit(nearest->at("limit"), dimension, units),
                                   used(*nearest) <= 1. + rounding
                                       ? "<span class=\"pass\">✓ pass</span>"
                                       : "<span class=\"fail\">✗ EXCEEDED</span>"));
}

}  // namespace

AnsweredPart optimum_part(const ResultsDirectory& results) {
  const json& optimum = *results.document("optimum");
  std::string binds;
  for (const json& word : optimum.at("binds"))
    binds += (binds.empty() ? "" : ", ") + escaped(word.get<std::string>());
  const std::string head = fmt::format(
      "<p>Least {}, of {} candidates; pressures by {}. {}</p>\n", escaped(optimum.at("goal")),
      optimum.at("trials").get<int>(), escaped(optimum.at("basis")),
      binds.empty() ? "Nothing binds: it is a minimum within all bounds and limits."
                    : "What binds: " + binds + ".");
  const base::UnitSystem units = results.units();
  return {{html_section("optimum", "Best dimensions",
                        answer_of_optimum(optimum, units) + head + dimensions_table(optimum)),
           {}},
          {html_section(
               "figures", "What they make of it",
               optimum_table(optimum, units) +
                   limits_table(optimum.at("safety"),
                                "What the materials of the best case bear over the cycle", units)),
           {}}};
}

}  // namespace geneva::post
