#pragma once

#include <filesystem>
#include <string>

namespace geneva::mesh {

/// Refuses what is no complete .msh file of format 2.2 or 4.1, text or binary, before Gmsh reads
/// it.
///
/// Gmsh would run a file that does not begin like a mesh as a script, whatever its name.
/// @param content of the file
/// @param file for messages
/// @throws base::InputError naming the file and what is missing
void check_msh(const std::string& content, const std::filesystem::path& file);

}  // namespace geneva::mesh
