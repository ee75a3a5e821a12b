#pragma once

#include <deal.II/base/index_set.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <vector>

#include "fem/elasticity.h"

namespace geneva::fem {

/// The matrix and the load of the unknowns that constraints leave free, summed up from the ranks'
/// cells. A constrained unknown stands alone in the matrix, with its own stiffness as the diagonal,
/// and has no load.
/// @param cells of this rank
/// @param constraints closed
/// @param unknowns of this rank, those of a node after each other
/// @param matrix out: with rows of whole nodes, this rank's unknowns as the first columns
/// @param load in: zero, made for writing to all unknowns of the condensed cells; out: to be
/// compressed
template <int dim>
void assemble(const std::vector<CellSystem>& cells,
              const dealii::AffineConstraints<double>& constraints,
              const dealii::IndexSet& unknowns, MPI_Comm communicator,
              dealii::TrilinosWrappers::SparseMatrix& matrix,
              dealii::TrilinosWrappers::MPI::Vector& load);

}  // namespace geneva::fem
