#include "app/output_directory.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "post/output_file.h"

namespace geneva::app {

namespace fs = std::filesystem;

namespace {

/// Files that this program writes; a later run may remove them.
bool is_result_file(const fs::path& file) {
  static const std::set<std::string> names{"solution.pvd", "solution.pvtu", "contact.vtu",
                                           "contact.csv",  "sections.csv",  "depth.csv",
                                           "results.h5",   "results.xdmf",  "summary.json",
                                           "case.prm",     "log.txt",       "report.html"};
  const std::string name = file.filename().string();
  return names.count(name) > 0 || (name.rfind("solution.", 0) == 0 && file.extension() == ".vtu");
}

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

void OutputDirectory::publish() {
  if (!is_owner_) return;
  fs::create_directories(final_);
  std::set<std::string> written;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(working_)) files.push_back(entry.path());
  for (const fs::path& file : files) {
    fs::rename(file, final_ / file.filename());
    written.insert(file.filename().string());
  }
  files.clear();
  for (const auto& entry : fs::directory_iterator(final_)) files.push_back(entry.path());
  for (const fs::path& file : files)
    if (is_result_file(file) && written.count(file.filename().string()) == 0) fs::remove(file);
}

}  // namespace geneva::app
