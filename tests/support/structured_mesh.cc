#include "tests/support/structured_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace geneva::test {

namespace {

using mesh::MeshData;

/// Index of a surface name, which is added if it is new.
unsigned int named(MeshData<2>& mesh, const std::string& surface) {
  const auto found = std::find(mesh.surfaces.begin(), mesh.surfaces.end(), surface);
  if (found != mesh.surfaces.end()) return static_cast<unsigned int>(found - mesh.surfaces.begin());
  mesh.surfaces.push_back(surface);
  return static_cast<unsigned int>(mesh.surfaces.size() - 1);
}

/// A grid of cells with its numbers of nodes along either direction.
struct Grid {
  unsigned int first;    ///< first vertex
  unsigned int columns;  ///< nodes along the first direction
  unsigned int rows;
  bool wraps;  ///< the last column is joined to the first

  [[nodiscard]] unsigned int cells() const { return wraps ? columns : columns - 1; }
  [[nodiscard]] unsigned int node(const unsigned int column, const unsigned int row) const {
    return first + row * columns + (column == columns ? 0 : column);
  }
};

void add_cells(MeshData<2>& mesh, const Grid& grid, const std::string& body) {
  const auto index = static_cast<unsigned int>(mesh.bodies.size());
  mesh.bodies.push_back(body);
  for (unsigned int row = 0; row + 1 < grid.rows; ++row)
    for (unsigned int column = 0; column < grid.cells(); ++column)
      mesh.cells.push_back({{grid.node(column, row), grid.node(column + 1, row),
                             grid.node(column + 1, row + 1), grid.node(column, row + 1)},
                            index});
}

void add_row_edges(MeshData<2>& mesh, const Grid& grid, const unsigned int row,
                   const std::string& surface, const int circle) {
  const unsigned int id = named(mesh, surface);
  for (unsigned int column = 0; column < grid.cells(); ++column)
    mesh.faces.push_back({{grid.node(column, row), grid.node(column + 1, row)}, id, circle});
}

void add_column_edges(MeshData<2>& mesh, const Grid& grid, const unsigned int column,
                      const std::string& surface) {
  const unsigned int id = named(mesh, surface);
  for (unsigned int row = 0; row + 1 < grid.rows; ++row)
    mesh.faces.push_back({{grid.node(column, row), grid.node(column, row + 1)}, id, -1});
}

int add_circle(MeshData<2>& mesh, const std::array<double, 2>& centre, const double radius) {
  mesh.circles.push_back({{centre[0], centre[1]}, radius});
  return static_cast<int>(mesh.circles.size()) - 1;
}

}  // namespace

std::vector<double> equal_steps(const double begin, const double end, const unsigned int n) {
  std::vector<double> values;
  for (unsigned int i = 0; i <= n; ++i) values.push_back(begin + (end - begin) * i / n);
  return values;
}

MeshData<2> empty_mesh() {
  MeshData<2> mesh;
  mesh.surfaces = {""};
  return mesh;
}

void add_rectangle(MeshData<2>& mesh, const std::string& body, const std::vector<double>& x,
                   const std::vector<double>& y, const RectangleSides& sides) {
  const Grid grid{static_cast<unsigned int>(mesh.vertices.size()),
                  static_cast<unsigned int>(x.size()), static_cast<unsigned int>(y.size()), false};
  for (const double row : y)
    for (const double column : x) mesh.vertices.push_back({column, row});
  add_cells(mesh, grid, body);
  add_row_edges(mesh, grid, 0, sides.bottom, -1);
  add_row_edges(mesh, grid, grid.rows - 1, sides.top, -1);
  add_column_edges(mesh, grid, 0, sides.left);
  add_column_edges(mesh, grid, grid.columns - 1, sides.right);
}

void add_ring(MeshData<2>& mesh, const std::string& body, const Ring& ring) {
  const double span = ring.angles.back() - ring.angles.front();
  const bool closed = std::abs(span - 2. * std::acos(-1.)) < 1e-9;
  const std::size_t rays = ring.angles.size() - (closed ? 1 : 0);
  // Angles run clockwise along a row of the grid, so that cells come out counter-clockwise.
  const Grid grid{static_cast<unsigned int>(mesh.vertices.size()), static_cast<unsigned int>(rays),
                  static_cast<unsigned int>(ring.radii.size()), closed};
  for (const double radius : ring.radii)
    for (std::size_t i = 0; i < rays; ++i) {
      const double angle = ring.angles[rays - 1 - i];
      mesh.vertices.push_back(
          {ring.centre[0] + radius * std::cos(angle), ring.centre[1] + radius * std::sin(angle)});
    }
  add_cells(mesh, grid, body);
  add_row_edges(mesh, grid, 0, ring.inner, add_circle(mesh, ring.centre, ring.radii.front()));
  add_row_edges(mesh, grid, grid.rows - 1, ring.outer,
                add_circle(mesh, ring.centre, ring.radii.back()));
  if (closed) return;
  add_column_edges(mesh, grid, 0, ring.last_end);
  add_column_edges(mesh, grid, grid.columns - 1, ring.first_end);
}

MeshData<2> mirrored(MeshData<2> mesh) {
  for (auto& vertex : mesh.vertices) vertex[0] = -vertex[0];
  for (auto& circle : mesh.circles) circle.centre[0] = -circle.centre[0];
  for (auto& quad : mesh.cells) std::reverse(quad.vertices.begin(), quad.vertices.end());
  return mesh;
}

MeshData<2> enlarged(MeshData<2> mesh, const double factor) {
  for (auto& vertex : mesh.vertices)
    for (double& coordinate : vertex) coordinate *= factor;
  for (auto& circle : mesh.circles) {
    for (double& coordinate : circle.centre) coordinate *= factor;
    circle.radius *= factor;
  }
  return mesh;
}

unsigned int surface_id(const MeshData<2>& mesh, const std::string& name) {
  const auto found = std::find(mesh.surfaces.begin(), mesh.surfaces.end(), name);
  if (found == mesh.surfaces.end()) throw std::out_of_range("no surface '" + name + "'");
  return static_cast<unsigned int>(found - mesh.surfaces.begin());
}

}  // namespace geneva::test
