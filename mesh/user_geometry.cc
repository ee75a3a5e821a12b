#include "mesh/user_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/errors.h"
#include "mesh/geometry_check.h"
#include "mesh/msh_file.h"

namespace geneva::mesh {

namespace {

using Errors = std::vector<std::string>;

std::string listed(const Errors& errors) {
  const std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, errors.size()); ++i)
    text += (i == 0 ? "" : "; ") + errors[i];
  if (errors.size() > most) text += fmt::format("; and {} more errors", errors.size() - most);
  return text;
}

/// Gmsh's "'file', line 7 : what" as "file:7: what", with the directory as the user has it.
/// @param real the same directory without links
std::string with_place(std::string error, const std::filesystem::path& real,
                       const std::filesystem::path& given) {
  const std::string shown = given.empty() ? "." : given.string();
  for (std::size_t at = error.find(real.string()); real != given && at != error.npos;
       at = error.find(real.string(), at + shown.size()))
    error.replace(at, real.string().size(), shown);
  static const std::regex place("^'([^']*)', line ([0-9]+) ?: ?");
  return std::regex_replace(error, place, "$1:$2: ");
}

/// @throws base::InputError if a file does not begin and end as a STEP file does
void check_step(const std::string& content, const std::filesystem::path& file) {
  const std::size_t begin = content.find_first_not_of(" \t\r\n");
  const std::string start = "ISO-10303-21;";
  if (begin == content.npos || content.compare(begin, start.size(), start) != 0)
    throw base::InputError(
        fmt::format("{}: it does not begin with {}: this is no STEP file", file.string(), start));
  if (content.find("END-ISO-10303-21;") == content.npos)
    throw base::InputError(
        fmt::format("{}: END-ISO-10303-21; is missing: the file was cut short; export it again",
                    file.string()));
}

template <int dim>
void scale(MeshData<dim>& mesh, const double length_unit) {
  for (auto& vertex : mesh.vertices)
    for (double& coordinate : vertex) coordinate *= length_unit;
  for (Circle& circle : mesh.circles) {
    for (double& coordinate : circle.centre) coordinate *= length_unit;
    circle.radius *= length_unit;
    circle.ring_radius *= length_unit;
  }
}

GeometryTask task_of(const UserGeometry& geometry, const int dimension,
                     const std::filesystem::path& directory) {
  const FileKind kind = kind_of(geometry.file);
  GeometryTask task{dimension, directory.string(), geometry.file.filename().string(), kind,
                    geometry.circle_tolerance};
  if (kind != FileKind::step) return task;
  task.bodies = geometry.bodies;
  task.picks = geometry.picks;
  task.cell_size = geometry.cell_size.value_or(0.);
  return task;
}

/// What can be seen of a file without Gmsh.
void check_file(const std::filesystem::path& file) {
  switch (kind_of(file)) {
    case FileKind::geometry:
      return check_geometry_files(file);
    case FileKind::mesh:
      return check_msh(read_file(file), file);
    case FileKind::step:
      return check_step(read_file(file), file);
  }
}

template <int dim>
MeshData<dim> read(const UserGeometry& geometry, Mesher& mesher, const MesherLimits& limits) {
  const std::filesystem::path& file = geometry.file;
  check_file(file);
  const std::filesystem::path directory = std::filesystem::canonical(file).parent_path();
  const GeometryTask task = task_of(geometry, dim, directory);
  const MesherAnswer answer = mesher.answer(task, limits);
  if (answer.errors.empty()) return mesh_of<dim>(answer.mesh);
  Errors errors;
  for (const std::string& error : answer.errors)
    errors.push_back(with_place(error, directory, file.parent_path()));
  throw base::InputError(listed(errors));
}

/// Runs an action; what it refuses gets the name of the file in front, unless it is there.
template <int dim>
MeshData<dim> naming(const std::filesystem::path& file,
                     const std::function<MeshData<dim>()>& action) {
  try {
    return action();
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    if (what.find(file.string()) != what.npos) throw;
    throw base::InputError(fmt::format("{}: {}", file.string(), what));
  } catch (const base::LimitReached& error) {
    throw base::LimitReached(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace

template <int dim>
MeshData<dim> read_geometry(const UserGeometry& geometry, Mesher& mesher,
                            const MesherLimits& limits) {
  const double unit = geometry.length_unit;
  if (!(unit > 0.) || !std::isfinite(unit))
    throw base::InputError(fmt::format("{}: its unit of length is {} m: it must be positive",
                                       geometry.file.string(), unit));
  return naming<dim>(geometry.file, [&] {
    MeshData<dim> mesh = read<dim>(geometry, mesher, limits);
    scale(mesh, unit);
    check(mesh);
    return mesh;
  });
}

template MeshData<2> read_geometry(const UserGeometry&, Mesher&, const MesherLimits&);
template MeshData<3> read_geometry(const UserGeometry&, Mesher&, const MesherLimits&);

}  // namespace geneva::mesh
