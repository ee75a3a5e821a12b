#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "fem/linear/multigrid/elimination.h"
#include "fem/linear/multigrid/symmetric_matrix.h"

namespace geneva::fem {

/// What this rank's rows of A add to the entries of E^T A E on the diagonal and below, by global
/// numbers; entries may come several times and count as their sum. The equations of constrained
/// unknowns have A's diagonal alone.
template <int n>
std::vector<Eigen::Triplet<double>> condensed_entries(const SymmetricMatrix<n>& matrix,
                                                      const Elimination& elimination);

}  // namespace geneva::fem
