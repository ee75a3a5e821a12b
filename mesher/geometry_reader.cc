#include "mesher/geometry_reader.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/errors.h"
#include "mesh/onto_circles.h"
#include "mesher/entity_shape.h"
#include "mesher/gmsh_session.h"
#include "mesher/model_reader.h"

namespace geneva::mesher {

namespace {

using mesh::Face;

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
      throw base::InputError(fmt::format(
          "{0} {1} has no name: write {0}(\"name\", {1}), supports and loads go by names", kind,
          tag));
    if (!seen.insert(name).second)
      throw base::InputError(fmt::format(
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
    throw base::InputError(
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
    throw base::InputError("there are volumes: 'set Dimension = 3' reads them");
  const std::map<int, std::string> names = group_names(dim, Kind::body);
  if (names.empty())
    throw base::InputError(fmt::format(
        "there is no {}: write {}(\"name\") = {{...}}; for each body{}", Kind::body_group,
        Kind::body, dim == 3 ? "; for a plane geometry 'set Dimension = 2'" : ""));
  for (const auto& [tag, name] : names) labels.bodies.push_back({name, {}});
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dim);
  for (const auto& [dimension, entity] : entities) {
    const std::optional<std::string> name = group_of(dim, entity, Kind::body_entity, names);
    if (!name && has_cells(dim, entity))
      throw base::InputError(
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
    throw base::InputError(
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
    throw base::InputError(
        fmt::format("{} cells are of order 2 or higher: linear {} only; set Mesh.ElementOrder = 1 "
                    "(curved boundaries are followed while refining)",
                    cells.of_higher_order, Kinds<dim>::cells));
  if (cells.simplices + cells.others > 0)
    throw base::InputError(
        fmt::format("{} cells are {}: linear {} only; {}", cells.simplices + cells.others,
                    dim == 2 ? "triangles or polygons" : "tetrahedra, prisms or pyramids",
                    Kinds<dim>::cells, advice_on_cells<dim>(is_mesh_file)));
}

template <int dim>
void check_named_boundary(const MeshData<dim>& mesh) {
  for (std::size_t i = 1; i < mesh.surfaces.size(); ++i)
    if (std::none_of(mesh.faces.begin(), mesh.faces.end(),
                     [&](const Face<dim>& face) { return face.surface == i; }))
      throw base::InputError(
          fmt::format("the {} \"{}\" holds no {} of a body's boundary: list the {}s that bound its "
                      "{}",
                      Kinds<dim>::boundary_group, mesh.surfaces[i], dim == 2 ? "edge" : "face",
                      Kinds<dim>::boundary_entity, Kinds<dim>::body_entity));
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

}  // namespace

template <int dim>
Reading<dim> read_geometry(const mesh::GeometryTask& task) {
  const std::filesystem::path file = std::filesystem::path(task.directory) / task.file;
  GmshSession session;
  if (!task.is_mesh) set_quadrilateral_options();
  Reading<dim> reading;
  const auto went_well = [&](const std::function<void()>& action) {
    reading.errors = session.errors_of(action);
    return reading.errors.empty();
  };
  const auto mesh_it = [&] {
    if (!task.is_mesh && !has_cells(dim)) mesh_current_model<dim>();
  };
  const auto name_it = [&] { reading.mesh = named_mesh<dim>(task.is_mesh, task.circle_tolerance); };
  (void)(went_well([&] { gmsh::open(file.string()); }) && went_well(mesh_it) && went_well(name_it));
  return reading;
}

template Reading<2> read_geometry(const mesh::GeometryTask&);
template Reading<3> read_geometry(const mesh::GeometryTask&);

}  // namespace geneva::mesher
