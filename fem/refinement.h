#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/trilinos_vector.h>

#include <optional>
#include <utility>
#include <vector>

#include "fem/contact/active_set.h"
#include "fem/refinement_zone.h"

namespace geneva::fem {

/// Flags the cells to refine: evenly those along every contact zone, so that the contact pressure
/// lives on a smooth mesh; those that are large for their distance from it; and those with a large
/// energy-norm error (Kelly et al. 1983).
/// @param surface_ids boundary ids (source, target) of the interfaces
/// @param grading greatest ratio of a cell's size to its distance from the contact; nothing while
/// the contact is not resolved well enough for sizes and energy norm to make sense: then only the
/// zones are refined
/// @return number of flagged cells on all ranks
template <int dim>
unsigned int flag_cells(dealii::DoFHandler<dim>& dof_handler,
                        const dealii::TrilinosWrappers::MPI::Vector& displacement,
                        const std::vector<ContactInterface<dim>>& interfaces,
                        const SurfaceIds& surface_ids, std::optional<double> grading);

/// Flags the cells along the contact zones whose edges are long beside the shortest of their zone:
/// the contact pressure ripples where edges change their length. In space those of lower levels
/// than the highest of their side.
/// @return number of flagged cells on all ranks
template <int dim>
unsigned int flag_uneven_edges(dealii::DoFHandler<dim>& dof_handler,
                               const std::vector<ContactInterface<dim>>& interfaces,
                               const SurfaceIds& surface_ids);

/// The longest edge of a contact zone over its shortest one, on both sides together; the greatest
/// of all zones.
double unevenness(const std::vector<ContactInterface<2>>& interfaces);

}  // namespace geneva::fem
