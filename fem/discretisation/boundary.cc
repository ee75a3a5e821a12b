#include "fem/discretisation/boundary.h"

#include <deal.II/fe/fe.h>

#include <algorithm>
#include <map>

#include "fem/discretisation/gather.h"

namespace geneva::fem {

namespace {

using dealii::types::global_dof_index;

/// Vertices of a face.
template <int dim>
constexpr std::size_t n_ends = 1U << (dim - 1);

/// One face as it travels between the ranks.
template <int dim>
struct FaceRecord {
  std::array<global_dof_index, dim * n_ends<dim>> dofs;
  std::array<double, dim * n_ends<dim>> coordinates;
  unsigned int surface;
  unsigned int body;
  int circle;
};

/// A face's vertices in the cell: counter-clockwise around the cell, in 3-D as seen from outside.
template <int dim>
std::array<unsigned int, n_ends<dim>> ends_of(
    const typename dealii::DoFHandler<dim>::active_cell_iterator& cell, const unsigned int face) {
  using Info = dealii::GeometryInfo<dim>;
  if constexpr (dim == 2) {
    // deal.II runs along opposite sides of a cell in the same direction: sides 1 and 2 are
    // counter-clockwise.
    const bool counter_clockwise = face == 1 || face == 2;
    return {Info::face_to_cell_vertices(face, counter_clockwise ? 0 : 1),
            Info::face_to_cell_vertices(face, counter_clockwise ? 1 : 0)};
  } else {
    std::array<unsigned int, 4> around{
        Info::face_to_cell_vertices(face, 0), Info::face_to_cell_vertices(face, 1),
        Info::face_to_cell_vertices(face, 3), Info::face_to_cell_vertices(face, 2)};
    const dealii::Tensor<1, 3> normal =
        dealii::cross_product_3d(cell->vertex(around[2]) - cell->vertex(around[0]),
                                 cell->vertex(around[3]) - cell->vertex(around[1]));
    if (normal * (cell->face(face)->center() - cell->center()) < 0.)
      std::reverse(around.begin(), around.end());
    return around;
  }
}

template <int dim>
FaceRecord<dim> make_record(const typename dealii::DoFHandler<dim>::active_cell_iterator& cell,
                            const unsigned int face) {
  FaceRecord<dim> record{};
  std::size_t entry = 0;
  for (const unsigned int vertex : ends_of<dim>(cell, face))
    for (unsigned int component = 0; component < dim; ++component) {
      record.dofs[entry] = cell->vertex_dof_index(vertex, component);
      record.coordinates[entry++] = cell->vertex(vertex)[component];
    }
  const dealii::types::manifold_id manifold = cell->face(face)->manifold_id();
  record.surface = cell->face(face)->boundary_id();
  record.circle =
      manifold == dealii::numbers::flat_manifold_id ? -1 : static_cast<int>(manifold) - 1;
  record.body = cell->material_id();
  return record;
}

template <int dim>
std::vector<FaceRecord<dim>> local_records(const dealii::DoFHandler<dim>& dof_handler) {
  std::vector<FaceRecord<dim>> records;
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && cell->at_boundary())
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary()) records.push_back(make_record<dim>(cell, face));
  return records;
}

template <int dim>
std::vector<FaceRecord<dim>> all_records(const dealii::DoFHandler<dim>& dof_handler) {
  std::vector<FaceRecord<dim>> all =
      gathered(dof_handler.get_communicator(), local_records(dof_handler));
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.coordinates < b.coordinates ||
           (a.coordinates == b.coordinates && a.surface < b.surface);
  });
  return all;
}

template <int dim>
BoundaryNode<dim> node_of(const FaceRecord<dim>& record, const std::size_t end) {
  BoundaryNode<dim> node{{}, {}, record.body};
  for (std::size_t component = 0; component < dim; ++component) {
    node.position[static_cast<unsigned int>(component)] = record.coordinates[dim * end + component];
    node.dofs[component] = record.dofs[dim * end + component];
  }
  return node;
}

}  // namespace

template <int dim>
Boundary<dim> gather_boundary(const dealii::DoFHandler<dim>& dof_handler,
                              const std::vector<mesh::Circle>& circles, const double length) {
  Boundary<dim> boundary;
  for (mesh::Circle circle : circles) {
    for (double& coordinate : circle.centre) coordinate /= length;
    circle.radius /= length;
    circle.ring_radius /= length;
    boundary.circles.push_back(circle);
  }

  std::map<global_dof_index, unsigned int> node_of_dof;
  for (const FaceRecord<dim>& record : all_records(dof_handler)) {
    BoundaryFace<dim> face{{}, record.surface, record.circle};
    for (std::size_t end = 0; end < n_ends<dim>; ++end) {
      const auto [entry, is_new] = node_of_dof.emplace(
          record.dofs[dim * end], static_cast<unsigned int>(boundary.nodes.size()));
      if (is_new) boundary.nodes.push_back(node_of(record, end));
      face.nodes[end] = entry->second;
    }
    boundary.faces.push_back(face);
  }
  return boundary;
}

template Boundary<2> gather_boundary(const dealii::DoFHandler<2>&, const std::vector<mesh::Circle>&,
                                     double);
template Boundary<3> gather_boundary(const dealii::DoFHandler<3>&, const std::vector<mesh::Circle>&,
                                     double);

}  // namespace geneva::fem
