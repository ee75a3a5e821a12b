#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/geometry_tokens.h"

namespace geneva::mesh {

/// A geometry of which every word is known to do no harm: what Gmsh is given instead of the user's
/// file.
struct GuardedGeometry {
  std::string text;               ///< without comments, included files in their place
  std::vector<SourceLine> lines;  ///< where each line of the text comes from
  std::vector<std::filesystem::path>
      meshes;  ///< .msh files merged; the text calls them merged_name(0), 1, ...
};

/// Name under which the text of a guarded geometry merges its mesh of that index.
std::string merged_name(std::size_t index);

/// Content of a file.
/// @throws std::invalid_argument if there is no such file, or it is too large to be a case's
/// geometry (1 GiB)
std::string read_file(const std::filesystem::path& file);

/// Reads a .geo file and everything that it includes, and refuses what is not drawing or meshing.
///
/// A .geo file is a program: Gmsh's language can run shell commands and read and write any file. So
/// this works with a list of what is allowed, not of what is forbidden: every word has to be a
/// known command of drawing and meshing or a variable that the file itself assigns, a text may
/// stand only where it is an argument, and formats take numbers only. Include and Merge take a
/// written-out name of a .geo or .msh file inside the directory of `file` (symbolic links that
/// leave it are refused). The result is spelt anew from the tokens, so that nothing can hide in the
/// differences between this reader and Gmsh's own.
/// @throws std::invalid_argument with file, line, the word found, what it would do and what is
/// allowed
GuardedGeometry guard_geometry(const std::filesystem::path& file);

}  // namespace geneva::mesh
