#include "app/report.h"

#include <fmt/format.h>

#include <iostream>
#include <string>
#include <system_error>

#include "app/output_directory.h"
#include "base/errors.h"
#include "base/output_file.h"
#include "post/output/result_files.h"
#include "post/report/report.h"

namespace geneva::app {

namespace fs = std::filesystem;

namespace {

post::Libraries libraries_with_warnings() {
  post::Libraries libraries = post::installed_libraries();
  for (const std::string& package : libraries.missing)
    std::cerr << fmt::format(
        "geneva: the report lacks its interactive parts: the package {} is not installed "
        "('apt-get install {}')\n",
        package, package);
  return libraries;
}

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

fs::path write_comparison(const std::vector<fs::path>& directories, const fs::path& file) {
  std::vector<post::ResultsDirectory> all;
  for (const fs::path& directory : directories) all.push_back(post::read_results(directory));
  const fs::path target = file.empty() ? fs::path("comparison.html") : file;
  write_anywhere(target, post::make_comparison(all, libraries_with_warnings()));
  return target;
}

void write_report_to(const fs::path& results, const fs::path& file) {
  const post::ResultsDirectory read = post::read_results(results);
  const post::Report report = post::make_report(read, libraries_with_warnings());
  if (report.picture) base::replace_file(post::own_file(results, "stress.svg"), *report.picture);
  write_anywhere(file, report.html);
}

}  // namespace

void write_report(const fs::path& results) {
  write_report_to(results, post::own_file(results, "report.html"));
}

int make_report(const std::vector<fs::path>& results, const fs::path& file) {
  if (results.size() > 1) {
    const fs::path written = write_comparison(results, file);
    std::cout << "comparison in " << shown_path(written) << '\n';
    return 0;
  }
  const fs::path target = file.empty() ? results.front() / "report.html" : file;
  write_report_to(results.front(), target);
  std::cout << "report in " << shown_path(target) << '\n';
  return 0;
}

}  // namespace geneva::app
