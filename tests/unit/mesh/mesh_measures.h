#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "mesh/mesh_data.h"

namespace geneva::mesh::test {

inline double cross(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Area of a body: of its straight-sided cells, and between its boundary edges and their circles.
inline double area(const MeshData<2>& mesh, unsigned int body) {
  double sum = 0.;
  std::set<unsigned int> vertices;
  for (const Cell<2>& quad : mesh.cells) {
    if (quad.body != body) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      vertices.insert(quad.vertices[i]);
      sum += cross(mesh.vertices[quad.vertices[i]], mesh.vertices[quad.vertices[(i + 1) % 4]]) / 2.;
    }
  }
  for (const Face<2>& edge : mesh.faces) {
    if (edge.circle < 0 || vertices.count(edge.vertices[0]) == 0) continue;
    const Circle& circle = mesh.circles[static_cast<std::size_t>(edge.circle)];
    const auto& p = mesh.vertices[edge.vertices[0]];
    const auto& q = mesh.vertices[edge.vertices[1]];
    const std::array<double, 2> a{p[0] - circle.centre[0], p[1] - circle.centre[1]};
    const std::array<double, 2> b{q[0] - circle.centre[0], q[1] - circle.centre[1]};
    const double angle = std::atan2(cross(a, b), a[0] * b[0] + a[1] * b[1]);
    sum += circle.radius * circle.radius * (angle - std::sin(angle)) / 2.;
  }
  return sum;
}

inline std::map<std::string, int> edges_by_surface(const MeshData<2>& mesh) {
  std::map<std::string, int> edges;
  for (const Face<2>& edge : mesh.faces) ++edges[mesh.surfaces[edge.surface]];
  return edges;
}

/// Whether a body has a vertex at a place, to the last bit.
inline bool has_vertex(const MeshData<2>& mesh, unsigned int body,
                       const std::array<double, 2>& place) {
  return std::any_of(mesh.cells.begin(), mesh.cells.end(), [&](const Cell<2>& quad) {
    return quad.body == body &&
           std::any_of(quad.vertices.begin(), quad.vertices.end(),
                       [&](unsigned int v) { return mesh.vertices[v] == place; });
  });
}

}  // namespace geneva::mesh::test
