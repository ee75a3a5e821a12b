#pragma once

#include <filesystem>
#include <vector>

#include "api/written.h"

namespace geneva {

/// Writes report.html and stress.svg of a results directory from the files in it.
/// @param file where the report goes; empty: report.html in the directory
/// @throws base::InputError if there are no results, or a file cannot be written
Written write_report(const std::filesystem::path& results, const std::filesystem::path& file = {});

/// Writes an HTML file that compares several results directories.
/// @throws base::InputError as write_report()
Written write_comparison(const std::vector<std::filesystem::path>& results,
                         const std::filesystem::path& file);

}  // namespace geneva
