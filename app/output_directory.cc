#include "app/output_directory.h"

#include <fmt/format.h>
#include <unistd.h>

#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace geneva::app {

namespace fs = std::filesystem;

namespace {

/// Files that this program writes; a later run may remove them.
bool is_result_file(const fs::path& file) {
  static const std::set<std::string> names{"solution.pvd", "solution.pvtu", "contact.vtu",
                                           "contact.csv",  "results.h5",    "results.xdmf",
                                           "summary.json", "case.prm",      "log.txt"};
  const std::string name = file.filename().string();
  return names.count(name) > 0 || (name.rfind("solution.", 0) == 0 && file.extension() == ".vtu");
}

fs::path working_name(const fs::path& final) {
  return final.parent_path() / fmt::format(".{}.partial", final.filename().string());
}

}  // namespace

OutputDirectory::OutputDirectory(fs::path final, const bool is_owner)
    : final_(fs::absolute(final).lexically_normal()), is_owner_(is_owner) {
  if (final_.filename().empty()) final_ = final_.parent_path();
  working_ = working_name(final_);
  if (!is_owner_) return;
  std::error_code error;
  const bool is_blocked = fs::exists(final_, error) && !fs::is_directory(final_, error);
  if (is_blocked)
    throw std::invalid_argument(
        fmt::format("results directory {}: a file of that name is in the way", final_.string()));
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
    throw std::invalid_argument(
        fmt::format("results directory {} cannot be written{}; give another one with --output",
                    final_.string(), error ? " (" + error.message() + ")" : ""));
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
