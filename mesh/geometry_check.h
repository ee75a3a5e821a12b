#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geneva::mesh {

/// Content of a file.
/// @throws base::InputError if there is no such file, or it is too large to be a case's
/// geometry (1 GiB)
std::string read_file(const std::filesystem::path& file);

/// Refuses a .geo file that asks for what the mesher may not do and which Gmsh would pass over:
/// running commands, writing files, ending the program; and one whose last line has no end, of
/// which Gmsh would leave out what stands there. It does not make the mesher safer, which is shut
/// in, but tells the user what does not happen.
/// @param content of the file
/// @param file for messages
/// @return names in quotation marks behind Include and Merge
/// @throws base::InputError with file, line, what was found and what it would do
std::vector<std::string> check_geometry(const std::string& content,
                                        const std::filesystem::path& file);

/// The same of a file and of all .geo files that it reads by such names.
void check_geometry_files(const std::filesystem::path& file);

}  // namespace geneva::mesh
