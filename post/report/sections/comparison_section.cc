#include "post/report/sections/comparison_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <regex>
#include <utility>

#include "base/base64.h"
#include "base/errors.h"
#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/sections/field_section.h"
#include "post/report/sections/inputs_section.h"
#include "post/report/sections/run_section.h"
#include "post/report/sections/verdict_section.h"

namespace geneva::post {

using base::Dimension;
using base::dimension_named;
using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;

using nlohmann::json;

namespace {

const json& summary_of(const ResultsDirectory& results) {
  const json* const summary = results.document("summary");
  if (summary == nullptr)
    throw base::InputError(
        fmt::format("{} holds no run: a comparison needs summary.json, which 'geneva run' writes",
                    results.path.string()));
  return *summary;
}

/// Names of the cases; with their directories where two have the same.
std::vector<std::string> names_of(const std::vector<ResultsDirectory>& all) {
  std::map<std::string, int> counts;
  for (const ResultsDirectory& results : all) ++counts[results.about().at("name")];
  std::vector<std::string> names;
  for (const ResultsDirectory& results : all) {
    const std::string name = results.about().at("name");
    names.push_back(counts[name] == 1 ? name : fmt::format("{} ({})", name, results.path.string()));
  }
  return names;
}

/// Rows of all closing tables in the order of their first appearance.
std::vector<const json*> rows_of(const std::vector<ResultsDirectory>& all) {
  std::vector<const json*> rows;
  for (const ResultsDirectory& results : all)
    for (const json& row : summary_of(results).at("comparison"))
      if (std::none_of(rows.begin(), rows.end(), [&](const json* known) {
            return known->at("quantity") == row.at("quantity");
          }))
        rows.push_back(&row);
  return rows;
}

std::string computed_cell(const json& summary, const json& like, const UnitSystem units) {
  for (const json& row : summary.at("comparison"))
    if (row.at("quantity") == like.at("quantity")) {
      if (row.at("bounded") == false) return "not bounded";
      const std::string value =
          shown(row.at("computed").is_null() ? row.at("closed_form") : row.at("computed"),
                dimension_named(row.at("dimension")), units);
      return row.at("error").is_null() ? value : value + " " + shown_error(row.at("error"));
    }
  return "–";
}

std::string error_cell(const json& summary) {
  const double error = summary.at("accuracy").at("error_estimate");
  return error < 1. ? fmt::format("{:.2g} %", 100. * error) : "not known";
}

std::string checks_cell(const json& summary) {
  const json& checks = summary.at("checks");
  const auto passed = std::count_if(checks.begin(), checks.end(),
                                    [](const json& check) { return check.at("passed") == true; });
  const bool is_all = static_cast<std::size_t>(passed) == checks.size();
  return fmt::format("<span class=\"{}\">{} {} of {} passed</span>", is_all ? "pass" : "fail",
                     is_all ? "✓" : "✗", passed, checks.size());
}

std::string table_of(const std::vector<ResultsDirectory>& all,
                     const std::vector<std::string>& names, const UnitSystem units) {
  HtmlTable table{"What the runs computed", {"quantity"}, {}};
  for (const std::string& name : names) table.headings.push_back(escaped(name));
  const auto add = [&](const std::string& name, const auto& cell) {
    std::vector<std::string> row{name};
    for (const ResultsDirectory& results : all) row.push_back(cell(summary_of(results)));
    table.rows.push_back(std::move(row));
  };
  add("dimensions", [](const json& summary) { return summary.at("case").at("dimension").dump(); });
  for (const json* const row : rows_of(all))
    add(escaped(labelled(row->at("quantity"), dimension_named(row->at("dimension")), units)),
        [&](const json& summary) { return computed_cell(summary, *row, units); });
  add("estimated error", error_cell);
  add("checks", checks_cell);
  add("unknowns",
      [](const json& summary) { return grouped(summary.at("mesh").at("dofs").dump()); });
  return table.html();
}

/// Each run's answer in large type: its main figure and its least safety factor.
std::string answers_of(const std::vector<ResultsDirectory>& all,
                       const std::vector<std::string>& names, const UnitSystem units) {
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    text += fmt::format("<h3>{}</h3>\n", escaped(names[i])) + run_answer(all[i], units);
  return "<div class=\"answers\">\n" + text + "</div>\n";
}

/// Value of an input; a dash where the case has none of that name.
std::string input_cell(const std::vector<CaseInput>& inputs, const std::string& name) {
  for (const CaseInput& input : inputs)
    if (input.name == name) return input.value.empty() ? "–" : escaped(shown_value(input));
  return "–";
}

/// The inputs in which the runs differ; empty if their case files are not there.
std::string inputs_table(const std::vector<ResultsDirectory>& all,
                         const std::vector<std::string>& names) {
  std::vector<std::vector<CaseInput>> inputs;
  for (const ResultsDirectory& results : all) inputs.push_back(inputs_of(results));
  HtmlTable table{"Inputs in which they differ", {"parameter"}, {}};
  for (const std::string& name : names) table.headings.push_back(escaped(name));
  std::vector<std::string> seen;
  for (const std::vector<CaseInput>& of_run : inputs)
    for (const CaseInput& input : of_run) {
      if (input.name == "Title" || input.is_published ||
          std::find(seen.begin(), seen.end(), input.name) != seen.end())
        continue;
      seen.push_back(input.name);
      std::vector<std::string> row{escaped(input.name)};
      for (const std::vector<CaseInput>& each : inputs) row.push_back(input_cell(each, input.name));
      if (std::any_of(row.begin() + 2, row.end(),
                      [&](const std::string& cell) { return cell != row[1]; }))
        table.rows.push_back(std::move(row));
    }
  return table.rows.empty() ? "" : table.html();
}

/// The numbers of a text, and what stands between them.
struct NumberedText {
  std::vector<std::string> numbers;
  std::string between;

