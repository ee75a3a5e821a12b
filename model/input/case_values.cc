#include "model/input/case_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/errors.h"
#include "model/input/nearest_word.h"
#include "model/input/parameter_listing.h"

namespace geneva::model {

namespace {

/// "Wheel material/Density": without the model's section, which goes without saying.
std::string shown_name(const SectionPath& section, const std::string& name) {
  std::string shown;
  for (std::size_t i = 1; i < section.size(); ++i) shown += section[i] + "/";
  return "'" + shown + name + "'";
}

std::string wanted_text(const Rule& rule) {
  std::string text = allowed(rule);
  text.pop_back();
  text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  if (const auto* quantity = std::get_if<QuantityRule>(&rule))
    if (!quantity->whole) text += "; for example " + base::example_of(quantity->dimension);
  return text;
}

std::vector<std::string> sections_in(const std::vector<Parameter>& parameters,
                                     const SectionPath& path) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters) {
    const SectionPath& section = parameter.section;
    if (section.size() <= path.size() || !std::equal(path.begin(), path.end(), section.begin()))
      continue;
    const std::string& name = section[path.size()];
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

[[noreturn]] void refuse_unknown_section(const std::vector<Parameter>& parameters,
                                         const ParameterText& text, const OpenedSection& opened) {
  const SectionPath parent(opened.path.begin(), opened.path.end() - 1);
  const std::string& name = opened.path.back();
  const std::vector<std::string> known = sections_in(parameters, parent);
  std::string reason = fmt::format("there is no subsection {}{}", base::in_quotes(name),
                                   parent.empty() ? "" : " in " + base::in_quotes(parent.back()));
  for (const Parameter& parameter : parameters)
    if (parameter.section.size() == 2 && parent.empty() && parameter.section.back() == name)
      refuse(text, opened.line,
             fmt::format("the subsection {} belongs into the subsection {}", base::in_quotes(name),
                         base::in_quotes(parameter.section.front())));
  if (const auto nearest = nearest_word(name, known))
    reason += "; did you mean " + base::in_quotes(*nearest) + "?";
  else if (!known.empty())
    reason += "; there are " + listed(known);
  refuse(text, opened.line, reason);
}

std::string section_phrase(const SectionPath& section) {
  return section.empty() ? "outside of all subsections"
                         : "in the subsection " + base::in_quotes(section.back());
}

/// Of a subsection that can name a material.
/// @param within the subsection that it is in
std::string material_hint(const std::vector<Parameter>& parameters, const SectionPath& within,
                          const Assignment& found) {
  SectionPath section = within;
  section.push_back(found.name);
  const bool has_material =
      std::any_of(parameters.begin(), parameters.end(), [&](const Parameter& parameter) {
        return parameter.section == section && parameter.name == names::material;
      });
  return has_material ? fmt::format(" such as 'set Material = {}'", found.value) : "";
}

/// Of a subsection that stands in place of a parameter.
std::string way_to_write(const std::vector<Parameter>& parameters, const SectionPath& within,
                         const Assignment& found) {
  return fmt::format("write 'subsection {}', below it 'set NAME = VALUE' lines{}, and 'end'",
                     found.name, material_hint(parameters, within, found));
}

/// The subsection that has one of this name; nothing if none has.
std::optional<SectionPath> section_with(const std::vector<Parameter>& parameters,
                                        const std::string& name) {
  for (const Parameter& parameter : parameters) {
    const auto& path = parameter.section;
    if (const auto at = std::find(path.begin(), path.end(), name); at != path.end())
      return SectionPath(path.begin(), at);
  }
  return std::nullopt;
}

[[noreturn]] void refuse_unknown_name(const std::vector<Parameter>& parameters,
                                      const ParameterText& text, const Assignment& found) {
  std::string reason = fmt::format("there is no parameter {} {}", base::in_quotes(found.name),
                                   section_phrase(found.section));
  std::vector<std::string> here;
  for (const Parameter& parameter : parameters)
    if (parameter.section == found.section) here.push_back(parameter.name);
  if (const auto nearest = nearest_word(found.name, here))
    refuse(text, found.line, reason + "; did you mean " + base::in_quotes(*nearest) + "?");
  const std::vector<std::string> sections = sections_in(parameters, found.section);
  if (std::find(sections.begin(), sections.end(), found.name) != sections.end())
    refuse(text, found.line,
           fmt::format("{} is a subsection: {}", base::in_quotes(found.name),
                       way_to_write(parameters, found.section, found)));
  for (const Parameter& parameter : parameters)
    if (parameter.name == found.name)
      refuse(text, found.line, reason + ": it belongs " + section_phrase(parameter.section));
  if (const auto within = section_with(parameters, found.name); within && !within->empty())
    refuse(text, found.line,
           fmt::format("{} is a subsection of {}: there {}", base::in_quotes(found.name),
                       base::in_quotes(within->back()), way_to_write(parameters, *within, found)));
  refuse(text, found.line, reason + (here.empty() ? "" : "; there are " + listed(here)));
}

using ParameterKey = std::pair<SectionPath, std::string>;

void check_names(const std::vector<Parameter>& parameters, const ParameterText& text) {
  std::set<SectionPath> sections;
  std::map<ParameterKey, const Parameter*> known;
  for (const Parameter& parameter : parameters) {
    known.emplace(ParameterKey{parameter.section, parameter.name}, &parameter);
    for (SectionPath path = parameter.section; !path.empty(); path.pop_back())
      sections.insert(path);
  }
  for (const OpenedSection& opened : text.sections)
    if (sections.count(opened.path) == 0) refuse_unknown_section(parameters, text, opened);
  for (const Assignment& found : text.assignments) {
    const auto parameter = known.find({found.section, found.name});
    if (parameter == known.end()) refuse_unknown_name(parameters, text, found);
    if (parameter->second->required && found.value.empty()) continue;
    if (const auto reason = refusal(parameter->second->rule, found.value))
      refuse(text, found.line,
             fmt::format("{} = {}", shown_name(found.section, found.name), *reason));
  }
}

}  // namespace

void refuse(const ParameterText& text, const int line, const std::string& reason) {
  const std::string place = line > 0                 ? fmt::format(", line {}", line)
                            : text.varied_by.empty() ? ""
                                                     : " and " + text.varied_by;
  throw base::InputError(fmt::format("{}{}: {}", text.file, place, reason));
}

void refuse(const ParameterText& text, const Assignment& found, const std::string& reason) {
  refuse(text, found.line,
         fmt::format("{} = {}: {}", shown_name(found.section, found.name),
                     base::in_quotes(found.value), reason));
}

CaseValues::CaseValues(const std::vector<Parameter>& parameters, const ParameterText& text)
    : parameters_(parameters), text_(text) {
  check_names(parameters, text);
  for (const Parameter& parameter : parameters)
    values_[{parameter.section, parameter.name}] = parameter.default_value;
  for (const Assignment& found : text.assignments)
    values_[{found.section, found.name}] = found.value;
  for (const Parameter& parameter : parameters)
    if (parameter.required && this->text(parameter.section, parameter.name).empty())
      refuse_missing(parameter.section, parameter.name, "it takes " + wanted_text(parameter.rule));
}

const std::string& CaseValues::text(const SectionPath& section, const std::string& name) const {
  const auto found = values_.find({section, name});
  if (found == values_.end()) throw std::logic_error("parameter '" + name + "' is not declared");
  return found->second;
}

const Parameter& CaseValues::parameter(const SectionPath& section, const std::string& name) const {
  const auto found =
      std::find_if(parameters_.begin(), parameters_.end(), [&](const Parameter& parameter) {
        return parameter.section == section && parameter.name == name;
      });
  if (found == parameters_.end())
    throw std::logic_error("parameter '" + name + "' is not declared");
  return *found;
}

std::vector<double> CaseValues::values(const SectionPath& section, const std::string& name) const {
  const auto& rule = std::get<QuantityRule>(parameter(section, name).rule);
  const std::string found = text(section, name);
  return is_word(rule, found) ? std::vector<double>{} : model::values(rule, found);
}

std::optional<double> CaseValues::value(const SectionPath& section, const std::string& name) const {
  const std::vector<double> all = values(section, name);
  return all.empty() ? std::nullopt : std::optional<double>(all.front());
}

std::vector<std::string> CaseValues::names(const SectionPath& section,
                                           const std::string& begin) const {
  std::vector<std::string> found;
  for (const Parameter& parameter : parameters_)
    if (parameter.section == section && parameter.name.compare(0, begin.size(), begin) == 0)
      found.push_back(parameter.name);
  return found;
}

bool CaseValues::is_changed(const SectionPath& section, const std::string& name) const {
  return text(section, name) != parameter(section, name).default_value;
}

void CaseValues::refuse(const SectionPath& section, const std::string& name,
                        const std::string& reason) const {
  if (const Assignment* found = text_.find(section, name)) model::refuse(text_, *found, reason);
  throw base::InputError(fmt::format("{}: {} = {} (default): {}", text_.file,
                                     shown_name(section, name),
                                     base::in_quotes(text(section, name)), reason));
}

void CaseValues::refuse_missing(const SectionPath& section, const std::string& name,
                                const std::string& reason) const {
  throw base::InputError(fmt::format("{}: {} is missing {}: {}", text_.file, base::in_quotes(name),
                                     section_phrase(section), reason));
}

void CaseValues::refuse_section(const SectionPath& section, const std::string& reason) const {
  throw base::InputError(
      fmt::format("{}: subsection {}: {}", text_.file, base::in_quotes(section.back()), reason));
}

std::string CaseValues::completed() const {
  return parameter_listing(
      parameters_,
      [this](const Parameter& parameter) { return text(parameter.section, parameter.name); },
      [this](const Parameter& parameter) {
        const Assignment* const found = text_.find(parameter.section, parameter.name);
        return found != nullptr && !found->value.empty() && !found->is_filled_in;
      });
}

CaseSection::CaseSection(const CaseValues& values, SectionPath path)
    : values_(&values), path_(std::move(path)) {}

std::string CaseSection::text(const std::string& name) const { return values_->text(path_, name); }

bool CaseSection::is_changed(const std::string& name) const {
  return values_->is_changed(path_, name);
}

bool CaseSection::is_given(const std::string& name) const { return !text(name).empty(); }

double CaseSection::value(const std::string& name) const {
  if (const auto found = optional_value(name)) return *found;
  refuse_missing(name, "a value is wanted");
}

std::optional<double> CaseSection::optional_value(const std::string& name) const {
  return values_->value(path_, name);
}

std::vector<double> CaseSection::values(const std::string& name) const {
  return values_->values(path_, name);
}

void CaseSection::refuse(const std::string& name, const std::string& reason) const {
  values_->refuse(path_, name, reason);
}

void CaseSection::refuse_missing(const std::string& name, const std::string& reason) const {
  values_->refuse_missing(path_, name, reason);
}

void CaseSection::refuse(const std::string& reason) const {
  values_->refuse_section(path_, reason);
}

}  // namespace geneva::model
