#include "base/installed_program.h"

#include <dlfcn.h>

#include <system_error>
#include <vector>

namespace geneva::base {

namespace fs = std::filesystem;

namespace {

/// Where the shared library or the program lies that holds this code; empty if that is not known.
fs::path directory_of_this_code() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<const void*>(&installed_program), &info) == 0) return {};
  const fs::path file = info.dli_fname == nullptr ? "" : info.dli_fname;
  return file.is_absolute() ? file.parent_path() : fs::path();
}

}  // namespace

fs::path installed_program(const std::string& name) {
  const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path();
  std::vector<fs::path> places{beside, beside.parent_path() / "libexec/geneva"};
  if (const fs::path here = directory_of_this_code(); !here.empty())
    for (const fs::path& prefix : {here.parent_path(), here.parent_path().parent_path()})
      places.push_back(prefix / "libexec/geneva");
  std::error_code ignored;
  for (const fs::path& place : places)
    if (fs::exists(place / name, ignored)) return place / name;
  return beside / name;
}

}  // namespace geneva::base
