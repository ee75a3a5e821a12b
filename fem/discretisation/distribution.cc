#include "fem/discretisation/distribution.h"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/cell_data_transfer.templates.h>
#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/dofs/dof_tools.h>

#include <vector>

namespace geneva::fem {

namespace {

/// A rank may have this share more cells than the average: to move cells takes about as long as it
/// would wait for the rank.
constexpr double tolerated_excess = 0.02;

template <int dim>
using Triangulation = dealii::parallel::distributed::Triangulation<dim>;

/// Whether cells are flagged for refinement, by their active index.
using Flags = std::vector<unsigned int>;

template <int dim>
Flags flags_of(const Triangulation<dim>& triangulation) {
  Flags flags(triangulation.n_active_cells(), 0);
  for (const auto& cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && cell->refine_flag_set()) flags[cell->active_cell_index()] = 1;
  return flags;
}

/// Also takes away what smoothing has set on cells of other ranks.
template <int dim>
void set_flags(const Triangulation<dim>& triangulation, const Flags& flags) {
  for (const auto& cell : triangulation.active_cell_iterators()) {
    cell->clear_refine_flag();
    if (cell->is_locally_owned() && flags[cell->active_cell_index()] == 1) cell->set_refine_flag();
  }
}

/// Number of cells that one becomes.
template <int dim>
unsigned int n_cells_from(const unsigned int flag) {
  return flag == 1 ? 1U << dim : 1U;
}

template <int dim>
bool is_uneven(const Triangulation<dim>& triangulation, const Flags& flags) {
  double own = 0.;
  for (const auto& cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned()) own += n_cells_from<dim>(flags[cell->active_cell_index()]);
  const auto statistics =
      dealii::Utilities::MPI::min_max_avg(own, triangulation.get_communicator());
  return statistics.max > (1. + tolerated_excess) * statistics.avg;
}

/// The displacement of the cells' new distribution, with the ghosts of this rank's cells.
template <int dim>
Vector received(dealii::DoFHandler<dim>& dof_handler,
                dealii::parallel::distributed::SolutionTransfer<dim, Vector>& transfer) {
  dof_handler.distribute_dofs(dof_handler.get_fe());
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  Vector result(dof_handler.locally_owned_dofs(), relevant, dof_handler.get_communicator());
  transfer.interpolate(result);
  result.update_ghost_values();
  return result;
}

}  // namespace

template <int dim>
void distribute_for_refinement(Triangulation<dim>& triangulation,
                               dealii::DoFHandler<dim>& dof_handler, MeshFields& fields) {
  Flags flags = flags_of(triangulation);
  if (!is_uneven(triangulation, flags)) return;
  set_flags(triangulation, Flags(flags.size(), 0));  // flagged cells cannot move
  dealii::parallel::distributed::CellDataTransfer<dim, dim, Flags> flag_transfer(triangulation);
  dealii::parallel::distributed::SolutionTransfer<dim, Vector> transfer(dof_handler);
  flag_transfer.prepare_for_coarsening_and_refinement(flags);
  PointValueTransfer<dim> history_transfer(triangulation, fields.history);
  transfer.prepare_for_coarsening_and_refinement(fields.displacement);
  const boost::signals2::scoped_connection weight =
      triangulation.signals.weight.connect([&](const auto& cell, const auto) {
        return n_cells_from<dim>(flags[cell->active_cell_index()]);
      });
  triangulation.repartition();
  Flags moved(triangulation.n_active_cells(), 0);
  flag_transfer.unpack(moved);
  set_flags(triangulation, moved);
  triangulation.prepare_coarsening_and_refinement();
  fields.history = history_transfer.carried();
  replace(fields.displacement, received(dof_handler, transfer));
}

template void distribute_for_refinement(Triangulation<2>&, dealii::DoFHandler<2>&, MeshFields&);
template void distribute_for_refinement(Triangulation<3>&, dealii::DoFHandler<3>&, MeshFields&);

}  // namespace geneva::fem
