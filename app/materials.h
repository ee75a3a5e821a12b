#pragma once

#include <filesystem>
#include <string>

namespace geneva::app {

/// `geneva materials`: prints the list of materials, or all that is known of one.
/// @param name empty: the list
/// @return exit code 0
/// @throws base::InputError for a name that is not known
int show_materials(const std::string& name, const std::filesystem::path& case_directory);

}  // namespace geneva::app
