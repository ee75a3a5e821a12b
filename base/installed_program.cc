#include "base/installed_program.h"

#include <dlfcn.h>

#include <algorithm>
#include <system_error>

namespace geneva::base {

namespace fs = std::filesystem;

namespace {

/// Where the shared library or the program lies that holds this code; empty if that is not known.
fs::path directory_of_this_code() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<const void*>(&installed_program), &info) == 0) return {};
  const fs::path file = info.dli_fname == nullptr ? "" : info.dli_fname;
  return file.is_absolute() ? file.parent_path().lexically_normal() : fs::path();
}

}  // namespace

std::vector<fs::path> places_of_installed_program(const std::string& name) {
  const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path();
  std::vector<fs::path> directories{beside, beside.parent_path() / "libexec/geneva"};
  if (const fs::path here = directory_of_this_code(); !here.empty()) {
    directories.push_back(here);
    for (const fs::path& prefix : {here.parent_path(), here.parent_path().parent_path()})
      directories.push_back(prefix / "libexec/geneva");
  }
  std::vector<fs::path> places;
  for (const fs::path& directory : directories)
    if (std::find(places.begin(), places.end(), directory / name) == places.end())
      places.push_back(directory / name);
  return places;
}

fs::path installed_program(const std::string& name) {
  const std::vector<fs::path> places = places_of_installed_program(name);
  std::error_code ignored;
  const auto found = std::find_if(places.begin(), places.end(), [&](const fs::path& place) {
    return fs::exists(place, ignored);
  });
  return found == places.end() ? places.front() : *found;
}

}  // namespace geneva::base
