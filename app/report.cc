#include "app/report.h"

#include <fmt/format.h>

#include <iostream>
#include <string>

#include "app/output_directory.h"
#include "post/report/report.h"

namespace geneva::app {

namespace fs = std::filesystem;

void write_report(const fs::path& results, const fs::path& file) {
  const post::Libraries libraries = post::installed_libraries();
  for (const std::string& package : libraries.missing)
    std::cerr << fmt::format(
        "geneva: the report lacks its interactive parts: the package {} is not installed "
        "('apt-get install {}')\n",
        package, package);
  const post::Report report = post::make_report(post::read_results(results), libraries);
  if (report.picture) write_and_rename(results / "stress.svg", *report.picture);
  write_and_rename(file.empty() ? results / "report.html" : file, report.html);
}

int make_report(const std::vector<fs::path>& results, const fs::path& file) {
  write_report(results.front(), file);
  std::cout << "report in " << shown_path(file.empty() ? results.front() / "report.html" : file)
            << '\n';
  return 0;
}

}  // namespace geneva::app
