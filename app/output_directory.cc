#include "app/output_directory.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "post/json_values.h"
#include "post/output_file.h"
#include "post/result_files.h"

namespace geneva::app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_unwritable(const fs::path& directory, const std::error_code& error) {
  throw std::invalid_argument(
      fmt::format("results directory {} cannot be written{}; give another one with --output",
                  directory.string(), error ? " (" + error.message() + ")" : ""));
}

[[noreturn]] void refuse_blocked(const fs::path& directory) {
  throw std::invalid_argument(
      fmt::format("results directory {}: a file of that name is in the way", directory.string()));
}

fs::path working_name(const fs::path& final) {
  return final.parent_path() / fmt::format(".{}.partial", final.filename().string());
}

/// Whether a document in a directory is of a case, and in this program's format.
bool is_of_case(const fs::path& directory, const std::string& document, const Case& given) {
  using nlohmann::json;
  std::ifstream stream(directory / (document + ".json"));
  const json found = json::parse(stream, nullptr, false);
  if (!found.is_object()) return false;
  const json about = found.value("case", json::object());
  const json versions = found.value("versions", json::object());
  return about.is_object() && versions.is_object() &&
         about.value("content", json()) == given.content &&
         about.value("output_units", json()) == post::name_of(given.units) &&
         versions.value("results", json()) == post::results_format;
}

/// Whether a file is one that the case reads: its directory may hold the results.
bool is_input(const fs::path& file, const Case& given) {
  std::error_code ignored;
  return std::any_of(given.inputs.begin(), given.inputs.end(),
                     [&](const fs::path& input) { return fs::equivalent(file, input, ignored); });
}

/// Removes the program's own files that are not of what was written.
std::vector<std::string> remove_stale(const fs::path& directory, const Case& given,
                                      const std::string& document,
                                      const std::set<std::string>& written) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  // A case.prm alone is a user's, not the copy that a run makes.
  const bool has_run = fs::exists(directory / "summary.json");
  std::set<std::string> kept;
  for (const post::ResultFiles& results : post::result_files())
    if (results.document != document && is_of_case(directory, results.document, given))
      kept.insert(results.document);
  std::vector<std::string> removed;
  for (const fs::path& file : files) {
    const std::string name = file.filename().string();
    if (written.count(name) > 0 || is_input(file, given) || (name == "case.prm" && !has_run))
      continue;
    if (post::is_shared_file(name)) fs::remove(file);
    for (const post::ResultFiles& results : post::result_files()) {
      if (!post::belongs_to(results, name) || kept.count(results.document) > 0) continue;
      fs::remove(file);
      if (results.document != document) removed.push_back(name);
    }
  }
  return removed;
}

}  // namespace

std::string shown_path(const fs::path& path) {
  const fs::path relative = path.lexically_proximate(fs::current_path());
  return relative.empty() || *relative.begin() == ".." ? path.string() : relative.string();
}

void check_writable(const fs::path& directory) {
  const fs::path wanted = (fs::absolute(directory) / "").lexically_normal().parent_path();
  std::error_code error;
  if (fs::exists(wanted, error) && !fs::is_directory(wanted, error)) refuse_blocked(directory);
  fs::path existing = wanted;
  while (!fs::exists(existing, error)) existing = existing.parent_path();
  if (!fs::is_directory(existing, error))
    refuse_unwritable(directory, std::make_error_code(std::errc::not_a_directory));
  if (access(existing.c_str(), W_OK | X_OK) != 0)
    refuse_unwritable(directory, {errno, std::generic_category()});
}

void write_and_rename(const fs::path& file, const std::string& text) {
  const fs::path directory = file.parent_path();
  check_writable(directory);
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) refuse_unwritable(directory, error);
  const fs::path partial = directory / fmt::format(".{}.partial", file.filename().string());
  try {
    std::ofstream stream = post::open_output(partial);
    stream << text;
    post::close_output(stream, partial);
    fs::rename(partial, file);
  } catch (const std::exception&) {
    fs::remove(partial, error);
    throw;
  }
}

std::vector<std::string> write_results(const fs::path& directory, const Case& given,
                                       const std::string& document,
                                       const std::map<std::string, std::string>& texts) {
  std::set<std::string> written;
  for (const auto& [name, text] : texts) {
    write_and_rename(post::own_file(directory, name), text);
    written.insert(name);
  }
  return remove_stale(directory, given, document, written);
}

std::string removal_notice(const std::vector<std::string>& removed) {
  if (removed.empty()) return "";
  return fmt::format("removed results of another case, or of this one before it was changed: {}",
                     fmt::join(removed, ", "));
}

OutputDirectory::OutputDirectory(const fs::path& final, const bool is_owner)
    : final_(fs::absolute(final).lexically_normal()), is_owner_(is_owner) {
  if (final_.filename().empty()) final_ = final_.parent_path();
  working_ = working_name(final_);
  if (!is_owner_) return;
  std::error_code error;
  const bool is_blocked = fs::exists(final_, error) && !fs::is_directory(final_, error);
  if (is_blocked) refuse_blocked(final_);
  if (fs::exists(final_ / "case.prm", error) && !fs::exists(final_ / "summary.json", error))
    throw std::invalid_argument(
        fmt::format("results directory {} holds a case of its own, whose case.prm would be "
                    "overwritten; give another "
                    "one with --output",
                    final_.string()));
  const bool is_existing = fs::is_directory(final_, error);
  fs::remove_all(working_, error);
  for (fs::path parent = final_.parent_path(); !parent.empty() && !fs::exists(parent);
       parent = parent.parent_path())
    made_.push_back(parent);
  fs::create_directories(working_, error);
  if (error || (is_existing && access(final_.c_str(), W_OK | X_OK) != 0))
    refuse_unwritable(final_, error);
}

OutputDirectory::~OutputDirectory() {
  std::error_code ignored;
  if (!is_owner_) return;
  fs::remove_all(working_, ignored);
  for (const fs::path& parent : made_) fs::remove(parent, ignored);  // those still empty
}

std::vector<std::string> OutputDirectory::publish(const Case& given) {
  if (!is_owner_) return {};
  fs::create_directories(final_);
  std::set<std::string> written;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(working_)) files.push_back(entry.path());
  for (const fs::path& file : files) {
    fs::rename(file, final_ / file.filename());
    written.insert(file.filename().string());
  }
  return remove_stale(final_, given, "summary", written);
}

}  // namespace geneva::app
