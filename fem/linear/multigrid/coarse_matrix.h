#pragma once

#include "fem/linear/multigrid/symmetric_matrix.h"

namespace geneva::fem {

/// Galerkin's coarse matrix P^T A P (Trottenberg, Oosterlee and Schueller 2001, A.4.2).
/// @param matrix A
/// @param prolongation P: rows of A's nodes, columns by coarse nodes
/// @return rows and columns as P's columns, distributed as these
template <int n, int m>
SymmetricMatrix<m> coarse_matrix(const SymmetricMatrix<n>& matrix,
                                 const NodeMatrix<n, m>& prolongation, MPI_Comm communicator);

}  // namespace geneva::fem
