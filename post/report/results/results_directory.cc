#include "post/report/results/results_directory.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <vector>

#include "base/errors.h"
#include "base/json_values.h"
#include "post/output/result_files.h"

namespace geneva::post {

using base::results_format;
using base::unit_system_named;
using base::UnitSystem;

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json read_json(const fs::path& file) {
  std::ifstream stream(file);
  json document = json::parse(stream, nullptr, false);
  if (document.is_discarded() || !document.is_object())
    throw base::InputError(file.string() + " is no JSON document: it is damaged; make it again");
  return document;
}

void check_format(const json& document, const fs::path& file, const std::string& command) {
  const json& versions = document.value("versions", json::object());
  const int format = versions.value("results", 0);
  if (format == results_format) return;
  throw base::InputError(fmt::format(
      "{} has results of format {}, written by geneva {}; this program reads format {}: "
      "make them again with '{}'",
      file.string(), format == 0 ? "0 (none is named)" : std::to_string(format),
      versions.value("geneva", std::string("of unknown version")), results_format, command));
}

}  // namespace

const json* ResultsDirectory::document(const std::string& name) const {
  const auto found = documents.find(name);
  return found == documents.end() ? nullptr : &found->second;
}

const CsvTable* ResultsDirectory::table(const std::string& name) const {
  const auto found = tables.find(name);
  return found == tables.end() ? nullptr : &found->second;
}

const json& ResultsDirectory::leading() const {
  for (const ResultFiles& files : result_files())
    if (const json* found = document(files.document)) return *found;
  throw std::logic_error("a results directory without results");
}

const json& ResultsDirectory::about() const { return leading().at("case"); }

std::string ResultsDirectory::case_text() const { return about().at("inputs"); }

UnitSystem ResultsDirectory::units() const {
  return unit_system_named(about().at("output_units").get<std::string>());
}

ResultsDirectory read_results(const fs::path& directory) try {
  if (!fs::is_directory(directory))
    throw base::InputError(
        fmt::format("{}: there is no such directory; give one with results", directory.string()));
  ResultsDirectory results{directory, {}, {}};
  for (const ResultFiles& files : result_files()) {
    const fs::path file = directory / (std::string(files.document) + ".json");
    if (!files.is_reported || !fs::exists(file)) continue;
    json document = read_json(file);
    check_format(document, file, files.command);
    std::vector<const char*> tables = files.tables;
    if (std::string(files.document) == "summary") {
      if (document.contains("contact"))
        tables.push_back(document.at("case").at("dimension") == 3 ? "sections" : "depth");
      else
        tables.clear();
    }
    for (const char* const table : tables) {
      const fs::path csv = directory / (std::string(table) + ".csv");
      if (!fs::exists(csv))
        throw base::InputError(
            fmt::format("{} is missing, which belongs to {}: the results are not complete; make "
                        "them again with '{}'",
                        csv.string(), file.filename().string(), files.command));
      results.tables[table] = read_csv(csv);
    }
    results.documents[files.document] = std::move(document);
  }
  if (results.documents.empty())
    throw base::InputError(fmt::format(
        "{} holds no results: there is none of summary.json ('geneva run'), "
        "estimate.json ('geneva estimate'), kinematics.json ('geneva kinematics'), "
        "design.json ('geneva design'), crown.json ('geneva design --crown'), "
        "optimum.json ('geneva optimise'), cycle.json and load_steps.json ('geneva cycle') "
        "and sweep.json ('geneva sweep')",
        directory.string()));
  for (const char* const name :
       {"view", "mechanism", "cycle_view", "load_steps_view"}) {  // not of all of them
    const fs::path file = directory / (std::string(name) + ".json");
    if (fs::exists(file)) results.documents[name] = read_json(file);
  }
  return results;
} catch (const json::exception& error) {
  refuse_incomplete("the results in " + directory.string(), error.what());
}

void refuse_incomplete(const std::string& what, const std::string& complaint) {
  const std::size_t begin = complaint.find("key '");
  const std::size_t end = complaint.rfind('\'');
  const std::string lacking =
      begin == std::string::npos
          ? "do not hold what a report needs"
          : "lack '" + complaint.substr(begin + 5, end - begin - 5) + "', which a report needs";
  throw base::InputError(fmt::format(
      "{} {}: they are damaged, or an earlier geneva wrote them; make them again", what, lacking));
}

}  // namespace geneva::post
