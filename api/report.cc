#include "api/report.h"

#include <fmt/format.h>

#include <string>
#include <system_error>

#include "base/errors.h"
#include "base/output_file.h"
#include "post/output/result_files.h"
#include "post/report/report.h"

namespace geneva {

namespace fs = std::filesystem;

namespace {

/// Into a directory that may not exist.
void write_anywhere(const fs::path& file, const std::string& text) {
  const fs::path directory = fs::absolute(file).parent_path();
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    throw base::InputError(
        fmt::format("directory {} cannot be made: {}", directory.string(), error.message()));
  base::replace_file(file, text);
}

}  // namespace

Written write_report(const fs::path& results, const fs::path& file) {
  const post::ResultsDirectory read = post::read_results(results);
  const post::Libraries libraries = post::installed_libraries();
  const post::Report report = post::make_report(read, libraries);
  if (report.picture) base::replace_file(post::own_file(results, "stress.svg"), *report.picture);
  write_anywhere(file.empty() ? post::own_file(results, "report.html") : file, report.html);
  return {{}, libraries.missing};
}

Written write_comparison(const std::vector<fs::path>& results, const fs::path& file) {
  std::vector<post::ResultsDirectory> all;
  for (const fs::path& directory : results) all.push_back(post::read_results(directory));
  const post::Libraries libraries = post::installed_libraries();
  write_anywhere(file, post::make_comparison(all, libraries));
  return {{}, libraries.missing};
}

}  // namespace geneva
