#include "api/output_directory.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "api/report.h"
#include "base/directory.h"
#include "base/errors.h"
#include "base/json_values.h"
#include "base/output_file.h"
#include "post/output/result_files.h"

namespace geneva::api {

namespace fs = std::filesystem;

namespace {

/// Whether a document in a directory is of a case, and in this program's format.
bool is_of_case(const fs::path& directory, const std::string& document, const model::Case& given) {
  using nlohmann::json;
  std::ifstream stream(directory / (document + ".json"));
  const json found = json::parse(stream, nullptr, false);
  if (!found.is_object()) return false;
  const json about = found.value("case", json::object());
  const json versions = found.value("versions", json::object());
  return about.is_object() && versions.is_object() &&
         about.value("content", json()) == given.content &&
         about.value("output_units", json()) == base::name_of(given.units) &&
         versions.value("results", json()) == base::results_format;
}

/// Whether a file is one that the case reads: its directory may hold the results.
bool is_input(const fs::path& file, const model::Case& given) {
  std::error_code ignored;
  return std::any_of(given.inputs.begin(), given.inputs.end(),
                     [&](const fs::path& input) { return fs::equivalent(file, input, ignored); });
}

/// Own files of a directory that do not stay beside a new document.
struct Stale {
  std::set<std::string> names;
  std::vector<std::string> of_others;  ///< those that belonged to other documents
};

Stale stale_files(const fs::path& directory, const model::Case& given, const std::string& document,
                  const std::set<std::string>& written) {
  Stale stale;
  if (!fs::is_directory(directory)) return stale;
  // A case.prm alone is a user's, not the copy that a run makes.
  const bool has_run = document == "summary" || fs::exists(directory / "summary.json");
  std::set<std::string> kept;
  for (const post::ResultFiles& results : post::result_files())
    if (results.document != document && is_of_case(directory, results.document, given))
      kept.insert(results.document);
  for (const fs::path& file : base::entries_of(directory)) {
    const std::string name = file.filename().string();
    if (written.count(name) > 0 || is_input(file, given) || (name == "case.prm" && !has_run))
      continue;
    if (post::is_shared_file(name)) stale.names.insert(name);
    for (const post::ResultFiles& results : post::result_files()) {
      if (!post::belongs_to(results, name) || kept.count(results.document) > 0) continue;
      stale.names.insert(name);
      if (results.document != document) stale.of_others.push_back(name);
    }
  }
  return stale;
}

/// Nothing else than a file may have the name of one that is going to be written.
void check_names(const fs::path& directory, const std::string& document) {
  std::error_code error;
  if (!fs::is_directory(directory, error)) return;
  for (const fs::path& entry : base::entries_of(directory))
    for (const post::ResultFiles& results : post::result_files())
      if (const std::string name = entry.filename().string();
          !fs::is_regular_file(entry, error) &&
          (post::is_shared_file(name) ||
           (results.document == document && post::belongs_to(results, name))))
        throw base::InputError(
            fmt::format("{} is to be written, but it is not a file; move it away, or give another "
                        "directory with --output",
                        entry.string()));
}

void check_own_case(const fs::path& directory) {
  if (fs::exists(directory / "case.prm") && !fs::exists(directory / "summary.json"))
    throw base::InputError(
        fmt::format("results directory {} holds a case of its own, whose case.prm would be "
                    "overwritten; give another one with --output",
                    directory.string()));
}

}  // namespace

Written write_results(const fs::path& directory, const model::Case& given,
                      const std::string& document,
                      const std::map<std::string, std::string>& texts) {
  OutputDirectory output(directory, given, document, true);
  for (const auto& [name, text] : texts)
    base::write_text(post::own_file(output.working(), name), text);
  return output.publish();
}

OutputDirectory::OutputDirectory(const fs::path& final, const model::Case& given,
                                 std::string document, const bool is_owner)
    : given_(given), document_(std::move(document)), working_(base::working_directory_of(final)) {
  if (!is_owner) return;
  base::check_replaceable(final);
  check_names(final, document_);
  if (document_ == "summary") check_own_case(final);
  replacement_.emplace(final);
}

void OutputDirectory::check_space(const double size) const {
  if (!replacement_) return;
  std::error_code error;
  const fs::space_info space = fs::space(working_, error);
  if (error || static_cast<double>(space.available) >= size) return;
  throw base::InputError(fmt::format(
      "results directory {}: the results need about {:.3g} MB, and the disk has {:.3g} MB; make "
      "room, or give another one with --output",
      replacement_->final().string(), 1e-6 * size, 1e-6 * static_cast<double>(space.available)));
}

Written OutputDirectory::publish() {
  if (!replacement_) return {};
  std::set<std::string> written;
  for (const fs::path& entry : base::entries_of(working_))
    written.insert(entry.filename().string());
  const Stale stale = stale_files(replacement_->final(), given_, document_, written);
  replacement_->keep([&](const std::string& name) { return stale.names.count(name) == 0; });
  Written done;
  if (!given_.synthesis) done = write_report(working_);
  replacement_->commit();
  done.removed = stale.of_others;
  return done;
}

}  // namespace geneva::api
