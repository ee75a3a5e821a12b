#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <vector>

#include "fem/multigrid/node_matrix.h"

namespace geneva::fem {

/// A symmetric matrix of n x n blocks by nodes, distributed by rows. Of two blocks of its own nodes
/// that are each other's transpose a rank has one, that above the diagonal: this takes little more
/// than half the memory, and of the time where the memory is what takes time.
template <int n>
class SymmetricMatrix {
 public:
  using Block = Eigen::Matrix<double, n, n>;
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// Zero.
  /// @param pattern symmetric, with all diagonal blocks
  explicit SymmetricMatrix(NodePattern pattern);

  [[nodiscard]] const NodePattern& pattern() const { return pattern_; }
  [[nodiscard]] const Epetra_Map& unknowns() const { return pattern_.unknowns(); }

  /// A block of the pattern.
  /// @param place of the column's node
  [[nodiscard]] Block block(std::size_t row, int place) const;
  /// A block on or above the diagonal, and with it the transposed one.
  /// @param place of the column's node, not before the row
  Block& upper_block(const std::size_t row, const int place) { return blocks_[index(row, place)]; }
  [[nodiscard]] const Block& diagonal_block(const std::size_t row) const {
    return blocks_[first_blocks_[row]];
  }
  Block& diagonal_block(const std::size_t row) { return blocks_[first_blocks_[row]]; }
  /// Calls visit(place, block) for the blocks of a row from the diagonal on.
  template <typename Visit>
  void visit_upper(std::size_t row, const Visit& visit) const;
  /// Calls visit(row, place, block) for all blocks of this rank's rows, those of a row in the order
  /// of their places.
  template <typename Visit>
  void visit_blocks(const Visit& visit) const;

  /// Adds rows of this rank's nodes; what is below the diagonal is not read.
  void add(const BlockRows<Block>& rows);

  /// A v
  void vmult(Vector& result, const Vector& vector) const;
  /// b - A v
  void residual(Vector& result, const Vector& vector, const Vector& right_hand_side) const;

  /// In the order of this rank's unknowns.
  [[nodiscard]] std::vector<double> diagonal() const;

 private:
  /// Of the blocks above the diagonal.
  [[nodiscard]] std::size_t index(std::size_t row, int place) const;
  /// The first block of a row in the pattern that this matrix has.
  [[nodiscard]] std::size_t first_of_pattern(const std::size_t row) const {
    return pattern_.first_block(row + 1) - (first_blocks_[row + 1] - first_blocks_[row]);
  }
  void add_product(Vector& result, const Vector& vector, double factor) const;

  NodePattern pattern_;                    ///< of all blocks
  std::vector<std::size_t> first_blocks_;  ///< of each row, the diagonal ones, and the end
  std::vector<Block> blocks_;              ///< from the diagonal on, row by row
};

template <int n>
template <typename Visit>
void SymmetricMatrix<n>::visit_upper(const std::size_t row, const Visit& visit) const {
  std::size_t in_pattern = first_of_pattern(row);
  for (std::size_t i = first_blocks_[row]; i < first_blocks_[row + 1]; ++i, ++in_pattern)
    visit(static_cast<std::size_t>(pattern_.place(in_pattern)), blocks_[i]);
}

template <int n>
template <typename Visit>
void SymmetricMatrix<n>::visit_blocks(const Visit& visit) const {
  const std::size_t n_own = pattern_.n_rows();
  for (std::size_t row = 0; row < n_own; ++row)
    visit_upper(row, [&](const std::size_t place, const Block& block) {
      visit(row, place, block);
      if (place != row && place < n_own) visit(place, row, Block(block.transpose()));
    });
}

}  // namespace geneva::fem
