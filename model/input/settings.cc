#include "model/input/settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "model/input/case_values.h"
#include "model/input/parameters.h"

namespace geneva::model {

namespace {

bool is_same(const Assignment& assignment, const Setting& setting) {
  return assignment.section == setting.section && assignment.name == setting.name;
}

void check_each_once(const ParameterText& text, const std::vector<Setting>& settings) {
  for (auto one = settings.begin(); one != settings.end(); ++one)
    for (auto other = settings.begin(); other != one; ++other)
      if (one->section == other->section && one->name == other->name)
        refuse(text, 0, fmt::format("{} is set twice", base::in_quotes(one->name)));
}

/// Refuses what would be read as something else when it is written to a file.
void check_lines(const ParameterText& text, const Assignment& set) {
  const ParameterText read =
      parameter_text(text.file, fmt::format("set {} = {}\n", set.name, set.value));
  const bool is_read_again = read.assignments.size() == 1 && read.sections.empty() &&
                             read.assignments.front().name == set.name &&
                             read.assignments.front().value == set.value;
  if (!is_read_again)
    refuse(text, set, "a value is one line without '#', behind which a comment stands");
}

base::UnitSystem units_of(const ParameterText& text) {
  const Assignment* const units = text.find({}, "Output units");
  return base::unit_system_named(units == nullptr ? name_of(base::UnitSystem::si) : units->value);
}

void set_value(ParameterText& text, const Setting& setting, std::string value) {
  const Assignment changed{setting.section, setting.name, std::move(value), 0};
  check_lines(text, changed);
  const auto found =
      std::find_if(text.assignments.begin(), text.assignments.end(),
                   [&](const Assignment& assignment) { return is_same(assignment, setting); });
  if (found == text.assignments.end())
    text.assignments.push_back(changed);
  else
    *found = changed;
}

void open_section(ParameterText& text, const SectionPath& section) {
  const bool is_open =
      std::any_of(text.sections.begin(), text.sections.end(),
                  [&](const OpenedSection& opened) { return opened.path == section; });
  if (!section.empty() && !is_open) text.sections.push_back({section, 0});
}

}  // namespace

std::string text_of(const Setting& setting, const ParameterText& text,
                    const std::filesystem::path& directory) {
  if (const auto* const value = std::get_if<std::string>(&setting.value)) return trimmed(*value);
  // Without a unit where there is no such parameter, which the reader refuses by its name.
  std::string unit;
  for (const Parameter& parameter : parameters_of(text, directory))
    if (parameter.section == setting.section && parameter.name == setting.name)
      if (const auto* const rule = std::get_if<QuantityRule>(&parameter.rule))
        unit = base::output_unit(units_of(text), rule->dimension).name;
  std::string joined;
  for (const double number : std::get<std::vector<double>>(setting.value))
    joined +=
        fmt::format("{}{}{}{}", joined.empty() ? "" : ", ", number, unit.empty() ? "" : " ", unit);
  return joined;
}

Case case_with(ParameterText text, const std::vector<Setting>& settings,
               const std::filesystem::path& directory) {
  check_each_once(text, settings);
  // The texts first, which say model and units.
  for (const bool is_text : {true, false})
    for (const Setting& setting : settings) {
      if (std::holds_alternative<std::string>(setting.value) != is_text) continue;
      open_section(text, setting.section);
      set_value(text, setting, text_of(setting, text, directory));
    }
  return case_of(text, directory);
}

}  // namespace geneva::model
