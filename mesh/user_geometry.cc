#include "mesh/user_geometry.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/entity_shape.h"
#include "mesh/geometry_guard.h"
#include "mesh/gmsh_session.h"
#include "mesh/model_reader.h"
#include "mesh/msh_file.h"
#include "mesh/onto_circles.h"
#include "mesh/private_directory.h"

namespace geneva::mesh {

namespace {

using Errors = std::vector<std::string>;

/// What bodies and their boundary are made of.
template <int dim>
struct Kinds {
  static constexpr const char* body_group = dim == 2 ? "physical surface" : "physical volume";
  static constexpr const char* boundary_group = dim == 2 ? "physical curve" : "physical surface";
  static constexpr const char* body = dim == 2 ? "Physical Surface" : "Physical Volume";
  static constexpr const char* boundary = dim == 2 ? "Physical Curve" : "Physical Surface";
  static constexpr const char* body_entity = dim == 2 ? "surface" : "volume";
  static constexpr const char* boundary_entity = dim == 2 ? "curve" : "surface";
  static constexpr const char* cells = dim == 2 ? "quadrilaterals" : "hexahedra";
};

std::string listed(const Errors& errors) {
  const std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, errors.size()); ++i)
    text += (i == 0 ? "" : "; ") + errors[i];
  if (errors.size() > most) text += fmt::format("; and {} more errors", errors.size() - most);
  return text;
}

/// Gmsh's "'file', line 7: what" with the user's file and line in the place of Gmsh's.
std::string with_source(const std::string& error, const GuardedGeometry& geometry) {
  if (geometry.lines.empty()) return error;
  const std::string before = "', line ";
  const std::size_t at = error.find(before);
  if (error.rfind('\'', 0) != 0 || at == error.npos) return error;
  const std::size_t number = at + before.size();
  const std::size_t end = error.find(':', number);
  if (end == error.npos || end - number > 8) return error;
  int line = 0;
  for (std::size_t i = number; i < end; ++i) {
    if (std::isdigit(static_cast<unsigned char>(error[i])) == 0) return error;
    line = 10 * line + (error[i] - '0');
  }
  const auto index =
      static_cast<std::size_t>(std::clamp(line, 1, static_cast<int>(geometry.lines.size())) - 1);
  const SourceLine& source = geometry.lines[index];
  return fmt::format("{}:{}{}", source.file.string(), source.number, error.substr(end));
}

/// Name of every physical group of a dimension, by tag.
/// @param kind "Physical Surface"
std::map<int, std::string> group_names(const int dimension, const std::string& kind) {
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dimension);
  std::map<int, std::string> names;
  std::set<std::string> seen;
  for (const auto& [dim, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dim, tag, name);
    if (name.empty())
      throw std::invalid_argument(fmt::format(
          "{0} {1} has no name: write {0}(\"name\", {1}), supports and loads go by names", kind,
          tag));
    if (!seen.insert(name).second)
      throw std::invalid_argument(fmt::format(
          "the name \"{}\" is used for more than one {}: give each its own, or list all entities "
          "in one group",
          name, kind));
    names[tag] = name;
  }
  return names;
}

/// Name of the entity's physical group; nothing if it is in none.
/// @param kind of entity: "curve"
std::optional<std::string> group_of(const int dimension, const int entity, const char* const kind,
                                    const std::map<int, std::string>& names) {
  std::vector<int> groups;
  gmsh::model::getPhysicalGroupsForEntity(dimension, entity, groups);
  // a negative number is a group that has the entity in its other direction
  const auto name = [&](int group) { return names.at(std::abs(group)); };
  if (groups.size() > 1)
    throw std::invalid_argument(
        fmt::format("{} {} is in the physical groups \"{}\" and \"{}\": it may be in one only",
                    kind, entity, name(groups[0]), name(groups[1])));
  if (groups.empty()) return std::nullopt;
  return name(groups.front());
}

bool has_cells(const int dimension, const int entity = -1) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
  return !types.empty();
}

