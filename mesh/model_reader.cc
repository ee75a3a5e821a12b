#include "mesh/model_reader.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "mesh/mesh_quality.h"

namespace geneva::mesh {

namespace {

// Gmsh's numbers of element types
constexpr int line_type = 1;
constexpr int triangle_type = 2;
constexpr int quad_type = 3;

/// Equal to rounding: coordinates of a file may have been written with ten digits.
constexpr double same_circle = 1e-9;
constexpr double in_plane = 1e-9;

using VertexPair = std::pair<unsigned int, unsigned int>;
using VertexOfTag = std::unordered_map<std::size_t, unsigned int>;

VertexPair ordered(unsigned int first, unsigned int second) {
  return {std::min(first, second), std::max(first, second)};
}

/// Node tags of the elements of one type in one entity.
std::vector<std::size_t> element_nodes(int dimension, int entity, int wanted_type) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
  for (std::size_t i = 0; i < types.size(); ++i)
    if (types[i] == wanted_type) return nodes[i];
  return {};
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

VertexOfTag read_quads(const ModelLabels& labels, TaggedMesh& result) {
  VertexOfTag vertex_of;
  for (std::size_t body = 0; body < labels.bodies.size(); ++body) {
    result.mesh.bodies.push_back(labels.bodies[body].name);
    for (const int surface : labels.bodies[body].surfaces) {
      const std::vector<std::size_t> nodes = element_nodes(2, surface, quad_type);
      for (std::size_t i = 0; i < nodes.size(); i += 4) {
        Cell<2> quad{{}, static_cast<unsigned int>(body)};
        for (std::size_t k = 0; k < 4; ++k) {
          const auto next = static_cast<unsigned int>(result.tags.size());
          const auto [found, is_new] = vertex_of.emplace(nodes[i + k], next);
          if (is_new) result.tags.push_back(nodes[i + k]);
          quad.vertices[k] = found->second;
        }
        result.mesh.cells.push_back(quad);
      }
    }
  }
  return vertex_of;
}

void read_vertices(TaggedMesh& result) {
  const auto place_of = node_places();
  double extent = 0.;
  double off_plane = 0.;
  for (const std::size_t tag : result.tags) {
    const auto found = place_of.find(tag);
    if (found == place_of.end())
      throw std::invalid_argument(fmt::format("a cell refers to node {}, which is missing", tag));
    const auto& [x, y, z] = found->second;
    result.mesh.vertices.push_back({x, y});
    extent = std::max({extent, std::abs(x), std::abs(y)});
    off_plane = std::max(off_plane, std::abs(z));
  }
  if (!(off_plane <= in_plane * extent))
    throw std::invalid_argument(fmt::format(
        "a vertex stands at z = {:.6g}: a plane geometry must lie in the plane z = 0", off_plane));
}

/// Twice the area, negative if clockwise.
double turning(const Corners& c) {
  return (c[2][0] - c[0][0]) * (c[3][1] - c[1][1]) - (c[3][0] - c[1][0]) * (c[2][1] - c[0][1]);
}

void turn_clockwise_quads(MeshData<2>& mesh) {
  for (Cell<2>& quad : mesh.cells)
    if (turning(corners(mesh, quad)) < 0.) std::swap(quad.vertices[1], quad.vertices[3]);
}

unsigned int surface_index(MeshData<2>& mesh, const std::string& name) {
  const auto found = std::find(mesh.surfaces.begin(), mesh.surfaces.end(), name);
  const auto index = static_cast<unsigned int>(found - mesh.surfaces.begin());
  if (found == mesh.surfaces.end()) mesh.surfaces.push_back(name);
  return index;
}

/// Curve of every pair of vertices that a line element of Gmsh joins.
std::map<VertexPair, ModelLabels::Curve> read_lines(const ModelLabels& labels,
                                                    const VertexOfTag& vertex_of) {
  std::map<VertexPair, ModelLabels::Curve> curve_of;
  for (const auto& [tag, curve] : labels.curves) {
    const std::vector<std::size_t> nodes = element_nodes(1, tag, line_type);
    for (std::size_t i = 0; i < nodes.size(); i += 2) {
      const auto first = vertex_of.find(nodes[i]);
      const auto second = vertex_of.find(nodes[i + 1]);
      if (first == vertex_of.end() || second == vertex_of.end()) continue;
      curve_of[ordered(first->second, second->second)] = curve;
    }
  }
  return curve_of;
}

void add_edges(const std::map<VertexPair, ModelLabels::Curve>& curve_of, MeshData<2>& mesh) {
  std::map<VertexPair, int> cells;
  for (const Cell<2>& quad : mesh.cells)
    for (std::size_t i = 0; i < 4; ++i)
      ++cells[ordered(quad.vertices[i], quad.vertices[(i + 1) % 4])];
  for (const Cell<2>& quad : mesh.cells) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::array<unsigned int, 2> side{quad.vertices[i], quad.vertices[(i + 1) % 4]};
      const VertexPair pair = ordered(side[0], side[1]);
      if (cells.at(pair) != 1) continue;
      const auto curve = curve_of.find(pair);
      if (curve == curve_of.end())
        mesh.faces.push_back({side, 0, -1});
      else
        mesh.faces.push_back(
            {side, surface_index(mesh, curve->second.surface), curve->second.circle});
    }
  }
}

}  // namespace

int circle_index(std::vector<Circle>& circles, const Circle& circle) {
  const double allowed = same_circle * circle.radius;
  const auto same = [&](const Circle& other) {
    return std::abs(other.centre[0] - circle.centre[0]) <= allowed &&
           std::abs(other.centre[1] - circle.centre[1]) <= allowed &&
           std::abs(other.radius - circle.radius) <= allowed;
  };
  const auto found = std::find_if(circles.begin(), circles.end(), same);
  const auto index = static_cast<int>(found - circles.begin());
  if (found == circles.end()) circles.push_back(circle);
  return index;
}

OtherCells count_other_cells() {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, 2);
  OtherCells counts;
  for (std::size_t i = 0; i < types.size(); ++i) {
    std::string name;
    int dimension = 0;
    int order = 0;
    int vertices = 0;
    int primary_vertices = 0;
    std::vector<double> places;
    gmsh::model::mesh::getElementProperties(types[i], name, dimension, order, vertices, places,
                                            primary_vertices);
    if (order > 1)
      counts.of_higher_order += elements[i].size();
    else if (types[i] == triangle_type)
      counts.triangles += elements[i].size();
    else if (types[i] != quad_type)
      counts.others += elements[i].size();
  }
  return counts;
}

TaggedMesh read_model(const ModelLabels& labels) {
  TaggedMesh result;
  result.mesh.surfaces.emplace_back();
  for (const std::string& name : labels.surfaces) surface_index(result.mesh, name);
  result.mesh.circles = labels.circles;
  const VertexOfTag vertex_of = read_quads(labels, result);
  read_vertices(result);
  turn_clockwise_quads(result.mesh);
  add_edges(read_lines(labels, vertex_of), result.mesh);
  return result;
}

}  // namespace geneva::mesh
