#pragma once

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>

#include "fem/discretisation/mesh_fields.h"

namespace geneva::fem {

/// Moves cells between the ranks if refining the flagged ones where they are would leave a rank
/// with more than its share: of the coarse cells fewer move than of their children, and a rank
/// builds those that it gets level by level, in passes over all its cells.
/// @param triangulation without automatic repartitioning, with all its flags set; in and out
/// @param dof_handler out: with the unknowns of the new distribution, if there is one
/// @param fields move with the cells; the displacement with ghosts, at least those of this rank's
/// cells
template <int dim>
void distribute_for_refinement(dealii::parallel::distributed::Triangulation<dim>& triangulation,
                               dealii::DoFHandler<dim>& dof_handler, MeshFields& fields);

}  // namespace geneva::fem
