#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <vector>

#include "fem/multigrid/node_matrix.h"

namespace geneva::fem {

/// A symmetric matrix of n x n blocks by nodes whose rows need not be read any more: of two blocks
/// that are each other's transpose a rank has one. Its products read little more than half as much,
/// which counts when several ranks share the memory.
template <int n>
class SymmetricMatrix {
 public:
  using Block = Eigen::Matrix<double, n, n>;
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// @param matrix symmetric, with all diagonal blocks
  explicit SymmetricMatrix(NodeMatrix<n> matrix);

  [[nodiscard]] const Epetra_Map& unknowns() const { return pattern_.unknowns(); }

  /// A v
  void vmult(Vector& result, const Vector& vector) const;
  /// b - A v
  void residual(Vector& result, const Vector& vector, const Vector& right_hand_side) const;

  /// In the order of this rank's unknowns.
  [[nodiscard]] std::vector<double> diagonal() const;

 private:
  void add_product(Vector& result, const Vector& vector, double factor) const;

  std::vector<Block> blocks_;  ///< from the diagonal on, row by row
  NodePattern pattern_;        ///< of all blocks
};

}  // namespace geneva::fem
