#pragma once

#include <deal.II/base/index_set.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/elasticity/cell_systems.h"
#include "fem/linear/multigrid/symmetric_matrix.h"

namespace geneva::fem {

/// The matrix of the unknowns that constraints leave free, summed up from the ranks' cells. A
/// constrained unknown stands alone in it, with its own stiffness as the diagonal, and has no load.
/// @param cells of this rank
/// @param constraints closed
/// @param unknowns of this rank, those of a node after each other
/// @param load in: made for writing to all unknowns of the condensed cells; out: with the cells'
/// loads added, to be compressed
template <int dim>
SymmetricMatrix<dim> assemble(const CellSystems& cells,
                              const dealii::AffineConstraints<double>& constraints,
                              const dealii::IndexSet& unknowns, MPI_Comm communicator,
                              Vector& load);

}  // namespace geneva::fem
