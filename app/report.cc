#include "app/report.h"

#include <fmt/format.h>

#include <iostream>
#include <string>

#include "app/output_directory.h"
#include "post/report/report.h"
#include "post/result_files.h"

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

fs::path write_comparison(const std::vector<fs::path>& directories, const fs::path& file) {
  std::vector<post::ResultsDirectory> all;
  for (const fs::path& directory : directories) all.push_back(post::read_results(directory));
  const fs::path target = file.empty() ? fs::path("comparison.html") : file;
  write_and_rename(fs::absolute(target), post::make_comparison(all, libraries_with_warnings()));
  return target;
}

}  // namespace

void write_report(const fs::path& results, const fs::path& file) {
  const post::ResultsDirectory read = post::read_results(results);
  const post::Report report = post::make_report(read, libraries_with_warnings());
  if (report.picture) write_and_rename(post::own_file(results, "stress.svg"), *report.picture);
  write_and_rename(fs::absolute(file.empty() ? post::own_file(results, "report.html") : file),
                   report.html);
}

int make_report(const std::vector<fs::path>& results, const fs::path& file) {
  if (results.size() > 1) {
    const fs::path written = write_comparison(results, file);
    std::cout << "comparison in " << shown_path(written) << '\n';
    return 0;
  }
  write_report(results.front(), file);
  std::cout << "report in " << shown_path(file.empty() ? results.front() / "report.html" : file)
            << '\n';
  return 0;
}

}  // namespace geneva::app
