#pragma once

#include <filesystem>
#include <string>

namespace geneva::base {

/// A program that belongs to this one: beside it, or installed in libexec/geneva of the same
/// prefix; used as a shared library, of the prefix where that lies.
/// @return a path, beside this program where there is none
std::filesystem::path installed_program(const std::string& name);

}  // namespace geneva::base
