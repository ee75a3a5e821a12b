#include "mesh/triangulation.h"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

namespace geneva::mesh {

namespace {

/// A mesh as flat vectors, which is what travels between ranks.
struct FlatMesh {
  std::vector<double> reals;
  std::vector<unsigned int> integers;
  std::vector<std::string> names;

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int) {
    archive& reals& integers& names;
  }
};

FlatMesh flatten(const MeshData& mesh) {
  FlatMesh flat;
  for (const std::size_t size : {mesh.vertices.size(), mesh.quads.size(), mesh.edges.size(),
                                 mesh.circles.size(), mesh.bodies.size()})
    flat.integers.push_back(static_cast<unsigned int>(size));
  for (const auto& vertex : mesh.vertices)
    flat.reals.insert(flat.reals.end(), vertex.begin(), vertex.end());
  for (const auto& circle : mesh.circles) {
    flat.reals.insert(flat.reals.end(), circle.centre.begin(), circle.centre.end());
    flat.reals.push_back(circle.radius);
  }
  for (const auto& quad : mesh.quads) {
    flat.integers.insert(flat.integers.end(), quad.vertices.begin(), quad.vertices.end());
    flat.integers.push_back(quad.body);
  }
  for (const auto& edge : mesh.edges) {
    flat.integers.insert(flat.integers.end(), edge.vertices.begin(), edge.vertices.end());
    flat.integers.push_back(edge.surface);
    flat.integers.push_back(static_cast<unsigned int>(edge.circle + 1));
  }
  flat.names = mesh.bodies;
  flat.names.insert(flat.names.end(), mesh.surfaces.begin(), mesh.surfaces.end());
  return flat;
}

MeshData unflatten(const FlatMesh& flat) {
  MeshData mesh;
  mesh.vertices.resize(flat.integers[0]);
  mesh.quads.resize(flat.integers[1]);
  mesh.edges.resize(flat.integers[2]);
  mesh.circles.resize(flat.integers[3]);
  auto real = flat.reals.begin();
  for (auto& vertex : mesh.vertices)
    for (double& coordinate : vertex) coordinate = *real++;
  for (auto& circle : mesh.circles) {
    for (double& coordinate : circle.centre) coordinate = *real++;
    circle.radius = *real++;
  }
  auto integer = flat.integers.begin() + 5;
  for (auto& quad : mesh.quads) {
    for (unsigned int& vertex : quad.vertices) vertex = *integer++;
    quad.body = *integer++;
  }
  for (auto& edge : mesh.edges) {
    for (unsigned int& vertex : edge.vertices) vertex = *integer++;
    edge.surface = *integer++;
    edge.circle = static_cast<int>(*integer++) - 1;
  }
  const auto surfaces_begin = flat.names.begin() + flat.integers[4];
  mesh.bodies.assign(flat.names.begin(), surfaces_begin);
  mesh.surfaces.assign(surfaces_begin, flat.names.end());
  return mesh;
}

}  // namespace

MeshData broadcast(MPI_Comm communicator, const MeshData& mesh) {
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1) return mesh;
  return unflatten(dealii::Utilities::MPI::broadcast(communicator, flatten(mesh)));
}

std::unique_ptr<dealii::parallel::distributed::Triangulation<2>> make_triangulation(
    MPI_Comm communicator, const MeshData& mesh, const double length) {
  std::vector<dealii::Point<2>> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const auto& [x, y] : mesh.vertices) vertices.emplace_back(x / length, y / length);

  std::vector<dealii::CellData<2>> cells;
  cells.reserve(mesh.quads.size());
  for (const auto& quad : mesh.quads) {
    dealii::CellData<2> cell;
    const auto& [a, b, c, d] = quad.vertices;
    cell.vertices = {a, b, d, c};  // deal.II counts a cell's vertices line by line
    cell.material_id = quad.body;
    cells.push_back(cell);
  }

  dealii::SubCellData boundary;
  for (const auto& edge : mesh.edges) {
    dealii::CellData<1> line;
    line.vertices = {edge.vertices[0], edge.vertices[1]};
    line.boundary_id = edge.surface;
    line.manifold_id = edge.circle < 0 ? dealii::numbers::flat_manifold_id
                                       : static_cast<dealii::types::manifold_id>(edge.circle + 1);
    boundary.boundary_lines.push_back(line);
  }

  auto triangulation = std::make_unique<dealii::parallel::distributed::Triangulation<2>>(
      communicator, dealii::Triangulation<2>::limit_level_difference_at_vertices);
  for (unsigned int i = 0; i < mesh.circles.size(); ++i) {
    const auto& [x, y] = mesh.circles[i].centre;
    triangulation->set_manifold(
        i + 1, dealii::SphericalManifold<2>(dealii::Point<2>(x / length, y / length)));
  }
  dealii::GridTools::consistently_order_cells(cells);
  triangulation->create_triangulation(vertices, cells, boundary);
  return triangulation;
}

}  // namespace geneva::mesh
