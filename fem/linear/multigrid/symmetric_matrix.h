#pragma once

#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/node_matrix.h"
#include "fem/linear/multigrid/unknown_ranges.h"

namespace geneva::fem {

/// A symmetric matrix of n x n blocks by nodes, distributed by rows. Of two blocks of its own nodes
/// that are each other's transpose a rank has one, that above the diagonal: this takes little more
/// than half the memory, and of the time where the memory is what takes time.
template <int n>
class SymmetricMatrix {
 public:
  using Block = Eigen::Matrix<double, n, n>;

  /// Zero.
  /// @param pattern symmetric, with all diagonal blocks
  explicit SymmetricMatrix(NodePattern pattern);

  [[nodiscard]] const NodePattern& pattern() const { return pattern_; }
  [[nodiscard]] const UnknownRanges& unknowns() const { return pattern_.unknowns(); }

  /// A block of the pattern.
  /// @param place of the column's node
  [[nodiscard]] Block block(std::size_t row, int place) const;
  /// A block on or above the diagonal, and with it the transposed one.
  /// @param place of the column's node, not before the row
  Block& upper_block(const std::size_t row, const int place) { return blocks_[index(row, place)]; }
  [[nodiscard]] const Block& diagonal_block(const std::size_t row) const {
    return blocks_[first_upper_[row]];
  }
  Block& diagonal_block(const std::size_t row) { return blocks_[first_upper_[row]]; }
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
  /// Of a block on or above the diagonal.
  [[nodiscard]] std::size_t index(std::size_t row, int place) const;
  /// The end of a row's blocks in columns of this rank, in the pattern.
  [[nodiscard]] std::size_t end_of_own(const std::size_t row) const {
    return pattern_.first_block(row + 1) - (first_beyond_[row + 1] - first_beyond_[row]);
  }
  /// The diagonal block of a row in the pattern.
  [[nodiscard]] std::size_t first_of_upper(const std::size_t row) const {
    return end_of_own(row) - (first_upper_[row + 1] - first_upper_[row]);
  }
  void add_product(Vector& result, const Vector& vector, double factor) const;
  void add_product_of_own(double* to, const double* own, double factor) const;

  NodePattern pattern_;                    ///< of all blocks
  std::vector<std::size_t> first_upper_;   ///< of each row in columns of this rank, and the end
  std::vector<std::size_t> first_beyond_;  ///< of each row in columns of others, and the end
  std::vector<Block> blocks_;  ///< those from the diagonal on, row by row, then those beyond
};

template <int n>
template <typename Visit>
void SymmetricMatrix<n>::visit_upper(const std::size_t row, const Visit& visit) const {
  std::size_t in_pattern = first_of_upper(row);
  for (const auto* const first : {&first_upper_, &first_beyond_})
    for (std::size_t i = (*first)[row]; i < (*first)[row + 1]; ++i, ++in_pattern)
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
