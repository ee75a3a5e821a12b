#include "mesh/mesh_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "mesh/mesh_quality.h"

namespace geneva::mesh {

namespace {

/// Below this scaled Jacobian (1: a rectangle, 0: two sides in one line) results are worthless.
constexpr double least_scaled_jacobian = 0.02;

/// A vertex may stand off the circle that its edge belongs to by this fraction of the radius.
constexpr double circle_tolerance = 1e-6;

constexpr unsigned int no_body = static_cast<unsigned int>(-1);

using VertexPair = std::pair<unsigned int, unsigned int>;

template <typename... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> message, const Values&... values) {
  throw std::invalid_argument("mesh: " + fmt::format(message, values...));
}

VertexPair ordered(unsigned int first, unsigned int second) {
  return {std::min(first, second), std::max(first, second)};
}

void check_vertices(const MeshData<2>& mesh) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const auto& [x, y] = mesh.vertices[i];
    if (!std::isfinite(x) || !std::isfinite(y))
      refuse("vertex {} stands at ({}, {}) m: coordinates must be finite", i, x, y);
  }
}

void check_surfaces(const MeshData<2>& mesh) {
  if (mesh.surfaces.empty() || !mesh.surfaces.front().empty())
    refuse("the first surface must be \"\", which holds the edges without a name");
}

void check_indices(const MeshData<2>& mesh) {
  const auto beyond = [&](unsigned int vertex) { return vertex >= mesh.vertices.size(); };
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const Cell<2>& quad = mesh.cells[i];
    if (std::any_of(quad.vertices.begin(), quad.vertices.end(), beyond))
      refuse("cell {} refers to a vertex beyond the {} that exist", i, mesh.vertices.size());
    if (quad.body >= mesh.bodies.size())
      refuse("cell {} belongs to body {} of {}", i, quad.body, mesh.bodies.size());
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Face<2>& edge = mesh.faces[i];
    if (beyond(edge.vertices[0]) || beyond(edge.vertices[1]))
      refuse("edge {} refers to a vertex beyond the {} that exist", i, mesh.vertices.size());
    if (edge.surface >= mesh.surfaces.size())
      refuse("edge {} belongs to surface {} of {}", i, edge.surface, mesh.surfaces.size());
    if (edge.circle < -1 || edge.circle >= static_cast<int>(mesh.circles.size()))
      refuse("edge {} belongs to circle {} of {}", i, edge.circle, mesh.circles.size());
  }
}

void check_cells(const MeshData<2>& mesh) {
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const double quality = scaled_jacobian(corners(mesh, mesh.cells[i]));
    if (quality > least_scaled_jacobian) continue;
    const auto& [x, y] = mesh.vertices[mesh.cells[i].vertices[0]];
    refuse(
        "cell {} of body \"{}\" near ({:.6g}, {:.6g}) m is degenerate or turned over (scaled "
        "Jacobian {:.3g}, more than {} is needed): use smaller cells there, or move the points "
        "that pinch it",
        i, mesh.bodies[mesh.cells[i].body], x, y, quality, least_scaled_jacobian);
  }
}

void check_boundary(const MeshData<2>& mesh) {
  std::map<VertexPair, int> missing;  // times that a side of a cell has still to be accounted for
  for (const Cell<2>& quad : mesh.cells)
    for (std::size_t i = 0; i < 4; ++i)
      ++missing[ordered(quad.vertices[i], quad.vertices[(i + 1) % 4])];
  const auto place = [&](const VertexPair& side) {
    const auto& a = mesh.vertices[side.first];
    const auto& b = mesh.vertices[side.second];
    return fmt::format("from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m", a[0], a[1], b[0], b[1]);
  };
  for (const auto& [side, cells] : missing)
    if (cells > 2) refuse("{} cells meet at the side {}: at most two may", cells, place(side));
  for (const Face<2>& edge : mesh.faces) {
    const VertexPair side = ordered(edge.vertices[0], edge.vertices[1]);
    const auto found = missing.find(side);
    if (found == missing.end()) refuse("the boundary edge {} is no side of a cell", place(side));
    if (found->second != 1)
      refuse("the edge {} is listed twice or lies inside a body", place(side));
    found->second = 0;
  }
  for (const auto& [side, cells] : missing)
    if (cells == 1) refuse("the boundary edge {} is not listed", place(side));
}

void check_circles(const MeshData<2>& mesh) {
  for (const Face<2>& edge : mesh.faces) {
    if (edge.circle < 0) continue;
    const Circle& circle = mesh.circles[static_cast<std::size_t>(edge.circle)];
    for (const unsigned int vertex : edge.vertices) {
      const auto& [x, y] = mesh.vertices[vertex];
      const double distance = std::hypot(x - circle.centre[0], y - circle.centre[1]);
      if (!(std::abs(distance - circle.radius) <= circle_tolerance * circle.radius))
        refuse("the vertex at ({:.6g}, {:.6g}) m stands {:.3g} m off the circle of its edge", x, y,
               distance - circle.radius);
    }
  }
}

}  // namespace

void check_bodies(const MeshData<2>& mesh) {
  std::vector<unsigned int> body_of(mesh.vertices.size(), no_body);
  std::vector<bool> has_cells(mesh.bodies.size(), false);
  for (const Cell<2>& quad : mesh.cells) {
    has_cells[quad.body] = true;
    for (const unsigned int vertex : quad.vertices) {
      if (body_of[vertex] != no_body && body_of[vertex] != quad.body)
        refuse(
            "bodies \"{}\" and \"{}\" share the vertex at ({:.6g}, {:.6g}) m and would be welded "
            "there: give each body its own points and curves, also where they touch (and no "
            "Coherence)",
            mesh.bodies[body_of[vertex]], mesh.bodies[quad.body], mesh.vertices[vertex][0],
            mesh.vertices[vertex][1]);
      body_of[vertex] = quad.body;
    }
  }
  for (std::size_t i = 0; i < mesh.bodies.size(); ++i)
    if (!has_cells[i]) refuse("body \"{}\" has no cells", mesh.bodies[i]);
  for (std::size_t i = 0; i < body_of.size(); ++i)
    if (body_of[i] == no_body)
      refuse("vertex {} at ({:.6g}, {:.6g}) m belongs to no cell: remove it", i,
             mesh.vertices[i][0], mesh.vertices[i][1]);
}

template <int dim>
std::set<unsigned int> bodies_of(const MeshData<dim>& mesh, const unsigned int surface) {
  std::set<unsigned int> vertices;
  for (const Face<dim>& face : mesh.faces)
    if (face.surface == surface) vertices.insert(face.vertices.begin(), face.vertices.end());
  std::set<unsigned int> bodies;
  for (const Cell<dim>& cell : mesh.cells)
    for (const unsigned int vertex : cell.vertices)
      if (vertices.count(vertex) > 0) bodies.insert(cell.body);
  return bodies;
}

template std::set<unsigned int> bodies_of(const MeshData<2>&, unsigned int);
template std::set<unsigned int> bodies_of(const MeshData<3>&, unsigned int);

void check(const MeshData<2>& mesh) {
  check_surfaces(mesh);
  check_vertices(mesh);
  check_indices(mesh);
  check_bodies(mesh);
  check_cells(mesh);
  check_boundary(mesh);
  check_circles(mesh);
}

}  // namespace geneva::mesh
