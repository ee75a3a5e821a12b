#include "model/input/case_path.h"

#include <algorithm>
#include <system_error>

namespace geneva::model {

namespace fs = std::filesystem;

namespace {

bool is_inside(const fs::path& file, const fs::path& directory) {
  const auto end = std::mismatch(directory.begin(), directory.end(), file.begin(), file.end());
  return end.first == directory.end();
}

}  // namespace

fs::path file_in_directory(const CaseSection& section, const std::string& parameter,
                           const fs::path& directory) {
  const fs::path name = section.text(parameter);
  std::error_code error;
  fs::path file = directory / name;
  const fs::path real_file = fs::weakly_canonical(file, error);
  const fs::path real_directory = error ? fs::path() : fs::canonical(directory, error);
  if (error || name.is_absolute() || !is_inside(real_file, real_directory))
    section.refuse(parameter, "a file in the case directory is wanted, not one outside of it");
  if (!fs::is_regular_file(real_file, error))
    section.refuse(parameter, "there is no such file in the case directory");
  return file;
}

}  // namespace geneva::model
