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
#include "mesh/mesh_quality.h"
#include "mesh/onto_circles.h"
#include "mesher/cell_division.h"
#include "mesher/element_blocks.h"
#include "mesher/entity_shape.h"
#include "mesher/gmsh_session.h"
#include "mesher/model_reader.h"
#include "mesher/step_geometry.h"

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

/// @param round the round ones of the boundary's entities
/// @param all_fitted whether the nodes are only near to all of them
/// @return indices of the circles that the nodes are only near to
template <int dim>
std::set<int> label_boundary(ModelLabels& labels, const std::map<int, RoundEntity>& round,
                             const bool all_fitted) {
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
  std::set<int> fitted;
  for (const auto& [dimension, entity] : entities) {
    const auto found = round.find(entity);
    const int circle =
        found == round.end() ? -1 : circle_index(labels.circles, found->second.circle);
    labels.boundary[entity] = {group_of(dim - 1, entity, Kind::boundary_entity, names).value_or(""),
                               circle};
    if (found != round.end() && (all_fitted || found->second.is_fitted)) fitted.insert(circle);
  }
  return fitted;
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

/// Scaled Jacobian of cells that are not pinched.
constexpr double unpinched_quality = 0.1;

template <int dim>
double least_quality(const MeshData<dim>& mesh) {
  double least = 1.;
  for (const mesh::Cell<dim>& cell : mesh.cells)
    least = std::min(least, mesh::scaled_jacobian(mesh, cell));
  return least;
}

/// The mesh with its vertices moved onto some circles; where that pinches cells at a torus, as
/// coarse ones in a hollow, tori stay flat pieces.
template <int dim>
MeshData<dim> on_round_shapes(const MeshData<dim>& mesh, const std::set<int>& circles) {
  MeshData<dim> moved = mesh;
  move_onto_circles(moved, circles);
  const double quality = least_quality(moved);
  if (dim == 2 || quality > unpinched_quality) return moved;
  MeshData<dim> without_tori = mesh;
  if (!flatten_tori(without_tori, circles)) return moved;
  move_onto_circles(without_tori, circles);
  return least_quality(without_tori) > quality ? without_tori : moved;
}

/// The current Gmsh model with its names, after its mesh has been made or read.
template <int dim>
MeshData<dim> named_mesh(const double circle_tolerance) {
  ModelLabels labels;
  label_bodies<dim>(labels);
  const std::map<int, RoundEntity> round = round_entities<dim>(circle_tolerance);
  const bool is_divided = divide_cells<dim>();
  check_bodies(read_model<dim>(labels).mesh);  // before the boundary: shared parts have two names
  const std::set<int> fitted = label_boundary<dim>(labels, round, is_divided);
  const MeshData<dim> mesh = read_model<dim>(labels).mesh;
  check_named_boundary(mesh);
  return on_round_shapes(mesh, fitted);
}

bool has_pyramids() {
  const std::vector<ElementBlock> blocks = element_blocks(3);
  return std::any_of(blocks.begin(), blocks.end(),
                     [](const ElementBlock& block) { return block.corners == 5; });
}

/// Meshes the current model. If triangles remain in the plane: twice as coarse with each cell
/// divided into quadrilaterals. If quadrilaterals in 3-D bound what tetrahedra fill, which takes
/// pyramids: with triangles.
template <int dim>
void mesh_current_model() {
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::model::mesh::generate(dim);
  if (dim == 3 && has_pyramids()) {
    gmsh::model::mesh::clear();
    gmsh::option::setNumber("Mesh.RecombineAll", 0);
    gmsh::model::mesh::generate(3);
  }
  if (dim == 3 || !has_triangles()) return;
  double factor = 1.;
  gmsh::option::getNumber("Mesh.MeshSizeFactor", factor);
  gmsh::model::mesh::clear();
  gmsh::option::setNumber("Mesh.MeshSizeFactor", 2. * factor);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1);
  gmsh::model::mesh::generate(2);
}

/// The mesh of parts that stand in the current model, finer where the cells of a coarser one are
/// pinched between curved faces.
template <int dim>
MeshData<dim> mesh_of_parts(const mesh::GeometryTask& task) {
  constexpr double millimetres = 1e3;  // of a metre
  MeshData<dim> best;
  double best_quality = -1.;
  for (const double factor : {1., 0.8, 0.65, 0.5}) {
    mesh_step_model<dim>(millimetres * task.cell_size, factor);
    MeshData<dim> mesh = named_mesh<dim>(task.circle_tolerance);
    const double quality = least_quality(mesh);
    if (quality > best_quality) {
      best = std::move(mesh);
      best_quality = quality;
    }
    if (best_quality > unpinched_quality) break;
  }
  return best;
}

/// What Gmsh says of some actions, up to the first that goes wrong.
std::vector<std::string> errors_of(GmshSession& session,
                                   const std::vector<std::function<void()>>& actions) {
  for (const auto& action : actions)
    if (auto errors = session.errors_of(action); !errors.empty()) return errors;
  return {};
}

}  // namespace

template <int dim>
Reading<dim> read_geometry(const mesh::GeometryTask& task) {
  const std::filesystem::path file = std::filesystem::path(task.directory) / task.file;
  GmshSession session;
  Reading<dim> reading;
  if (task.kind == mesh::FileKind::step) {
    reading.errors = errors_of(session, {[&] { read_step_model<dim>(task); },
                                         [&] { reading.mesh = mesh_of_parts<dim>(task); }});
    return reading;
  }
  const bool is_geometry = task.kind == mesh::FileKind::geometry;
  if (is_geometry) set_quadrilateral_options();
  reading.errors =
      errors_of(session, {[&] { gmsh::open(file.string()); },
                          [&] {
                            if (is_geometry && !has_cells(dim)) mesh_current_model<dim>();
                          },
                          [&] { reading.mesh = named_mesh<dim>(task.circle_tolerance); }});
  return reading;
}

template Reading<2> read_geometry(const mesh::GeometryTask&);
template Reading<3> read_geometry(const mesh::GeometryTask&);

}  // namespace geneva::mesher
