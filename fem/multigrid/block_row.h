#pragma once

#include <algorithm>
#include <vector>

#include "fem/multigrid/rigid_displacement.h"

namespace geneva::fem {

/// A row of a sparse matrix of blocks by coarse nodes, in the order in which they were named first.
/// It is short: a search from its beginning is faster than any order.
template <typename Block>
class BlockRow {
 public:
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  [[nodiscard]] int number(const std::size_t i) const { return numbers_[i]; }
  [[nodiscard]] const Block& block(const std::size_t i) const { return blocks_[i]; }

  /// The block of a coarse node, zero if it is new.
  Block& at(const int number) {
    if (Block* const found = find(number)) return *found;
    numbers_.push_back(number);
    blocks_.push_back(Block::Zero());
    return blocks_.back();
  }

  /// The block of a coarse node; none if there is none.
  Block* find(const int number) {
    const auto found = std::find(numbers_.begin(), numbers_.end(), number);
    return found == numbers_.end() ? nullptr
                                   : &blocks_[static_cast<std::size_t>(found - numbers_.begin())];
  }

 private:
  std::vector<int> numbers_;  ///< among the coarse nodes of all ranks
  std::vector<Block> blocks_;
};

/// Displacement of a node by the unknowns of the coarse nodes that move it.
template <int dim>
using NodeRow = BlockRow<RigidDisplacement<dim>>;

/// Unknowns of the coarse nodes of a row, one node after the other.
template <int dim, typename Block>
std::vector<dealii::types::global_dof_index> coarse_unknowns(const BlockRow<Block>& row) {
  std::vector<dealii::types::global_dof_index> result;
  result.reserve(row.size() * n_rigid_motions<dim>);
  for (std::size_t i = 0; i < row.size(); ++i)
    for (int j = 0; j < n_rigid_motions<dim>; ++j)
      result.push_back(coarse_unknown<dim>(row.number(i), j));
  return result;
}

/// Values of one line of a row of blocks, in the order of coarse_unknowns().
template <typename Block>
std::vector<double> values_of_line(const BlockRow<Block>& row, const Eigen::Index line) {
  std::vector<double> result;
  result.reserve(row.size() * Block::ColsAtCompileTime);
  for (std::size_t i = 0; i < row.size(); ++i)
    result.insert(result.end(), row.block(i).row(line).begin(), row.block(i).row(line).end());
  return result;
}

}  // namespace geneva::fem
