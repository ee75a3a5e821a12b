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

template <int dim>
void scale(MeshData<dim>& mesh, const double length_unit) {
  for (auto& vertex : mesh.vertices)
    for (double& coordinate : vertex) coordinate *= length_unit;
  for (Circle& circle : mesh.circles) {
    for (double& coordinate : circle.centre) coordinate *= length_unit;
    circle.radius *= length_unit;
  }
}

template <int dim>
MeshData<dim> read(const std::filesystem::path& file, const double circle_tolerance, Mesher& mesher,
                   const MesherLimits& limits) {
  const bool is_mesh = file.extension() == ".msh";
  is_mesh ? check_msh(read_file(file), file) : check_geometry_files(file);
  const std::filesystem::path directory = std::filesystem::canonical(file).parent_path();
  const GeometryTask task{dim, directory.string(), file.filename().string(), is_mesh,
                          circle_tolerance};
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
MeshData<dim> read_geometry(const std::filesystem::path& file, const double length_unit,
                            const double circle_tolerance, Mesher& mesher,
                            const MesherLimits& limits) {
  if (!(length_unit > 0.) || !std::isfinite(length_unit))
    throw base::InputError(fmt::format("{}: its unit of length is {} m: it must be positive",
                                       file.string(), length_unit));
  const std::string extension = file.extension().string();
  if (extension != ".geo" && extension != ".msh")
    throw base::InputError(
        fmt::format("{}: a geometry must be a .geo or a .msh file", file.string()));
  return naming<dim>(file, [&] {
    MeshData<dim> mesh = read<dim>(file, circle_tolerance, mesher, limits);
    scale(mesh, length_unit);
    check(mesh);
    return mesh;
  });
}

template MeshData<2> read_geometry(const std::filesystem::path&, double, double, Mesher&,
                                   const MesherLimits&);
template MeshData<3> read_geometry(const std::filesystem::path&, double, double, Mesher&,
                                   const MesherLimits&);

}  // namespace geneva::mesh
