#include "post/report/sections/optimum_section.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"

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
  HtmlTable table{"What they make of it",
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

}  // namespace

ReportPart optimum_part(const ResultsDirectory& results) {
  const json& optimum = *results.document("optimum");
  std::string binds;
  for (const json& word : optimum.at("binds"))
    binds += (binds.empty() ? "" : ", ") + escaped(word.get<std::string>());
  const std::string head =
      fmt::format("<p>Least {}, of {} candidates. {}</p>\n", escaped(optimum.at("goal")),
                  optimum.at("trials").get<int>(),
                  binds.empty() ? "Nothing binds: it is a minimum within all bounds and limits."
                                : "What binds: " + binds + ".");
  return {html_section("optimum", "Best dimensions",
                       head + dimensions_table(optimum) + optimum_table(optimum, results.units())),
          {}};
}

}  // namespace geneva::post
