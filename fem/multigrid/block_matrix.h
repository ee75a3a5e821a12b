#pragma once

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <map>
#include <memory>
#include <vector>

#include "fem/multigrid/block_row.h"

namespace geneva::fem {

/// Rows of a matrix by coarse nodes.
template <typename Block>
using BlockRows = std::map<int, BlockRow<Block>>;

/// The matrix that is the sum of what the ranks have of its rows.
/// @param rows by coarse nodes of any rank; those of others are sent to them
/// @param unknowns of the coarse nodes, of the rows as well as of the columns
/// @return with at least the diagonal block in each row; this rank's unknowns are the first columns
/// in the order of its rows
template <typename Block>
std::unique_ptr<Epetra_CrsMatrix> block_matrix(BlockRows<Block> rows, const Epetra_Map& unknowns,
                                               MPI_Comm communicator);

}  // namespace geneva::fem
