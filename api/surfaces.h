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

/// Whether a path is that of a STEP file rather than of a case directory.
bool is_step_file(const std::filesystem::path& path);

/// Bodies and surfaces of a case's geometry file, or of a STEP file's solids. Of the case only the
/// dimension, the units and what concerns the file need to be there.
/// @throws base::InputError if there is no file, or it cannot be read or meshed
SurfaceList surfaces(const std::filesystem::path& case_directory_or_file, mesh::Mesher& mesher);

/// Size and place of a surface in words, in the units of the list.
struct SurfaceRow {
  std::string size;   ///< "12.5 mm^2"
  std::string place;  ///< "1 mm, 2 mm, 3 mm"
};
SurfaceRow row_of(const SurfaceList& list, const mesh::ListedSurface& surface);

/// As `geneva surfaces` prints them.
std::string table(const SurfaceList& list);

/// Draws them: a page with pictures and the table.
/// @throws base::InputError if the file cannot be written; it is then as it was
void write_picture(const SurfaceList& list, const std::filesystem::path& file);

}  // namespace geneva
