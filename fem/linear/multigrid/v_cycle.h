#pragma once

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/chebyshev.h"
#include "fem/linear/multigrid/node_matrix.h"

namespace geneva::fem {

/// One V-cycle (Trottenberg, Oosterlee and Schueller 2001, 2.4): smooths before and after the
/// correction on the coarser level.
/// @param coarse approximate inverse of the coarse matrix
/// @param coarse_zero zeros at the coarse unknowns: copies of it need no communication, new vectors
/// do
/// @param correction out
template <typename Matrix, int n, int m, typename Coarse>
void v_cycle(const Matrix& matrix, const Chebyshev<Matrix>& smoother,
             const NodeMatrix<n, m>& prolongation, const Coarse& coarse, const Vector& coarse_zero,
             Vector& correction, const Vector& residual) {
  smoother.solve(correction, residual);
  Vector rest(residual);
  matrix.residual(rest, correction, residual);
  Vector coarse_residual(coarse_zero);
  prolongation.Tvmult(coarse_residual, rest);
  Vector coarse_correction(coarse_zero);
  coarse.vmult(coarse_correction, coarse_residual);
  prolongation.vmult_add(correction, coarse_correction);
  smoother.improve(correction, residual);
}

}  // namespace geneva::fem
