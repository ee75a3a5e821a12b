#include "model/input/parameter_listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace geneva::model {

namespace {

constexpr std::size_t line_width = 78;

/// Words filled into lines of at most so many characters.
std::vector<std::string> lines_of(const std::string& text, const std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;)
    if (!lines.empty() && lines.back().size() + 1 + word.size() <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  return lines;
}

/// A parameter as it is listed.
struct Entry {
  const Parameter* parameter;
  std::string value;
  bool is_given;
};

/// A subsection, or the whole file.
struct Section {
  std::string name;
  std::vector<Entry> entries;
  std::vector<Section> sections;
};

Section& section_at(Section& root, const SectionPath& path) {
  Section* section = &root;
  for (const std::string& name : path) {
    auto& inner = section->sections;
    const auto found = std::find_if(inner.begin(), inner.end(),
                                    [&](const Section& other) { return other.name == name; });
    section = found != inner.end() ? &*found : &inner.emplace_back(Section{name, {}, {}});
  }
  return *section;
}

std::string explanation_of(const Parameter& parameter) {
  return (parameter.required ? "Required. " : "") + parameter.help + " [" +
         allowed(parameter.rule) + "]";
}

std::string listed_entries(const std::vector<Entry>& entries, const std::string& indent) {
  std::size_t name_width = 0;
  std::size_t value_width = 0;
  for (const Entry& entry : entries) {
    name_width = std::max(name_width, entry.parameter->name.size());
    value_width = std::max(value_width, entry.value.size());
  }
  std::string text;
  for (const Entry& entry : entries) {
    const Parameter& parameter = *entry.parameter;
    if (!text.empty()) text += '\n';
    for (const std::string& line :
         lines_of(explanation_of(parameter), line_width - indent.size() - 2))
      text += fmt::format("{}# {}\n", indent, line);
    text += fmt::format("{}set {:{}} = {}", indent, parameter.name, name_width, entry.value);
    if (entry.is_given || entry.value != parameter.default_value)
      text += fmt::format("{:{}} # default: {}", "", value_width - entry.value.size(),
                          parameter.default_value);
    text += '\n';
  }
  return text;
}

std::string listed_section(const Section& section, const std::size_t depth) {
  const std::string indent(2 * depth, ' ');
  std::string text = listed_entries(section.entries, indent);
  if (!section.entries.empty() && !section.sections.empty()) text += "\n\n";
  for (const Section& inner : section.sections)
    text += fmt::format("{0}subsection {1}\n{2}{0}end\n{3}", indent, inner.name,
                        listed_section(inner, depth + 1), depth == 0 ? "\n\n" : "\n");
  return text;
}

}  // namespace

std::string parameter_listing(const std::vector<Parameter>& parameters,
                              const std::function<std::string(const Parameter&)>& value_of,
                              const std::function<bool(const Parameter&)>& is_given) {
  Section root;
  for (const Parameter& parameter : parameters)
    section_at(root, parameter.section)
        .entries.push_back({&parameter, value_of(parameter), is_given(parameter)});
  return "# Listing of Parameters\n# ---------------------\n" + listed_section(root, 0);
}

}  // namespace geneva::model
