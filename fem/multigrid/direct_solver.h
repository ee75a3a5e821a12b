#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <Eigen/CholmodSupport>

#include "fem/multigrid/symmetric_matrix.h"

namespace geneva::fem {

/// Cholesky's factorisation of a sparse matrix, whole on every rank, so that none waits for
/// another.
template <int n>
class DirectSolver {
 public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// @param matrix positive definite
  DirectSolver(const SymmetricMatrix<n>& matrix, MPI_Comm communicator);

  void vmult(Vector& solution, const Vector& right_hand_side) const;

 private:
  MPI_Comm communicator_;
  Eigen::Index first_;  ///< of this rank's unknowns
  Eigen::Index n_own_;
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace geneva::fem
