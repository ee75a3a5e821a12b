#include "post/report/sections/inputs_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"

namespace geneva::post {

namespace {

const CaseInput* input_named(const std::vector<CaseInput>& inputs, const std::string& name) {
  const auto found = std::find_if(inputs.begin(), inputs.end(),
                                  [&](const CaseInput& input) { return input.name == name; });
  return found == inputs.end() ? nullptr : &*found;
}

/// A roller without clearance has no stud of its own, nor has a fixed pin.
bool has_stud(const std::vector<CaseInput>& inputs) {
  const CaseInput* const clearance = input_named(inputs, "Roller bore clearance");
  return clearance != nullptr && !clearance->value.empty();
}

/// The materials of all bodies; empty where the case names none.
std::string materials_table(const std::vector<CaseInput>& inputs) {
  const std::string modulus = "/Young's modulus";
  constexpr std::array<const char*, 6> others{"Poisson's ratio",  "Density",
                                              "Yield strength",   "Fatigue strength",
                                              "Contact pressure", "Material"};
  HtmlTable table{"Materials",
                  {"of", "Young's modulus", "Poisson's ratio", "density", "yield strength",
                   "fatigue strength", "contact pressure", "name"},
                  {}};
  for (const CaseInput& input : inputs) {
    const std::size_t end = input.name.size() - std::min(modulus.size(), input.name.size());
    const std::string of = input.name.substr(0, end);
    if (input.name.substr(end) != modulus || (of == "Stud material" && !has_stud(inputs))) continue;
    std::vector<std::string> row{escaped(of), escaped(shown_value(input))};
    for (const char* const other : others) {
      const CaseInput* const value = input_named(inputs, of + "/" + other);
      const bool is_known = value != nullptr && !value->value.empty();
      row.push_back(is_known ? escaped(shown_value(*value)) : "–");
    }
    table.rows.push_back(std::move(row));
  }
  return table.rows.empty() ? "" : table.html();
}

std::string table_of_inputs(const std::vector<CaseInput>& inputs, const bool is_given) {
  HtmlTable table{is_given ? "What the case gives" : "What it leaves at the default",
                  {"parameter", "value"},
                  {}};
  for (const CaseInput& input : inputs)
    if (input.is_given == is_given && !input.value.empty() && !input.is_published)
      table.rows.push_back({escaped(input.name), escaped(shown_value(input))});
  return table.rows.empty() ? "" : "<div class=\"list\">\n" + table.html() + "</div>\n";
}

}  // namespace

std::string shown_value(const CaseInput& input) {
  const std::string last = input.name.substr(input.name.rfind('/') + 1);
  const std::set<std::string> texts{"Title", "Project", "Author", "Source", "Material"};
  return texts.count(last) > 0 ? input.value : shown_input(input.value);
}

std::vector<CaseInput> inputs_of(const ResultsDirectory& results) {
  std::vector<CaseInput> inputs = case_inputs(results.case_text());
  const nlohmann::json& worked_out = results.about().at("worked_out");
  for (CaseInput& input : inputs)
    if (const auto found = worked_out.find(input.name);
        found != worked_out.end() && input.value == "default")
      input.value = found->get<std::string>();
  return inputs;
}

std::string inputs_section(const ResultsDirectory& results, const std::string& remark) {
  const std::vector<CaseInput> inputs = inputs_of(results);
  if (inputs.empty()) return "";
  return html_section(
      "inputs", "Inputs",
      (remark.empty() ? "" : "<p>" + escaped(remark) + "</p>\n") + materials_table(inputs) +
          table_of_inputs(inputs, true) +
          fmt::format("<details>\n<summary>Everything else: defaults, and values of named "
                      "materials</summary>\n{}</details>\n"
                      "<details>\n<summary>What the case gives, as case.prm has it</summary>\n"
                      "<pre class=\"case-file\">{}</pre>\n</details>\n",
                      table_of_inputs(inputs, false), escaped(given_lines(results.case_text()))));
}

}  // namespace geneva::post
