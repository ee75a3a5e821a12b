#pragma once

#include <filesystem>
#include <vector>

namespace geneva::app {

/// Writes the report on what a results directory holds, and the picture stress.svg beside its
/// files; a missing JavaScript package is a warning on standard error.
/// @throws base::InputError where the directory's contents are refused, or a file cannot be written
void write_report(const std::filesystem::path& results);

/// `geneva report`: writes the report, or of several directories the comparison, and says where it
/// is.
/// @param file empty: report.html in the directory, comparison.html in the current one
/// @return exit code 0
/// @throws base::InputError where write_report() does
int make_report(const std::vector<std::filesystem::path>& results,
                const std::filesystem::path& file);

}  // namespace geneva::app
