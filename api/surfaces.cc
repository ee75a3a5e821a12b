#include "api/surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "api/surface_picture.h"
#include "base/output_file.h"
#include "fem/problem/settings.h"
#include "mesh/file_kind.h"
#include "mesh/user_geometry.h"
#include "model/input/geometry_file.h"
#include "model/input/parameter_text.h"

namespace geneva {

namespace {

namespace fs = std::filesystem;

std::string value_of(const model::ParameterText& text, const std::string& name,
                     const std::string& otherwise) {
  const model::Assignment* const found = text.find({}, name);
  return found == nullptr ? otherwise : found->value;
}

template <int dim>
SurfaceList list_of(const model::GeometryFile& given, const base::UnitSystem units,
                    mesh::Mesher& mesher) {
  const fem::Settings settings;
  const mesh::MeshData<dim> mesh = mesh::read_geometry<dim>(
      {given.file, given.length_unit, given.circle_tolerance, {}, given.picks, given.cell_size},
      mesher, {settings.max_memory, mesh::longest_meshing});
  const base::OutputUnit length = base::output_unit(units, base::Dimension::length);
  return {given.file, dim, units, mesh.bodies,
          mesh::list_surfaces(mesh, length.name, 1. / length.factor)};
}

/// What a case of the solids of a STEP file has to say at least.
model::ParameterText case_of_solids(const fs::path& file) {
  return model::parameter_text(
      file.string(),
      fmt::format("set Dimension = 3\nset Output units = mm-N\nsubsection Geometry\n  set File = "
                  "{}\nend\n",
                  file.filename().string()));
}

std::string place_of(const mesh::ListedSurface& surface, const int dimension,
                     const base::OutputUnit& length) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    const double value = surface.place[i] * length.factor;
    parts.push_back(fmt::format("{:.6g} {}", std::abs(value) < 1e-9 ? 0. : value, length.name));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

bool is_step_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && mesh::kind_of(path) == mesh::FileKind::step;
}

SurfaceList surfaces(const fs::path& case_directory_or_file, mesh::Mesher& mesher) {
  const bool is_file = is_step_file(case_directory_or_file);
  const fs::path case_directory =
      is_file ? fs::absolute(case_directory_or_file).parent_path() : case_directory_or_file;
  const model::ParameterText text = is_file
                                        ? case_of_solids(case_directory_or_file)
                                        : model::read_parameter_text(case_directory / "case.prm");
  const int dimension = value_of(text, "Dimension", "2") == "3" ? 3 : 2;
  const base::UnitSystem units =
      base::unit_system_named(value_of(text, "Output units", base::name_of(base::UnitSystem::si)));
  const model::GeometryFile file = model::read_geometry_file(text, case_directory, dimension);
  return dimension == 3 ? list_of<3>(file, units, mesher) : list_of<2>(file, units, mesher);
}

SurfaceRow row_of(const SurfaceList& list, const mesh::ListedSurface& surface) {
  const base::OutputUnit length = base::output_unit(list.units, base::Dimension::length);
  const bool is_area = list.dimension == 3;
  const double factor = is_area ? length.factor * length.factor : length.factor;
  return {fmt::format("{:.4g} {}{}", surface.size * factor, length.name, is_area ? "^2" : ""),
          place_of(surface, list.dimension, length)};
}

std::string table(const SurfaceList& list) {
  std::size_t width = 0;
  for (const mesh::ListedSurface& surface : list.surfaces)
    width = std::max(width, surface.name.size());
  std::string text;
  for (const std::string& body : list.bodies) {
    text += fmt::format("body {}\n", body);
    for (const mesh::ListedSurface& surface : list.surfaces) {
      if (surface.body != body) continue;
      const SurfaceRow row = row_of(list, surface);
      text += fmt::format("  {:<{}}  {:<28}{:>14}  nearest {}\n", surface.name, width,
                          surface.shape, row.size, row.place);
    }
  }
  return text;
}

void write_picture(const SurfaceList& list, const fs::path& file) {
  base::replace_file(file, api::surface_page(list));
}

}  // namespace geneva