template <int dim>
void label_bodies(ModelLabels& labels) {
  using Kind = Kinds<dim>;
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  if (dim == 2 && !volumes.empty())
    throw std::invalid_argument("there are volumes: 'set Dimension = 3' reads them");
  const std::map<int, std::string> names = group_names(dim, Kind::body);
  if (names.empty())
    throw std::invalid_argument(fmt::format(
        "there is no {}: write {}(\"name\") = {{...}}; for each body{}", Kind::body_group,
        Kind::body, dim == 3 ? "; for a plane geometry 'set Dimension = 2'" : ""));
  for (const auto& [tag, name] : names) labels.bodies.push_back({name, {}});
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dim);
  for (const auto& [dimension, entity] : entities) {
    const std::optional<std::string> name = group_of(dim, entity, Kind::body_entity, names);
    if (!name && has_cells(dim, entity))
      throw std::invalid_argument(
          fmt::format("{} {} is meshed but in no physical group: write {}(\"name\") = {{{}, ...}}; "
                      "or delete it",
                      Kind::body_entity, entity, Kind::body, entity));
    for (ModelLabels::Body& body : labels.bodies)
      if (name && body.name == *name) body.entities.push_back(entity);
  }
}

/// @return indices of the circles that the nodes are only near to
template <int dim>
std::set<int> label_boundary(ModelLabels& labels, const double circle_tolerance) {
  using Kind = Kinds<dim>;
  const std::map<int, std::string> names = group_names(dim - 1, Kind::boundary);
  if (names.empty())
    throw std::invalid_argument(
        fmt::format("there is no {}: write {}(\"name\") = {{...}}; for each part of the boundary "
                    "that is held, loaded or touches",
                    Kind::boundary_group, Kind::boundary));
  for (const auto& [tag, name] : names) labels.surfaces.push_back(name);
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dim - 1);
  const std::map<int, RoundEntity> round = round_entities<dim>(circle_tolerance);
  std::set<int> fitted;
  for (const auto& [dimension, entity] : entities) {
    const auto found = round.find(entity);
    const int circle =
        found == round.end() ? -1 : circle_index(labels.circles, found->second.circle);
    labels.boundary[entity] = {group_of(dim - 1, entity, Kind::boundary_entity, names).value_or(""),
                               circle};
    if (found != round.end() && found->second.is_fitted) fitted.insert(circle);
  }
  return fitted;
}

/// How the user gets cells that can be used.
template <int dim>
std::string advice_on_cells(const bool is_mesh_file) {
  if (dim == 3)
    return "make them with Extrude {...} { Surface{...}; Layers{...}; Recombine; }, or with "
           "Transfinite Surface, Recombine Surface and Transfinite Volume";
  if (is_mesh_file)
    return "write Recombine Surface {...}; in the .geo and mesh it again, or give the .geo file "
           "itself";
  return "let the program mesh (no 'Mesh 2;'), or divide the surfaces into four-sided ones with "
         "Transfinite Surface";
}

template <int dim>
void check_cells(const OtherCells& cells, const bool is_mesh_file) {
  if (cells.of_higher_order > 0)
    throw std::invalid_argument(
        fmt::format("{} cells are of order 2 or higher: linear {} only; set Mesh.ElementOrder = 1 "
                    "(curved boundaries are followed while refining)",
                    cells.of_higher_order, Kinds<dim>::cells));
  if (cells.simplices + cells.others > 0)
    throw std::invalid_argument(
        fmt::format("{} cells are {}: linear {} only; {}", cells.simplices + cells.others,
                    dim == 2 ? "triangles or polygons" : "tetrahedra, prisms or pyramids",
                    Kinds<dim>::cells, advice_on_cells<dim>(is_mesh_file)));
}

