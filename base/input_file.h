#pragma once

#include <filesystem>
#include <string>

namespace geneva::base {

/// All bytes of a file; none if it cannot be read.
std::string bytes_of(const std::filesystem::path& file);

}  // namespace geneva::base
