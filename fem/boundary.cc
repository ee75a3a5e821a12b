#include "fem/boundary.h"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe.h>

#include <algorithm>
#include <map>

namespace geneva::fem {

namespace {

using dealii::types::global_dof_index;

/// One edge as it travels between the ranks.
struct FaceRecord {
  std::array<global_dof_index, 4> dofs;
  std::array<double, 4> coordinates;
  unsigned int surface;
  unsigned int body;
  int circle;

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int) {
    for (auto& dof : dofs) archive& dof;
    for (auto& coordinate : coordinates) archive& coordinate;
    archive& surface& body& circle;
  }
};

FaceRecord make_record(const dealii::DoFHandler<2>::active_cell_iterator& cell,
                       const unsigned int face) {
  // deal.II runs along opposite sides of a cell in the same direction: sides 1 and 2 are
  // counter-clockwise.
  const bool counter_clockwise = face == 1 || face == 2;
  const auto line = cell->face(face);
  FaceRecord record{};
  for (unsigned int end = 0; end < 2; ++end) {
    const unsigned int vertex =
        dealii::GeometryInfo<2>::face_to_cell_vertices(face, counter_clockwise ? end : 1 - end);
    for (unsigned int component = 0; component < 2; ++component) {
      record.dofs[2 * end + component] = cell->vertex_dof_index(vertex, component);
      record.coordinates[2 * end + component] = cell->vertex(vertex)[component];
    }
  }
  record.surface = line->boundary_id();
  record.circle = line->manifold_id() == dealii::numbers::flat_manifold_id
                      ? -1
                      : static_cast<int>(line->manifold_id()) - 1;
  record.body = cell->material_id();
  return record;
}

std::vector<FaceRecord> local_records(const dealii::DoFHandler<2>& dof_handler) {
  std::vector<FaceRecord> records;
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && cell->at_boundary())
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary()) records.push_back(make_record(cell, face));
  return records;
}

std::vector<FaceRecord> all_records(const dealii::DoFHandler<2>& dof_handler) {
  std::vector<FaceRecord> all;
  for (const auto& records : dealii::Utilities::MPI::all_gather(dof_handler.get_communicator(),
                                                                local_records(dof_handler)))
    all.insert(all.end(), records.begin(), records.end());
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.coordinates < b.coordinates ||
           (a.coordinates == b.coordinates && a.surface < b.surface);
  });
  return all;
}

}  // namespace

Boundary gather_boundary(const dealii::DoFHandler<2>& dof_handler,
                         const std::vector<mesh::Circle>& circles, const double length) {
  Boundary boundary;
  for (const auto& circle : circles)
    boundary.circles.push_back(
        {{circle.centre[0] / length, circle.centre[1] / length}, circle.radius / length});

  std::map<global_dof_index, unsigned int> node_of_dof;
  for (const FaceRecord& record : all_records(dof_handler)) {
    BoundaryFace face{{}, record.surface, record.circle};
    for (std::size_t end = 0; end < 2; ++end) {
      const auto [entry, is_new] = node_of_dof.emplace(
          record.dofs[2 * end], static_cast<unsigned int>(boundary.nodes.size()));
      if (is_new)
        boundary.nodes.push_back(
            {dealii::Point<2>(record.coordinates[2 * end], record.coordinates[2 * end + 1]),
             {record.dofs[2 * end], record.dofs[2 * end + 1]},
             record.body});
      face.nodes[end] = entry->second;
    }
    boundary.faces.push_back(face);
  }
  return boundary;
}

}  // namespace geneva::fem
