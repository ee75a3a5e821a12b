#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/input/case_file.h"
#include "model/input/case_values.h"

namespace geneva::model {

/// Parameters 'Surface NAME' and 'Solid NAME' that a case file has.
std::vector<std::string> pick_names(const ParameterText& text);

/// Name of the geometry file that the directory has.
/// @throws base::InputError unless there is one
std::string default_geometry_file(const ParameterText& text,
                                  const std::filesystem::path& directory);

/// What a case says of its geometry file. Places are given as "nearest 12 mm, 0, 3 mm", behind
/// "face", "edge" or "solid" if one likes.
/// @param dimension 2 or 3
/// @throws base::InputError if the file is missing or outside of the case directory, or a value
/// has no effect with it
GeometryFile read_geometry_file(const CaseValues& values, const std::filesystem::path& directory,
                                int dimension);

/// The same of a case file that may say nothing else yet.
GeometryFile read_geometry_file(const ParameterText& text, const std::filesystem::path& directory,
                                int dimension);

}  // namespace geneva::model
