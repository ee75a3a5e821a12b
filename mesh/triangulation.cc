#include "mesh/triangulation.h"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <memory>
#include <utility>

#include "mesh/graded_manifold.h"
#include "mesh/torus_manifold.h"

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

template <int dim>
FlatMesh flatten(const MeshData<dim>& mesh) {
  FlatMesh flat;
  for (const std::size_t size : {mesh.vertices.size(), mesh.cells.size(), mesh.faces.size(),
                                 mesh.circles.size(), mesh.bodies.size()})
    flat.integers.push_back(static_cast<unsigned int>(size));
  for (const auto& vertex : mesh.vertices)
    flat.reals.insert(flat.reals.end(), vertex.begin(), vertex.end());
  for (const auto& circle : mesh.circles) {
    flat.reals.insert(flat.reals.end(), circle.centre.begin(), circle.centre.end());
    flat.reals.push_back(circle.radius);
    flat.reals.insert(flat.reals.end(), circle.axis.begin(), circle.axis.end());
    flat.reals.push_back(circle.ring_radius);
  }
  for (const auto& cell : mesh.cells) {
    flat.integers.insert(flat.integers.end(), cell.vertices.begin(), cell.vertices.end());
    flat.integers.push_back(cell.body);
  }
  for (const auto& face : mesh.faces) {
    flat.integers.insert(flat.integers.end(), face.vertices.begin(), face.vertices.end());
    flat.integers.push_back(face.surface);
    flat.integers.push_back(static_cast<unsigned int>(face.circle + 1));
  }
  flat.integers.push_back(mesh.grading ? 1 : 0);
  if (mesh.grading)
    flat.reals.insert(flat.reals.end(),
                      {mesh.grading->half_length, mesh.grading->thickness_at_ends});
  flat.names = mesh.bodies;
  flat.names.insert(flat.names.end(), mesh.surfaces.begin(), mesh.surfaces.end());
  return flat;
}

template <int dim>
MeshData<dim> unflatten(const FlatMesh& flat) {
  MeshData<dim> mesh;
  mesh.vertices.resize(flat.integers[0]);
  mesh.cells.resize(flat.integers[1]);
  mesh.faces.resize(flat.integers[2]);
  mesh.circles.resize(flat.integers[3]);
  auto real = flat.reals.begin();
  for (auto& vertex : mesh.vertices)
    for (double& coordinate : vertex) coordinate = *real++;
  for (auto& circle : mesh.circles) {
    for (double& coordinate : circle.centre) coordinate = *real++;
    circle.radius = *real++;
    for (double& component : circle.axis) component = *real++;
    circle.ring_radius = *real++;
  }
  auto integer = flat.integers.begin() + 5;
  for (auto& cell : mesh.cells) {
    for (unsigned int& vertex : cell.vertices) vertex = *integer++;
    cell.body = *integer++;
  }
  for (auto& face : mesh.faces) {
    for (unsigned int& vertex : face.vertices) vertex = *integer++;
    face.surface = *integer++;
    face.circle = static_cast<int>(*integer++) - 1;
  }
  if (*integer++ == 1) mesh.grading = Grading{real[0], real[1]};
  const auto surfaces_begin = flat.names.begin() + flat.integers[4];
  mesh.bodies.assign(flat.names.begin(), surfaces_begin);
  mesh.surfaces.assign(surfaces_begin, flat.names.end());
  return mesh;
}

/// The vertices around a quadrilateral in the order of deal.II, line by line.
template <typename Vertices>
void swap_to_lines(Vertices& vertices) {
  for (std::size_t last = 3; last < vertices.size(); last += 4)
    std::swap(vertices[last - 1], vertices[last]);
}

template <int dim>
std::vector<dealii::CellData<dim>> cell_data(const MeshData<dim>& mesh) {
  std::vector<dealii::CellData<dim>> cells;
  cells.reserve(mesh.cells.size());
  for (const Cell<dim>& cell : mesh.cells) {
    dealii::CellData<dim> data;
    data.vertices.assign(cell.vertices.begin(), cell.vertices.end());
    swap_to_lines(data.vertices);
    data.material_id = cell.body;
    cells.push_back(data);
  }
  dealii::GridTools::consistently_order_cells(cells);
  return cells;
}

template <int dim>
dealii::SubCellData boundary_data(const MeshData<dim>& mesh) {
  dealii::SubCellData boundary;
  for (const Face<dim>& face : mesh.faces) {
    dealii::CellData<dim - 1> data;
    data.vertices.assign(face.vertices.begin(), face.vertices.end());
    swap_to_lines(data.vertices);
    data.boundary_id = face.surface;
    data.manifold_id = face.circle < 0 ? dealii::numbers::flat_manifold_id
                                       : static_cast<dealii::types::manifold_id>(face.circle + 1);
    if constexpr (dim == 2)
      boundary.boundary_lines.push_back(data);
    else
      boundary.boundary_quads.push_back(data);
  }
  return boundary;
}

