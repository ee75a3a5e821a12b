#pragma once

#include <Epetra_CrsMatrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>

#include "fem/multigrid/coupled_nodes.h"

namespace geneva::fem {

/// Galerkin's coarse matrix P^T A P (Trottenberg, Oosterlee and Schueller 2001, A.4.2).
/// @param nodes of A
/// @param prolongation P: rows of A's unknowns, columns by coarse nodes, each of which has as many
/// unknowns as there are rigid motions
/// @return rows and columns as P's columns, distributed as these
template <int dim>
std::unique_ptr<Epetra_CrsMatrix> coarse_matrix(
    const CoupledNodes<dim>& nodes, const dealii::TrilinosWrappers::SparseMatrix& prolongation);

}  // namespace geneva::fem
