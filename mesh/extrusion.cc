#include "mesh/extrusion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace geneva::mesh {

namespace {

void check(const MeshData<2>& plane, const std::vector<Extrusion>& bodies) {
  if (bodies.size() != plane.bodies.size())
    throw base::InputError(fmt::format("extrusion: {} bodies are given, the plane mesh has {}",
                                       bodies.size(), plane.bodies.size()));
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const std::vector<double>& z = bodies[body].planes;
    const bool ascends = std::adjacent_find(z.begin(), z.end(), [](double below, double above) {
                           return !(below < above) || !std::isfinite(below + above);
                         }) == z.end();
    if (z.size() < 2 || !ascends)
      throw base::InputError(
          fmt::format("extrusion: body '{}' has {} planes: two or more are wanted, each above the "
                      "one before",
                      plane.bodies[body], z.size()));
  }
}

unsigned int surface_index(MeshData<3>& mesh, const std::string& name) {
  const auto found = std::find(mesh.surfaces.begin(), mesh.surfaces.end(), name);
  const auto index = static_cast<unsigned int>(found - mesh.surfaces.begin());
  if (found == mesh.surfaces.end()) mesh.surfaces.push_back(name);
  return index;
}

std::vector<unsigned int> body_of_vertex(const MeshData<2>& plane) {
  std::vector<unsigned int> body(plane.vertices.size());
  for (const Cell<2>& cell : plane.cells)
    for (const unsigned int vertex : cell.vertices) body[vertex] = cell.body;
  return body;
}

/// Where the vertices over each plane vertex begin: they stand one after the other.
std::vector<unsigned int> add_vertices(const MeshData<2>& plane,
                                       const std::vector<Extrusion>& bodies, MeshData<3>& mesh) {
  const std::vector<unsigned int> body = body_of_vertex(plane);
  std::vector<unsigned int> first;
  first.reserve(plane.vertices.size());
  for (std::size_t i = 0; i < plane.vertices.size(); ++i) {
    first.push_back(static_cast<unsigned int>(mesh.vertices.size()));
    for (const double z : bodies[body[i]].planes)
      mesh.vertices.push_back({plane.vertices[i][0], plane.vertices[i][1], z});
  }
  return first;
}

void add_column(const Cell<2>& quad, const Extrusion& extrusion,
                const std::vector<unsigned int>& first, MeshData<3>& mesh) {
  const auto& [a, b, c, d] = quad.vertices;
  const auto layers = static_cast<unsigned int>(extrusion.planes.size()) - 1;
  for (unsigned int k = 0; k < layers; ++k)
    mesh.cells.push_back({{first[a] + k, first[b] + k, first[c] + k, first[d] + k, first[a] + k + 1,
                           first[b] + k + 1, first[c] + k + 1, first[d] + k + 1},
                          quad.body});
  mesh.faces.push_back(
      {{first[a], first[b], first[c], first[d]}, surface_index(mesh, extrusion.lower_end), -1});
  mesh.faces.push_back(
      {{first[a] + layers, first[b] + layers, first[c] + layers, first[d] + layers},
       surface_index(mesh, extrusion.upper_end),
       -1});
}

void add_strip(const Face<2>& edge, const std::size_t layers,
               const std::vector<unsigned int>& first, MeshData<3>& mesh) {
  const unsigned int start = first[edge.vertices[0]];
  const unsigned int end = first[edge.vertices[1]];
  for (unsigned int k = 0; k < layers; ++k)
    mesh.faces.push_back(
        {{start + k, end + k, end + k + 1, start + k + 1}, edge.surface, edge.circle});
}

}  // namespace

MeshData<3> extruded(const MeshData<2>& plane, const std::vector<Extrusion>& bodies,
                     const std::optional<Grading>& grading) {
  check(plane, bodies);
  MeshData<3> mesh;
  mesh.circles = plane.circles;
  mesh.bodies = plane.bodies;
  mesh.surfaces = plane.surfaces;
  mesh.grading = grading;
  const std::vector<unsigned int> first = add_vertices(plane, bodies, mesh);
  for (const Cell<2>& quad : plane.cells) add_column(quad, bodies[quad.body], first, mesh);
  const std::vector<unsigned int> body = body_of_vertex(plane);
  for (const Face<2>& edge : plane.faces)
    add_strip(edge, bodies[body[edge.vertices[0]]].planes.size() - 1, first, mesh);
  return mesh;
}

}  // namespace geneva::mesh
