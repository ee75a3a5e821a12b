#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/units.h"
#include "post/report/results/csv_table.h"

namespace geneva::post {

/// What the commands left in a results directory; SI units in JSON, output units in tables.
struct ResultsDirectory {
  std::filesystem::path path;
  std::map<std::string, nlohmann::json> documents;  ///< "summary", "view", ... that exist
  std::map<std::string, CsvTable> tables;           ///< "contact", "sections", ... that exist

  [[nodiscard]] const nlohmann::json* document(const std::string& name) const;
  [[nodiscard]] const CsvTable* table(const std::string& name) const;
  /// That of the run, else of the estimate, else of the kinematics, else of the design, else of the
  /// crown.
  [[nodiscard]] const nlohmann::json& leading() const;
  /// Its section "case".
  [[nodiscard]] const nlohmann::json& about() const;
  /// The case file with every default filled in.
  [[nodiscard]] std::string case_text() const;
  [[nodiscard]] base::UnitSystem units() const;
};

/// Reads the results of `geneva run`, `geneva kinematics`, `geneva design` and `geneva design
/// --crown` that a directory holds.
/// @throws base::InputError if it holds none, if a file that belongs to another one is missing
/// or damaged, or if one was written in another format than this program's
ResultsDirectory read_results(const std::filesystem::path& directory);

/// Refuses results that lack something.
/// @param what results, at the beginning of a sentence's plural
/// @param complaint of the reader, with the name between quotes where it knows it
/// @throws base::InputError always
[[noreturn]] void refuse_incomplete(const std::string& what, const std::string& complaint);

}  // namespace geneva::post
