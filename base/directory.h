#pragma once

#include <filesystem>
#include <vector>

namespace geneva::base {

/// What a directory holds, sorted by name.
///
/// The standard library's iterator ends the process where memory runs out on the way.
/// @return full paths
/// @throws InputError if it cannot be read
std::vector<std::filesystem::path> entries_of(const std::filesystem::path& directory);

/// Removes a file, or a directory with all that it holds; follows no link.
/// @return whether nothing is left of it
bool remove_tree(const std::filesystem::path& path);

}  // namespace geneva::base
