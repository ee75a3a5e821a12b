#pragma once

#include <filesystem>
#include <string>

#include "model/input/case_values.h"

namespace geneva::model {

/// The file of the case directory that a parameter names.
/// @throws base::InputError if it lies outside of the directory or does not exist
std::filesystem::path file_in_directory(const CaseSection& section, const std::string& parameter,
                                        const std::filesystem::path& directory);

}  // namespace geneva::model
