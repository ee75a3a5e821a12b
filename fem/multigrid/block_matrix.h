#pragma once

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <memory>

#include "fem/multigrid/block_rows.h"

namespace geneva::fem {

/// The matrix that is the sum of what the ranks have of its rows.
/// @param rows by coarse nodes of any rank; those of others are sent to them
/// @param unknowns of the coarse nodes, of the rows as well as of the columns
/// @return with at least the diagonal block in each row; this rank's unknowns are the first columns
/// in the order of its rows
template <typename Block>
std::unique_ptr<Epetra_CrsMatrix> block_matrix(BlockRows<Block> rows, const Epetra_Map& unknowns,
                                               MPI_Comm communicator);

}  // namespace geneva::fem
