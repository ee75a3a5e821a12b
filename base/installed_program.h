#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geneva::base {

/// Where a program that belongs to this one is looked for: beside it and beside the shared library
/// that holds this code, and in libexec/geneva of the prefix of either.
std::vector<std::filesystem::path> places_of_installed_program(const std::string& name);

/// The first of those places that exists; the first of all if none does.
std::filesystem::path installed_program(const std::string& name);

}  // namespace geneva::base
