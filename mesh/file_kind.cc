#include "mesh/file_kind.h"

#include <fmt/format.h>

#include <string>

#include "base/errors.h"

namespace geneva::mesh {

FileKind kind_of(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".geo") return FileKind::geometry;
  if (extension == ".msh") return FileKind::mesh;
  if (extension == ".step" || extension == ".stp") return FileKind::step;
  throw base::InputError(
      fmt::format("{}: a geometry must be a .geo, .msh, .step or .stp file", file.string()));
}

}  // namespace geneva::mesh
