#include "post/report/page_head.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "post/report/html/html.h"

namespace geneva::post {

using nlohmann::json;

namespace {

std::string title_entry(const std::string& name, const std::string& content) {
  return fmt::format("<li><span>{}</span> {}</li>\n", name, content);
}

std::string versions_of(const json& document) {
  std::string versions;
  for (const char* const library : {"geneva", "deal.II", "gmsh"})
    if (document.at("versions").contains(library))
      versions += fmt::format("{}{} {}", versions.empty() ? "" : ", ", library,
                              document.at("versions").at(library).get<std::string>());
  return versions;
}

std::string time_element(const std::string& date) {
  return fmt::format("<time datetime=\"{}\">{} {}</time>", date, date.substr(0, 10),
                     date.substr(11, 5));
}

std::string header_element(const std::string& title, const std::string& block) {
  return fmt::format("<header>\n<h1>{}</h1>\n<ul class=\"title-block\">\n{}</ul>\n</header>\n",
                     escaped(title), block);
}

/// What the runs say under a key, each once.
std::string joined(const std::vector<ResultsDirectory>& all,
                   const std::function<std::string(const ResultsDirectory&)>& text_of) {
  std::vector<std::string> texts;
  for (const ResultsDirectory& results : all)
    if (const std::string text = text_of(results);
        !text.empty() && std::find(texts.begin(), texts.end(), text) == texts.end())
      texts.push_back(text);
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

std::string page_title(const ResultsDirectory& results) {
  const std::string title = results.about().at("title");
  const std::string name = results.about().at("name");
  return title.empty() ? name : fmt::format("{}: {}", name, title);
}

std::string comparison_head(const std::vector<ResultsDirectory>& all) {
  const auto about = [](const char* const key) {
    return [key](const ResultsDirectory& results) {
      return escaped(results.about().value(key, std::string()));
    };
  };
  std::string block = title_entry("Cases", joined(all, about("name")));
  for (const auto& [key, name] : {std::pair("project", "Project"), std::pair("author", "Author")})
    if (const std::string value = joined(all, about(key)); !value.empty())
      block += title_entry(name, value);
  block += title_entry("Runs of", joined(all,
                                         [](const ResultsDirectory& results) {
                                           return time_element(results.about().at("date"));
                                         })) +
           title_entry("Units", name_of(all.front().units())) +
           title_entry("Versions", joined(all, [](const ResultsDirectory& results) {
                         return escaped(versions_of(results.leading()));
                       }));
  return header_element(fmt::format("Comparison of {} runs", all.size()), block);
}

std::string page_head(const ResultsDirectory& results) {
  const json& document = results.leading();
  const json& about = results.about();
  std::string block = title_entry("Case", escaped(about.at("name")));
  for (const auto& [key, name] : {std::pair("project", "Project"), std::pair("author", "Author")})
    if (const std::string value = about.value(key, ""); !value.empty())
      block += title_entry(name, escaped(value));
  block += title_entry("Date", time_element(about.at("date"))) +
           title_entry("Units", escaped(about.at("output_units"))) +
           title_entry("Versions", escaped(versions_of(document)));
  return header_element(page_title(results), block);
}

}  // namespace geneva::post