template <int dim>
void check_named_boundary(const MeshData<dim>& mesh) {
  for (std::size_t i = 1; i < mesh.surfaces.size(); ++i)
    if (std::none_of(mesh.faces.begin(), mesh.faces.end(),
                     [&](const Face<dim>& face) { return face.surface == i; }))
      throw std::invalid_argument(
          fmt::format("the {} \"{}\" holds no {} of a body's boundary: list the {}s that bound its "
                      "{}",
                      Kinds<dim>::boundary_group, mesh.surfaces[i], dim == 2 ? "edge" : "face",
                      Kinds<dim>::boundary_entity, Kinds<dim>::body_entity));
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

/// The current Gmsh model with its names, after its mesh has been made or read.
template <int dim>
MeshData<dim> named_mesh(const bool is_mesh_file, const double circle_tolerance) {
  ModelLabels labels;
  label_bodies<dim>(labels);
  check_cells<dim>(count_other_cells<dim>(), is_mesh_file);
  check_bodies(read_model<dim>(labels).mesh);  // before the boundary: shared parts have two names
  const std::set<int> fitted = label_boundary<dim>(labels, circle_tolerance);
  MeshData<dim> mesh = read_model<dim>(labels).mesh;
  check_named_boundary(mesh);
  move_onto_circles(mesh, fitted);
  return mesh;
}

/// Meshes the current model; if triangles remain, twice as coarse with each cell divided into
/// quadrilaterals.
template <int dim>
void mesh_current_model() {
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::model::mesh::generate(dim);
  if (dim == 3 || count_other_cells<2>().simplices == 0) return;
  double factor = 1.;
  gmsh::option::getNumber("Mesh.MeshSizeFactor", factor);
  gmsh::model::mesh::clear();
  gmsh::option::setNumber("Mesh.MeshSizeFactor", 2. * factor);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1);
  gmsh::model::mesh::generate(2);
}

/// Throws what Gmsh reports while it runs an action.
void run(GmshSession& session, const std::function<void()>& action,
         const GuardedGeometry& geometry = {}) {
  Errors errors = session.errors_of(action);
  if (errors.empty()) return;
  for (std::string& error : errors) error = with_source(error, geometry);
  throw std::invalid_argument(listed(errors));
}

template <int dim>
MeshData<dim> read_geo(const std::filesystem::path& file, const double circle_tolerance) {
  const GuardedGeometry geometry = guard_geometry(file);
  // Gmsh opens only what this program has written to a place of its own: beside the user's file it
  // would also run "<file>.opt"
  const PrivateDirectory directory;
  for (std::size_t i = 0; i < geometry.meshes.size(); ++i) {
    const std::string content = read_file(geometry.meshes[i]);
    check_msh(content, geometry.meshes[i]);
    (void)directory.write(merged_name(i), content);
  }
  const std::filesystem::path guarded = directory.write("geometry.geo", geometry.text);
  GmshSession session;
  set_quadrilateral_options();
  MeshData<dim> mesh;
  run(
      session, [&] { gmsh::open(guarded.string()); }, geometry);
  run(session, [&] {
    if (!has_cells(dim)) mesh_current_model<dim>();
  });
  run(session, [&] { mesh = named_mesh<dim>(false, circle_tolerance); });
  return mesh;
}

template <int dim>
MeshData<dim> read_msh(const std::filesystem::path& file, const double circle_tolerance) {
  const std::string content = read_file(file);
  check_msh(content, file);
  const PrivateDirectory directory;
  const std::filesystem::path copy = directory.write("mesh.msh", content);
  GmshSession session;
  MeshData<dim> mesh;
  run(session, [&] { gmsh::open(copy.string()); });
  run(session, [&] { mesh = named_mesh<dim>(true, circle_tolerance); });
  return mesh;
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
    throw std::invalid_argument(fmt::format("{}: {}", file.string(), what));
  }
}

}  // namespace

template <int dim>
MeshData<dim> read_geometry(const std::filesystem::path& file, const double length_unit,
                            const double circle_tolerance) {
  if (!(length_unit > 0.) || !std::isfinite(length_unit))
    throw std::invalid_argument(fmt::format("{}: its unit of length is {} m: it must be positive",
                                            file.string(), length_unit));
  const std::string extension = file.extension().string();
  if (extension != ".geo" && extension != ".msh")
    throw std::invalid_argument(
        fmt::format("{}: a geometry must be a .geo or a .msh file", file.string()));
  return naming<dim>(file, [&] {
    MeshData<dim> mesh = extension == ".geo" ? read_geo<dim>(file, circle_tolerance)
                                             : read_msh<dim>(file, circle_tolerance);
    scale(mesh, length_unit);
    check(mesh);
    return mesh;
  });
}

template MeshData<2> read_geometry(const std::filesystem::path&, double, double);
template MeshData<3> read_geometry(const std::filesystem::path&, double, double);

}  // namespace geneva::mesh
