#include "fem/discretisation/refined_mesh.h"

#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/dofs/dof_tools.h>

#include <utility>

#include "fem/discretisation/distribution.h"
#include "fem/discretisation/element.h"
#include "fem/discretisation/numbering.h"
#include "mesh/triangulation.h"

namespace geneva::fem {

template <int dim>
RefinedMesh<dim>::RefinedMesh(const MPI_Comm communicator, const mesh::MeshData<dim>& coarse,
                              const double length)
    : triangulation(mesh::make_triangulation(communicator, coarse, length)),
      element(linear_element<dim>(dim)),
      dof_handler(std::make_shared<dealii::DoFHandler<dim>>(*triangulation)) {
  number();
  moved_vertices_ = close_gaps(*triangulation);
}

template <int dim>
void RefinedMesh<dim>::number() {
  dof_handler->distribute_dofs(*element);
  number_by_neighbours(*dof_handler);
}

namespace {

template <int dim>
void keep_deepest(dealii::Triangulation<dim>& triangulation) {
  for (const auto& cell : triangulation.active_cell_iterators())
    if (cell->level() >= deepest_level<dim>) cell->clear_refine_flag();
}

}  // namespace

template <int dim>
MeshFields RefinedMesh<dim>::refine(MeshFields fields) {
  fields.displacement.update_ghost_values();
  put_back(*triangulation, moved_vertices_);
  keep_deepest<dim>(*triangulation);
  triangulation->prepare_coarsening_and_refinement();
  distribute_for_refinement(*triangulation, *dof_handler, fields);
  dealii::parallel::distributed::SolutionTransfer<dim, Vector> transfer(*dof_handler);
  transfer.prepare_for_coarsening_and_refinement(fields.displacement);
  PointValueTransfer<dim> history_transfer(*triangulation, fields.history);
  triangulation->execute_coarsening_and_refinement();
  number();
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(*dof_handler, relevant);
  Vector finer(dof_handler->locally_owned_dofs(), relevant, dof_handler->get_communicator());
  transfer.interpolate(finer);
  moved_vertices_ = close_gaps(*triangulation);
  return {without_ghosts(finer), history_transfer.carried()};
}

template <int dim>
Vector RefinedMesh<dim>::refine_as(const SavedField<dim>& saved) {
  put_back(*triangulation, moved_vertices_);
  fem::refine_as(*triangulation, saved);
  number();
  moved_vertices_ = close_gaps(*triangulation);
  return field_on(*dof_handler, saved);
}

template class RefinedMesh<2>;
template class RefinedMesh<3>;

}  // namespace geneva::fem
