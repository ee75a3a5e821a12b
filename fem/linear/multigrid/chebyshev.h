#pragma once

#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/condensed_matrix.h"
#include "fem/linear/multigrid/symmetric_matrix.h"

namespace geneva::fem {

/// Chebyshev's iteration of degree two for the system scaled by its diagonal (Saad 2003, Iterative
/// methods for sparse linear systems, algorithm 12.1): reduces the errors at the upper end of the
/// spectrum.
/// @tparam Matrix SymmetricMatrix or CondensedMatrix
template <typename Matrix>
class Chebyshev {
 public:
  /// @param matrix symmetric and positive definite; must outlive this
  /// @param lowest, highest eigenvalues of the scaled matrix that are reduced, positive
  Chebyshev(const Matrix& matrix, double lowest, double highest);

  /// An approximate solution for a right-hand side, from zero.
  void solve(Vector& solution, const Vector& right_hand_side) const;
  /// A better one than that given.
  void improve(Vector& solution, const Vector& right_hand_side) const;

 private:
  void take_second_step(Vector& solution, Vector& step, const Vector& right_hand_side) const;

  const Matrix& matrix_;
  std::vector<double> inverse_diagonal_;
  double centre_;      ///< theta
  double half_width_;  ///< delta
};

/// The largest eigenvalue of a matrix scaled by its diagonal, from below: by the power method.
/// @param vector in: where it starts, not zero; out: nearer to the eigenvector
template <typename Matrix>
double largest_eigenvalue(const Matrix& matrix, Vector& vector, int n_steps);

/// From a vector that is the same in every run.
/// @param vector out: near the eigenvector
template <typename Matrix>
double largest_eigenvalue(const Matrix& matrix, MPI_Comm communicator, Vector& vector);

}  // namespace geneva::fem