  explicit NumberedText(const std::string& text) {
    static const std::regex number("-?[0-9][0-9.]*(e[-+]?[0-9]+)?");
    std::size_t end = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), number); at != std::sregex_iterator();
         ++at) {
      const auto begin = static_cast<std::size_t>(at->position());
      between += text.substr(end, begin - end) + '\n';
      end = begin + static_cast<std::size_t>(at->length());
      numbers.push_back(at->str());
    }
    between += text.substr(end);
  }
};

/// What is said of runs, and how other runs' numbers differ in it.
struct Warning {
  std::string text;
  NumberedText parts;
  std::string runs;    // of just that text
  std::string others;  // HTML

  explicit Warning(const std::string& said) : text(said), parts(said) {}

  void add(const std::string& run, const NumberedText& said) {
    std::vector<std::string> differences;
    for (std::size_t i = 0; i < said.numbers.size(); ++i)
      if (said.numbers[i] != parts.numbers[i])
        differences.push_back(said.numbers[i] + " for " + parts.numbers[i]);
    if (differences.empty())
      runs += (runs.empty() ? "" : ", ") + run;
    else
      others += fmt::format("<br><strong>{}:</strong> the same with {}", escaped(run),
                            escaped(fmt::format("{}", fmt::join(differences, ", "))));
  }
};

/// Each once, with the runs that have it.
std::string warnings_of(const std::vector<ResultsDirectory>& all,
                        const std::vector<std::string>& names) {
  std::vector<Warning> warnings;
  const auto add = [&](const std::string& run, const std::string& text) {
    const NumberedText said(text);
    auto same = std::find_if(warnings.begin(), warnings.end(), [&](const Warning& known) {
      return known.parts.between == said.between;
    });
    if (same == warnings.end()) same = warnings.emplace(warnings.end(), text);
    same->add(run, said);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const json& summary = summary_of(all[i]);
    const std::string message = summary.at("solver").at("message");
    if (!message.empty()) add(names[i], message);
    for (const json& notice : summary.at("notices")) add(names[i], notice);
  }
  std::string text;
  for (const Warning& warning : warnings)
    text += fmt::format("<p class=\"warning\"><strong>{}:</strong> {}{}</p>\n",
                        escaped(warning.runs), escaped(warning.text), warning.others);
  return text;
}

