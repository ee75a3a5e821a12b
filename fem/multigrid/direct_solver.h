#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <Eigen/CholmodSupport>

#include "fem/multigrid/elimination.h"
#include "fem/multigrid/symmetric_matrix.h"

namespace geneva::fem {

/// Cholesky's factorisation of a sparse matrix, whole on every rank, so that none waits for
/// another.
template <int n>
class DirectSolver {
 public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// Of E^T A E for constrained unknowns; their own equations have A's diagonal alone.
  /// @param matrix A; E^T A E is to be positive definite
  /// @param elimination E
  DirectSolver(const SymmetricMatrix<n>& matrix, const Elimination& elimination,
               MPI_Comm communicator);

  /// Whether the factorisation succeeded.
  [[nodiscard]] bool is_definite() const { return factors_.info() == Eigen::Success; }

  /// @pre is_definite()
  void vmult(Vector& solution, const Vector& right_hand_side) const;

 private:
  MPI_Comm communicator_;
  Eigen::Index first_;  ///< of this rank's unknowns
  Eigen::Index n_own_;
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace geneva::fem
