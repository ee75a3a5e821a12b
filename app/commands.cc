#include "app/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "api/crown.h"
#include "api/design.h"
#include "api/estimate.h"
#include "api/kinematics.h"
#include "api/report.h"
#include "api/synthesis.h"
#include "app/exit_code.h"
#include "app/highlight.h"

namespace geneva::app {

namespace fs = std::filesystem;

namespace {

void print_heading(const Case& given) {
  std::cout << model::name_of(given) << (given.title.empty() ? "" : ": " + given.title) << '\n';
}

/// @param of what they are, before each of them
void tell_notices(const std::vector<std::string>& notices, const std::string& of = "") {
  for (const std::string& notice : notices)
    std::cout << for_stream("note: " + of + notice, stdout) << '\n';
}

void tell(const Written& written, const std::string& files, const fs::path& directory) {
  tell_written(written, files, directory,
               [](const std::string& line) { std::cout << line << '\n'; });
}

/// Where the files of each design go.
std::vector<fs::path> directories(const std::vector<Design>& designs, const fs::path& output) {
  std::vector<fs::path> result;
  for (const auto& [given, report, notices] : designs) {
    const fs::path target = output.empty()        ? given.directory / "results"
                            : designs.size() == 1 ? output
                                                  : output / model::name_of(given);
    fs::path directory = (fs::absolute(target) / "").lexically_normal().parent_path();
    if (std::find(result.begin(), result.end(), directory) != result.end())
      throw InputError(
          fmt::format("{}: the results of two cases would go into {}; name each case once, and "
                      "give cases of the same name without --output",
                      given.directory.string(), directory.string()));
    result.push_back(std::move(directory));
  }
  return result;
}

}  // namespace

std::string shown_path(const fs::path& path) {
  const fs::path relative = path.lexically_proximate(fs::current_path());
  return relative.empty() || *relative.begin() == ".." ? path.string() : relative.string();
}

fs::path results_of(const fs::path& case_directory, const fs::path& output) {
  return output.empty() ? case_directory / "results" : output;
}

void tell_written(const Written& written, const std::string& files, const fs::path& directory,
                  const std::function<void(const std::string&)>& line) {
  warn_of_missing_packages(written);
  if (const std::string notice = removal_notice(written); !notice.empty()) line(notice);
  line(files + " in " + shown_path(directory));
}

std::string removal_notice(const Written& written) {
  if (written.removed.empty()) return "";
  return fmt::format("removed results of another case, or of this one before it was changed: {}",
                     fmt::join(written.removed, ", "));
}

void warn_of_missing_packages(const Written& written) {
  for (const std::string& package : written.missing_packages)
    std::cerr << for_stream(
        fmt::format("geneva: the report lacks its interactive parts: the package {} is not "
                    "installed ('apt-get install {}')\n",
                    package, package),
        stderr);
}

int estimate_case(const fs::path& case_directory, const fs::path& output) {
  const Estimate found = estimate(read_case(case_directory));
  print_heading(found.given);
  std::cout << for_stream(table(found), stdout);
  tell_notices(found.notices);
  const fs::path directory = results_of(found.given.directory, output);
  tell(write(found, directory), "estimate.json, estimate.csv and report.html", directory);
  return 0;
}

int kinematics_of_case(const fs::path& case_directory, const fs::path& output, const int steps) {
  const Kinematics found = kinematics(read_case(case_directory), steps);
  print_heading(found.given);
  std::cout << for_stream(table(found), stdout);
  tell_notices(found.notices);
  const fs::path directory = results_of(found.given.directory, output);
  tell(write(found, directory), "kinematics.json, kinematics.csv and report.html", directory);
  return 0;
}

int crown_of_case(const fs::path& case_directory, const fs::path& output) {
  const Crown crown = design_crown(read_case(case_directory));
  print_heading(crown.given);
  std::cout << for_stream(table(crown), stdout);
  const fs::path directory = results_of(crown.given.directory, output);
  tell(write(crown, directory), "crown.json, crown.csv and report.html", directory);
  return 0;
}

int design_cases(const std::vector<fs::path>& cases, const fs::path& output) {
  std::vector<Design> designs;
  for (const fs::path& directory : cases) designs.push_back(design(read_case(directory)));
  const std::vector<fs::path> targets = directories(designs, output);
  std::cout << for_stream(table(designs), stdout);
  for (const auto& [given, report, notices] : designs)
    tell_notices(notices, designs.size() > 1 ? report.about.name + ": " : "");
  for (std::size_t i = 0; i < designs.size(); ++i)
    tell(write(designs[i], targets[i]), "design.json, design.csv and report.html", targets[i]);
  return 0;
}

int synthesize_case(const fs::path& case_directory, const fs::path& output) {
  const Synthesis found = synthesize(read_case(case_directory));
  print_heading(found.given);
  std::cout << for_stream(table(found), stdout);
  const fs::path directory = results_of(found.given.directory, output);
  tell(write(found, directory), "synthesis.json and synthesis.csv", directory);
  if (found.shortfall.empty()) return 0;
  say_failure(not_converged, found.shortfall);
  return not_converged;
}

int report_on(const std::vector<fs::path>& results, const fs::path& file) {
  const bool is_comparison = results.size() > 1;
  const fs::path target = !file.empty()   ? file
                          : is_comparison ? fs::path("comparison.html")
                                          : results.front() / "report.html";
  warn_of_missing_packages(is_comparison ? write_comparison(results, target)
                                         : write_report(results.front(), target));
  std::cout << (is_comparison ? "comparison in " : "report in ") << shown_path(target) << '\n';
  return 0;
}

}  // namespace geneva::app
