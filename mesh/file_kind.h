#pragma once

#include <filesystem>

namespace geneva::mesh {

/// What a file of the user's is: a geometry of Gmsh's, a mesh, or parts of a CAD system.
enum class FileKind { geometry, mesh, step };

/// What the extension of a file says of it. @throws base::InputError if it is unknown
FileKind kind_of(const std::filesystem::path& file);

}  // namespace geneva::mesh
