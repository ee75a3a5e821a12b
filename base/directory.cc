#include "base/directory.h"

#include <dirent.h>
#include <fmt/format.h>
#include <ftw.h>
#include <stdio.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

#include "base/output_file.h"

namespace geneva::base {

namespace fs = std::filesystem;

std::vector<fs::path> entries_of(const fs::path& directory) {
  const auto refuse = [&] { refuse_by_system(fmt::format("cannot read {}", directory.string())); };
  const std::unique_ptr<DIR, int (*)(DIR*)> stream(::opendir(directory.c_str()), ::closedir);
  if (!stream) refuse();
  std::vector<fs::path> entries;
  for (errno = 0; const dirent* const entry = ::readdir(stream.get()); errno = 0)
    if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0)
      entries.push_back(directory / entry->d_name);
  if (errno != 0) refuse();
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool remove_tree(const fs::path& path) {
  constexpr int directories_held_open = 16;
  const auto remove = [](const char* const name, const struct stat* /*status*/, int /*kind*/,
                         struct FTW* /*place*/) {
    (void)::remove(name);  // what remains is found in the end
    return 0;
  };
  (void)::nftw(path.c_str(), remove, directories_held_open, FTW_DEPTH | FTW_PHYS);
  struct stat status {};
  return ::lstat(path.c_str(), &status) != 0;
}

}  // namespace geneva::base
