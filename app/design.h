#pragma once

#include <filesystem>
#include <vector>

#include "model/input/case_file.h"
#include "post/output/design_output.h"

namespace geneva::app {

/// Johnson's design of wheel and shaft for the mechanism of a case (Johnson 1956, Eq. 1 to 16).
/// @throws base::InputError if the case is no mechanism or has no best wheel
post::DesignReport make_design(const model::Case& given);

/// Prints the designs of one or more cases side by side in the output units of the first, and
/// writes design.json and design.csv for each.
/// @param output where they go; empty: results in the case's directory. Of several cases each has
/// its own directory in it.
/// @return the exit code, 0
/// @throws base::InputError if a case is wrong, or two would be written into one directory;
/// std::runtime_error if not everything could be written
int design_cases(const std::vector<std::filesystem::path>& cases,
                 const std::filesystem::path& output);

}  // namespace geneva::app
