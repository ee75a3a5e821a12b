#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/trilinos_vector.h>

#include <string>
#include <utility>
#include <vector>

#include "fem/contact/active_set.h"

namespace geneva::fem {

/// Flags the cells to refine: evenly those along every contact zone, so that the contact pressure
/// lives on a smooth mesh, and those with a large energy-norm error (Kelly et al. 1983).
/// @param surface_ids boundary ids (source, target) of the interfaces
/// @param with_energy whether the contact zone is resolved well enough for the energy-norm part to
/// make sense
/// @return number of flagged cells on all ranks
unsigned int flag_cells(dealii::DoFHandler<2>& dof_handler,
                        const dealii::TrilinosWrappers::MPI::Vector& displacement,
                        const std::vector<ContactInterface>& interfaces,
                        const std::vector<std::pair<unsigned int, unsigned int>>& surface_ids,
                        bool with_energy);

}  // namespace geneva::fem
