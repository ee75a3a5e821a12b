#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "api/written.h"

namespace geneva::app {

/// A path as the user would write it: relative where it lies below the current directory.
std::string shown_path(const std::filesystem::path& path);

/// Where the results of a case go that the command line gives no directory for.
std::filesystem::path results_of(const std::filesystem::path& case_directory,
                                 const std::filesystem::path& output);

/// Says what was written where, and what was removed; warns of what the report lacks.
/// @param line called for each line of it
void tell_written(const Written& written, const std::string& files,
                  const std::filesystem::path& directory,
                  const std::function<void(const std::string&)>& line);

/// A sentence on what was removed; empty if nothing was.
std::string removal_notice(const Written& written);

/// Warns of what the report lacks.
void warn_of_missing_packages(const Written& written);

/// `geneva estimate`: prints the figures and writes the results.
/// @param output where the files go; empty: results in the case's directory
/// @return exit code 0
int estimate_case(const std::filesystem::path& case_directory, const std::filesystem::path& output);

/// `geneva kinematics`: prints the characteristic values and writes the results.
/// @param output where the files go; empty: results in the case's directory
/// @return exit code 0
int kinematics_of_case(const std::filesystem::path& case_directory,
                       const std::filesystem::path& output, int steps);

/// `geneva design --crown --no-run`: searches for the most even pin, prints it before and after,
/// and writes the results.
/// @param output where they go; empty: results in the case's directory
/// @return exit code 0
int crown_of_case(const std::filesystem::path& case_directory, const std::filesystem::path& output);

/// `geneva design`: prints the designs of one or more cases side by side in the output units of the
/// first, and writes the results of each.
/// @param output where they go; empty: results in the case's directory. Of several cases each has
/// its own directory in it.
/// @return exit code 0
/// @throws base::InputError if a case is wrong, or two would be written into one directory
int design_cases(const std::vector<std::filesystem::path>& cases,
                 const std::filesystem::path& output);

/// `geneva synthesize`: prints the linkage or linkages and writes the results.
/// @param output where the files go; empty: results in the case's directory
/// @return exit code: 0, or 2 if no path generator was found
int synthesize_case(const std::filesystem::path& case_directory,
                    const std::filesystem::path& output);

/// `geneva report`: writes the report, or of several directories the comparison, and says where it
/// is.
/// @param file empty: report.html in the directory, comparison.html in the current one
/// @return exit code 0
int report_on(const std::vector<std::filesystem::path>& results, const std::filesystem::path& file);

}  // namespace geneva::app