/// A chart of each run laid over those of the others, in the first one's units.
Chart laid_over(const std::vector<ResultsDirectory>& all, const std::vector<std::string>& names,
                const std::string& id, const Dimension x, const Dimension y) {
  Chart result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto factor = [&](const Dimension dimension) {
      return output_unit(all.front().units(), dimension).factor /
             output_unit(all[i].units(), dimension).factor;
    };
    for (const Chart& chart : contact_part(all[i]).charts) {
      if (chart.id != id) continue;
      if (result.id.empty()) {
        result = chart;
        const OutputUnit x_unit = output_unit(all.front().units(), x);
        const OutputUnit y_unit = output_unit(all.front().units(), y);
        const auto relabel = [](std::string& label, const std::string& unit) {
          label = label.substr(0, label.find(" [")) + " [" + unit + "]";
        };
        relabel(result.x.label, shown_unit(x_unit.name));
        relabel(result.y.label, shown_unit(y_unit.name));
        result.series.clear();
      }
      ChartSeries series = chart.series.front();
      series.name = names[i];
      series.style = SeriesStyle::line;
      for (auto& [at, value] : series.points) {
        at *= factor(x);
        value *= factor(y);
      }
      result.series.push_back(std::move(series));
    }
  }
  return result;
}

std::vector<Chart> charts_of(const std::vector<ResultsDirectory>& all,
                             const std::vector<std::string>& names) {
  std::vector<Chart> charts;
  for (const Chart& chart :
       {laid_over(all, names, "chart-pressure", Dimension::length, Dimension::stress),
        laid_over(all, names, "chart-line-load", Dimension::length, Dimension::force_per_length),
        laid_over(all, names, "chart-section-pressure", Dimension::length, Dimension::stress)})
    if (!chart.id.empty()) charts.push_back(chart);
  for (Chart& chart : charts) chart.title = chart.title.substr(0, chart.title.find(" beside"));
  return charts;
}

/// What is multiplied with SI values to get a run's output units.
double factor_of(const ResultsDirectory& results, const Dimension dimension) {
  return output_unit(results.units(), dimension).factor;
}

/// The scales that all pictures share, in SI units: of colours and of lengths.
PictureScales shared_scales(const std::vector<ResultsDirectory>& all) {
  PictureScales shared;
  for (const ResultsDirectory& results : all) {
    const json* const view = results.document("view");
    if (view == nullptr) continue;
    const double stress = factor_of(results, Dimension::stress);
    const double pixels =
        picture_scale(*view, main_part(*view)) * factor_of(results, Dimension::length);
    const std::array<double, 2> range = field_range(*view, main_part(*view));
    const auto& known = shared.range;
    shared.range = {std::min(known ? (*known)[0] : range[0] / stress, range[0] / stress),
                    std::max(known ? (*known)[1] : range[1] / stress, range[1] / stress)};
    shared.pixels = std::min(pixels, shared.pixels.value_or(pixels));
  }
  return shared;
}

/// The same in the output units of a run.
PictureScales in_units_of(const ResultsDirectory& results, const PictureScales& scales) {
  const double stress = factor_of(results, Dimension::stress);
  return {std::array<double, 2>{(*scales.range)[0] * stress, (*scales.range)[1] * stress},
          *scales.pixels / factor_of(results, Dimension::length)};
}

/// The pictures as images of their own, since names within an SVG must not meet on a page.
std::string pictures_of(const std::vector<ResultsDirectory>& all,
                        const std::vector<std::string>& names) {
  const PictureScales scales = shared_scales(all);
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const json* const view = all[i].document("view");
    if (view == nullptr) continue;
    const std::string svg = field_picture(*view, main_part(*view), in_units_of(all[i], scales));
    text += fmt::format(
        "<figure class=\"picture\">\n<img alt=\"von Mises stress of {0}\" "
        "src=\"data:image/svg+xml;base64,{1}\">\n<figcaption>{0}</figcaption>\n</figure>\n",
        escaped(names[i]), base::encoded_bytes({svg.begin(), svg.end()}));
  }
  return text;
}

}  // namespace

ReportPart comparison_part(const std::vector<ResultsDirectory>& all) {
  for (const ResultsDirectory& results : all) summary_of(results);  // refuses what is no run
  const std::vector<std::string> names = names_of(all);
  const UnitSystem units = all.front().units();
  ReportPart part;
  part.charts = charts_of(all, names);
  part.html = html_section("verdict", "Side by side",
                           answers_of(all, names, units) + table_of(all, names, units) +
                               inputs_table(all, names) + warnings_of(all, names)) +
              (part.charts.empty() ? "" : html_section("contact", "Contact", html(part.charts))) +
              html_section("field", "von Mises stress",
                           "<div class=\"pictures\">\n" + pictures_of(all, names) + "</div>\n");
  return part;
}

}  // namespace geneva::post
