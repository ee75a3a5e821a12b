#pragma once

#include <filesystem>
#include <string>

namespace geneva::app {

/// `geneva export`: writes the drawn parts of a mechanism for CAD systems and tells of each file
/// what was read back.
/// @param output where they go; empty: cad in the case's directory
/// @param angle of the driver in the assembly, as "20 deg"; empty: where the case is analysed
/// @return exit code 0
int export_case(const std::filesystem::path& case_directory, const std::filesystem::path& output,
                const std::string& angle);

}  // namespace geneva::app
