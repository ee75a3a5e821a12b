#pragma once

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>

#include "fem/multigrid/coupled_nodes.h"

namespace geneva::fem {

/// Galerkin's coarse matrix P^T A P (Trottenberg, Oosterlee and Schueller 2001, A.4.2).
/// @param nodes of A
/// @param prolongation P, by nodes of as many unknowns as there are rigid motions
template <int dim>
std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix> coarse_matrix(
    const CoupledNodes<dim>& nodes, const dealii::TrilinosWrappers::SparseMatrix& prolongation);

}  // namespace geneva::fem
