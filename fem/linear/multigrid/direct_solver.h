#pragma once

#include <Eigen/CholmodSupport>

#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/elimination.h"
#include "fem/linear/multigrid/symmetric_matrix.h"

namespace geneva::fem {

/// Cholesky's factorisation of a sparse matrix: of a small one whole on every rank, so that none
/// waits for another; of a large one on the first rank alone, for the memory's sake.
template <int n>
class DirectSolver {
 public:
  /// Unknowns up to which every rank has all factors: the coarsest level of four million unknowns
  /// has as many.
  static constexpr int most_on_every_rank = 20000;

  /// Of E^T A E for constrained unknowns; their own equations have A's diagonal alone.
  /// @param matrix A; E^T A E is to be positive definite
  /// @param elimination E
  /// @param most_everywhere unknowns up to which every rank has all factors
  DirectSolver(const SymmetricMatrix<n>& matrix, const Elimination& elimination,
               MPI_Comm communicator, int most_everywhere = most_on_every_rank);

  /// Whether the factorisation succeeded.
  [[nodiscard]] bool is_definite() const { return is_definite_; }
  /// Whether this rank has the factors.
  [[nodiscard]] bool has_factors() const { return is_everywhere_ || is_first_; }

  /// @pre is_definite()
  void vmult(Vector& solution, const Vector& right_hand_side) const;

 private:
  [[nodiscard]] Eigen::VectorXd solved_everywhere(const double* own) const;
  [[nodiscard]] Eigen::VectorXd solved_by_first(const double* own) const;

  MPI_Comm communicator_;
  bool is_first_;       ///< the rank
  bool is_everywhere_;  ///< the factorisation
  bool is_definite_;
  int n_unknowns_;
  int n_own_;
  std::vector<int> counts_;  ///< unknowns of the ranks
  std::vector<int> firsts_;  ///< first unknown of each rank, and the end
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace geneva::fem
