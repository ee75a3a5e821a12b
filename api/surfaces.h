#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/units.h"
#include "mesh/surface_list.h"

namespace geneva {

namespace mesh {
class Mesher;
}

/// What a case may name of its geometry file.
struct SurfaceList {
  std::filesystem::path file;
  int dimension;  ///< 2 or 3
  base::UnitSystem units;
  std::vector<std::string> bodies;
  std::vector<mesh::ListedSurface> surfaces;  ///< in the order of the bodies
};

/// Bodies and surfaces of a case's geometry file. Of the case only the dimension, the units and
/// what concerns the file need to be there.
/// @throws base::InputError if there is no file, or it cannot be read or meshed
SurfaceList surfaces(const std::filesystem::path& case_directory, mesh::Mesher& mesher);

/// As `geneva surfaces` prints them.
std::string table(const SurfaceList& list);

}  // namespace geneva
