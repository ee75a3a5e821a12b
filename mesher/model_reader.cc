#include "mesher/model_reader.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "base/errors.h"
#include "mesh/mesh_quality.h"

namespace geneva::mesher {

using mesh::Cell;
using mesh::Corners;
using mesh::Face;

namespace {

/// Equal to rounding: coordinates of a file may have been written with ten digits.
constexpr double same_circle = 1e-9;
constexpr double in_plane = 1e-9;

template <int dim>
constexpr int cell_type = dim == 2 ? quad_type : hexahedron_type;
template <int dim>
constexpr int face_type = dim == 2 ? line_type : quad_type;

template <int dim>
using Side = std::array<unsigned int, 1U << (dim - 1)>;
/// The same by Gmsh's tags of its nodes, in ascending order.
template <int dim>
using SideTags = std::array<std::size_t, 1U << (dim - 1)>;

/// The same for all orders of the vertices.
template <typename Corners>
Corners sorted(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Coordinates x, y, z of all nodes, by tag.
std::unordered_map<std::size_t, std::array<double, 3>> node_places() {
  std::vector<std::size_t> tags;
  std::vector<double> places;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, places, parameters);
  std::unordered_map<std::size_t, std::array<double, 3>> place_of;
  place_of.reserve(tags.size());
  for (std::size_t i = 0; i < tags.size(); ++i)
    place_of[tags[i]] = {places[3 * i], places[3 * i + 1], places[3 * i + 2]};
  return place_of;
}

/// Every body gets vertices of its own, also where Gmsh has given it a node of another body's.
template <int dim>
void read_cells(const ModelLabels& labels, TaggedMesh<dim>& result) {
  for (std::size_t body = 0; body < labels.bodies.size(); ++body) {
    std::unordered_map<std::size_t, unsigned int> vertex_of;
    result.mesh.bodies.push_back(labels.bodies[body].name);
    for (const int entity : labels.bodies[body].entities) {
      const std::vector<std::size_t> nodes = element_nodes(dim, entity, cell_type<dim>);
      Cell<dim> cell{{}, static_cast<unsigned int>(body)};
      for (std::size_t i = 0; i < nodes.size(); i += cell.vertices.size()) {
        for (std::size_t k = 0; k < cell.vertices.size(); ++k) {
          const auto next = static_cast<unsigned int>(result.tags.size());
          const auto [found, is_new] = vertex_of.emplace(nodes[i + k], next);
          if (is_new) result.tags.push_back(nodes[i + k]);
          cell.vertices[k] = found->second;
        }
        result.mesh.cells.push_back(cell);
      }
    }
  }
}

template <int dim>
void read_vertices(TaggedMesh<dim>& result) {
  const auto place_of = node_places();
  double extent = 0.;
  double off_plane = 0.;
  for (const std::size_t tag : result.tags) {
    const auto found = place_of.find(tag);
    if (found == place_of.end())
      throw base::InputError(fmt::format("a cell refers to node {}, which is missing", tag));
    std::array<double, static_cast<std::size_t>(dim)> vertex{};
    std::copy_n(found->second.begin(), vertex.size(), vertex.begin());
    result.mesh.vertices.push_back(vertex);
    extent = std::max({extent, std::abs(vertex[0]), std::abs(vertex[1])});
    off_plane = std::max(off_plane, std::abs(found->second[2]));
  }
  if (dim == 2 && !(off_plane <= in_plane * extent))
    throw base::InputError(
        fmt::format("a vertex stands at z = {:.6g}: a plane geometry must lie in the plane z = 0; "
                    "'set Dimension = 3' reads one in 3-D",
                    off_plane));
}

/// Twice the area, negative if clockwise.
double turning(const Corners& c) {
  return (c[2][0] - c[0][0]) * (c[3][1] - c[1][1]) - (c[3][0] - c[1][0]) * (c[2][1] - c[0][1]);
}

void turn_cells(MeshData<2>& mesh) {
  for (Cell<2>& quad : mesh.cells)
    if (turning(corners(mesh, quad)) < 0.) std::swap(quad.vertices[1], quad.vertices[3]);
}

/// A hexahedron that is inside out has its lower and upper four vertices exchanged.
void turn_cells(MeshData<3>& mesh) {
  for (Cell<3>& cell : mesh.cells) {
    Cell<3> turned = cell;
    std::rotate(turned.vertices.begin(), turned.vertices.begin() + 4, turned.vertices.end());
    if (scaled_jacobian(mesh, turned) > scaled_jacobian(mesh, cell)) cell = turned;
  }
}

template <int dim>
unsigned int surface_index(MeshData<dim>& mesh, const std::string& name) {
  const auto found = std::find(mesh.surfaces.begin(), mesh.surfaces.end(), name);
  const auto index = static_cast<unsigned int>(found - mesh.surfaces.begin());
  if (found == mesh.surfaces.end()) mesh.surfaces.push_back(name);
  return index;
}

/// Part of the boundary of every face that an element of Gmsh stands for.
template <int dim>
std::map<SideTags<dim>, ModelLabels::BoundaryPart> read_faces(const ModelLabels& labels) {
  std::map<SideTags<dim>, ModelLabels::BoundaryPart> part_of;
  for (const auto& [tag, part] : labels.boundary) {
    const std::vector<std::size_t> nodes = element_nodes(dim - 1, tag, face_type<dim>);
    SideTags<dim> side{};
    for (std::size_t i = 0; i < nodes.size(); i += side.size()) {
      std::copy_n(nodes.begin() + static_cast<std::ptrdiff_t>(i), side.size(), side.begin());
      part_of[sorted(side)] = part;
    }
  }
  return part_of;
}

/// What is wrong with two bodies that have a face in common; of one face two bodies would need two
/// names, and Gmsh has one.
template <int dim>
[[noreturn]] void refuse_common_face(const MeshData<dim>& mesh, const Side<dim>& side,
                                     const unsigned int body, const unsigned int other) {
  std::array<double, 3> place{};
  for (const unsigned int vertex : side)
    for (std::size_t i = 0; i < static_cast<std::size_t>(dim); ++i)
      place[i] += mesh.vertices[vertex][i] / static_cast<double>(side.size());
  throw base::InputError(fmt::format(
      "bodies \"{}\" and \"{}\" share the {} around ({:.6g}, {:.6g}, {:.6g}) and would be welded "
      "there: give each body its own points, curves and surfaces, also where they touch (no "
      "Coherence; Gmsh's built-in Extrude and Translate make one of what coincides: draw the "
      "bodies apart, then Geometry.AutoCoherence = 0; and Translate them together, or draw with "
      "SetFactory(\"OpenCASCADE\"))",
      mesh.bodies[body], mesh.bodies[other], dim == 2 ? "edge" : "face", place[0], place[1],
      place[2]));
}

/// @throws base::InputError if two bodies have a face in common
template <int dim>
void add_faces(const std::map<SideTags<dim>, ModelLabels::BoundaryPart>& part_of,
               TaggedMesh<dim>& result) {
  MeshData<dim>& mesh = result.mesh;
  std::map<Side<dim>, int> cells;
  for (const Cell<dim>& cell : mesh.cells)
    for (const Side<dim>& side : sides(cell)) ++cells[sorted(side)];
  std::map<SideTags<dim>, unsigned int> body_of;
  for (const Cell<dim>& cell : mesh.cells)
    for (const Side<dim>& side : sides(cell)) {
      if (cells.at(sorted(side)) != 1) continue;
      SideTags<dim> tags{};
      std::transform(side.begin(), side.end(), tags.begin(),
                     [&](const unsigned int vertex) { return result.tags[vertex]; });
      const auto [other, is_new] = body_of.emplace(sorted(tags), cell.body);
      if (!is_new) refuse_common_face(mesh, side, other->second, cell.body);
      const auto part = part_of.find(sorted(tags));
      if (part == part_of.end())
        mesh.faces.push_back({side, 0, -1});
      else
        mesh.faces.push_back(
            {side, surface_index(mesh, part->second.surface), part->second.circle});
    }
}

}  // namespace

std::vector<std::size_t> element_nodes(const int dimension, const int entity, const int type) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
  for (std::size_t i = 0; i < types.size(); ++i)
    if (types[i] == type) return nodes[i];
  return {};
}

