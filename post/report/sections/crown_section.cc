#include "post/report/sections/crown_section.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/sections/limits.h"

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::UnitSystem;

using nlohmann::json;

namespace {

struct Pin {
  const char* key;   ///< in crown.json
  const char* name;  ///< in crown.csv
  const char* title;
};
using Pins = std::vector<Pin>;

Pins pins_of(const json& crown) {
  Pins pins{{"before", "before", "as it is"}, {"after", "after", "most even"}};
  if (crown.contains("finite_elements"))
    pins.push_back({"finite_elements", "finite elements", "most even, by finite elements"});
  return pins;
}

std::string evenness_table(const json& crown, const UnitSystem units) {
  constexpr std::array<NamedQuantity, 5> lines{
      {{"maximum_line_load", "maximum line load", Dimension::force_per_length},
       {"maximum_line_load_place", "its place along the pin", Dimension::length},
       {"even_line_load", "even line load", Dimension::force_per_length},
       {"mid_length_pressure", "contact pressure in the middle", Dimension::stress},
       {"peak_pressure", "peak contact pressure", Dimension::stress}}};
  HtmlTable table{
      "The pin of the case, and with the profile of the most even line load", {"quantity"}, {}};
  const Pins pins = pins_of(crown);
  for (const Pin& pin : pins) table.headings.emplace_back(pin.title);
  const auto add = [&](const std::string& name, const auto& value_of) {
    table.rows.push_back({escaped(name)});
    for (const Pin& pin : pins) table.rows.back().push_back(value_of(crown.at(pin.key)));
  };
  add("maximum over even line load",
      [](const json& pin) { return significant(pin.at("ratio"), 4); });
  for (const NamedQuantity& line : lines)
    add(labelled(line.name, line.dimension, units),
        [&](const json& pin) { return shown(pin.at(line.key), line.dimension, units); });
  add("pressure at the ends", [](const json& pin) -> std::string {
    return pin.at("edge_bounded").get<bool>() ? "bounded" : "not bounded";
  });
  return table.html();
}

std::string finding(const json& crown, const UnitSystem units) {
  const json& found = crown.at("crown");
  const std::string unit = output_unit(units, Dimension::length).name;
  std::string duty = fmt::format("under {} {}", shown(found.at("force"), Dimension::force, units),
                                 output_unit(units, Dimension::force).name);
  const auto degrees = [&](const char* const key) {
    return significant(in_units(found.at(key), Dimension::angle, units), 3);
  };
  if (found.at("least_tilt") != found.at("greatest_tilt"))
    duty += fmt::format(" and for tilts from {} to {} deg, of which {} deg is the worst",
                        degrees("least_tilt"), degrees("greatest_tilt"), degrees("worst_tilt"));
  return fmt::format(
      "<p class=\"verdict\">Profile = {}, {} = {} {} makes the line load most even {}; it falls {} "
      "{} to the wheel's faces.</p>\n",
      escaped(found.at("profile")), escaped(found.at("parameter")),
      significant(in_units(found.at("size"), Dimension::length, units), 4), unit, duty,
      significant(in_units(found.at("drop"), Dimension::length, units), 3), unit);
}

Chart along_pin(const Pins& pins, const CsvTable& table, const char* const column,
                const std::string& name) {
  const auto label = [&](const std::string& text, const char* const of) {
    return fmt::format("{} [{}]", text, shown_unit(table.column(of).unit));
  };
  Chart chart{fmt::format("chart-crown-{}", column),
              fmt::format("The {} along the pin", name),
              fmt::format("The {} along the pin, as it is and with the most even load", name),
              {label("place along the pin, z", "z")},
              {label(name, column)},
              {}};
  for (const auto& [key, in_table, title] : pins) {
    const CsvTable rows = table.rows_with("pin", in_table);
    const bool is_checked = std::string(key) == "finite_elements";
    ChartSeries series{title, is_checked ? SeriesStyle::markers : SeriesStyle::line, {}};
    for (std::size_t i = 0; i < rows.n_rows(); ++i)
      series.points.push_back({rows.column("z").values[i], rows.column(column).values[i]});
    chart.series.push_back(series);
  }
  return chart;
}

Chart search_chart(const json& crown, const UnitSystem units) {
  const std::string parameter = crown.at("crown").at("parameter");
  Chart chart{"chart-crown-search",
              "The search",
              fmt::format("Maximum over even line load against the {}", parameter),
              {labelled(parameter, Dimension::length, units), true},
              {"maximum over even line load"},
              {{"tried", SeriesStyle::markers, {}}}};
  for (const json& trial : crown.at("search"))
    chart.series[0].points.push_back(
        {in_units(trial.at("size"), Dimension::length, units), trial.at("ratio").get<double>()});
  return chart;
}

/// The valley: pressure of the maximum line load against the size, a line for each tilt.
Chart map_chart(const json& crown, const UnitSystem units) {
  const std::string parameter = crown.at("crown").at("parameter");
  const json& map = crown.at("map");
  Chart chart{"chart-crown-map",
              "Pressure by size and tilt",
              fmt::format("Contact pressure of the maximum line load against the {}", parameter),
              {labelled(parameter, Dimension::length, units), true},
              {labelled("contact pressure", Dimension::stress, units)},
              {}};
  for (const json& row : map.at("by_tilt")) {
    const double tilt = row.at("tilt").get<double>() * output_unit(units, Dimension::angle).factor;
    ChartSeries series{fmt::format("tilt {:.3g} deg", tilt), SeriesStyle::line, {}};
    for (std::size_t i = 0; i < map.at("sizes").size(); ++i)
      series.points.push_back(
          {map.at("sizes")[i].get<double>() * output_unit(units, Dimension::length).factor,
           row.at("pressures")[i].get<double>() * output_unit(units, Dimension::stress).factor});
    chart.series.push_back(series);
  }
  return chart;
}

/// What was found in large type, and how even the load is with it.
std::string answer_of_crown(const json& crown, const UnitSystem units) {
  const json& found = crown.at("crown");
  return answer("most even " + escaped(found.at("parameter")),
                shown_with_unit(found.at("size"), Dimension::length, units),
                fmt::format("maximum over even line load {} instead of {}",
                            significant(crown.at("after").at("ratio"), 4),
                            significant(crown.at("before").at("ratio"), 4)));
}

}  // namespace

AnsweredPart crown_part(const ResultsDirectory& results) {
  const json& crown = *results.document("crown");
  const CsvTable& table = *results.table("crown");
  const UnitSystem units = results.units();
  const Pins pins = pins_of(crown);
  const std::vector<Chart> charts{along_pin(pins, table, "line_load", "line load"),
                                  along_pin(pins, table, "peak_pressure", "contact pressure"),
                                  map_chart(crown, units), search_chart(crown, units)};
  return {{html_section("crown", "Crown of the pin",
                        answer_of_crown(crown, units) + finding(crown, units)),
           {}},
          {html_section("evenness", "How even the load is",
                        evenness_table(crown, units) + html(charts)),
           charts}};
}

}  // namespace geneva::post