/// Gives the edges of curved faces in 3-D the manifold of their face.
template <int dim>
void bend_lines(dealii::Triangulation<dim>& triangulation) {
  if constexpr (dim == 3)
    for (const auto& face : triangulation.active_face_iterators())
      if (face->at_boundary() && face->manifold_id() != dealii::numbers::flat_manifold_id)
        face->set_all_manifold_ids(face->manifold_id());
}

/// The circle, cylinder, sphere or torus in the units of the triangulation.
template <int dim>
std::unique_ptr<dealii::Manifold<dim>> manifold(const Circle& circle, const double length) {
  dealii::Point<dim> centre;
  for (unsigned int component = 0; component < dim; ++component)
    centre[component] = circle.centre[component] / length;
  if constexpr (dim == 3) {
    const dealii::Tensor<1, 3> axis({circle.axis[0], circle.axis[1], circle.axis[2]});
    if (circle.ring_radius > 0.)
      return std::make_unique<TorusManifold>(axis, centre, circle.ring_radius / length);
    if (axis.norm() > 0.) return std::make_unique<dealii::CylindricalManifold<3>>(axis, centre);
  }
  return std::make_unique<dealii::SphericalManifold<dim>>(centre);
}

/// Manifold of the flat faces, the straight edges and the interior of graded layers.
constexpr dealii::types::manifold_id straight = 0;

void set_graded_manifolds(dealii::Triangulation<3>& triangulation, const MeshData<3>& mesh,
                          const double length) {
  const Grading grading{mesh.grading->half_length / length, mesh.grading->thickness_at_ends};
  for (unsigned int i = 0; i < mesh.circles.size(); ++i)
    triangulation.set_manifold(i + 1,
                               GradedManifold(manifold<3>(mesh.circles[i], length), grading));
  triangulation.set_manifold(straight,
                             GradedManifold(std::make_unique<dealii::FlatManifold<3>>(), grading));
  const auto is_flat = [](const auto& object) {
    return object->manifold_id() == dealii::numbers::flat_manifold_id;
  };
  for (const auto& cell : triangulation.active_cell_iterators()) {
    cell->set_manifold_id(straight);
    for (const auto& face : cell->face_iterators())
      if (is_flat(face)) face->set_manifold_id(straight);
    for (const unsigned int line : cell->line_indices())
      if (is_flat(cell->line(line))) cell->line(line)->set_manifold_id(straight);
  }
}

}  // namespace

template <int dim>
MeshData<dim> broadcast(const MPI_Comm communicator, const MeshData<dim>& mesh) {
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1) return mesh;
  return unflatten<dim>(dealii::Utilities::MPI::broadcast(communicator, flatten(mesh)));
}

template <int dim>
std::unique_ptr<dealii::parallel::distributed::Triangulation<dim>> make_triangulation(
    const MPI_Comm communicator, const MeshData<dim>& mesh, const double length) {
  std::vector<dealii::Point<dim>> vertices(mesh.vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (unsigned int component = 0; component < dim; ++component)
      vertices[i][component] = mesh.vertices[i][component] / length;
  auto triangulation = std::make_unique<dealii::parallel::distributed::Triangulation<dim>>(
      communicator, dealii::Triangulation<dim>::limit_level_difference_at_vertices,
      dealii::parallel::distributed::Triangulation<dim>::no_automatic_repartitioning);
  for (unsigned int i = 0; i < mesh.circles.size(); ++i)
    triangulation->set_manifold(i + 1, *manifold<dim>(mesh.circles[i], length));
  triangulation->create_triangulation(vertices, cell_data(mesh), boundary_data(mesh));
  bend_lines(*triangulation);
  if constexpr (dim == 3)
    if (mesh.grading) set_graded_manifolds(*triangulation, mesh, length);
  return triangulation;
}

template MeshData<2> broadcast(MPI_Comm, const MeshData<2>&);
template MeshData<3> broadcast(MPI_Comm, const MeshData<3>&);
template std::unique_ptr<dealii::parallel::distributed::Triangulation<2>> make_triangulation(
    MPI_Comm, const MeshData<2>&, double);
template std::unique_ptr<dealii::parallel::distributed::Triangulation<3>> make_triangulation(
    MPI_Comm, const MeshData<3>&, double);

}  // namespace geneva::mesh