int circle_index(std::vector<Circle>& circles, const Circle& circle) {
  const auto near = [](const std::array<double, 3>& a, const std::array<double, 3>& b,
                       const double scale) {
    return std::equal(a.begin(), a.end(), b.begin(), [&](const double x, const double y) {
      return std::abs(x - y) <= same_circle * scale;
    });
  };
  const auto same = [&](const Circle& other) {
    // Rounding may decide which way an axis points.
    const std::array<double, 3> turned{-circle.axis[0], -circle.axis[1], -circle.axis[2]};
    return near(other.centre, circle.centre, circle.radius) &&
           (near(other.axis, circle.axis, 1.) || near(other.axis, turned, 1.)) &&
           std::abs(other.radius - circle.radius) <= same_circle * circle.radius &&
           std::abs(other.ring_radius - circle.ring_radius) <= same_circle * circle.radius;
  };
  const auto found = std::find_if(circles.begin(), circles.end(), same);
  const auto index = static_cast<int>(found - circles.begin());
  if (found == circles.end()) circles.push_back(circle);
  return index;
}

template <int dim>
TaggedMesh<dim> read_model(const ModelLabels& labels) {
  TaggedMesh<dim> result;
  result.mesh.surfaces.emplace_back();
  for (const std::string& name : labels.surfaces) surface_index(result.mesh, name);
  result.mesh.circles = labels.circles;
  read_cells(labels, result);
  read_vertices(result);
  turn_cells(result.mesh);
  add_faces(read_faces<dim>(labels), result);
  return result;
}

template TaggedMesh<2> read_model(const ModelLabels&);
template TaggedMesh<3> read_model(const ModelLabels&);

}  // namespace geneva::mesher
