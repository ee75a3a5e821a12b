#pragma once

#include <algorithm>
#include <vector>

#include "fem/linear/multigrid/rigid_displacement.h"

namespace geneva::fem {

/// A row of a sparse matrix of blocks by nodes, of the mesh or coarse ones, in the order in which
/// they were named first. It is short: a search from its beginning is faster than any order.
template <typename Block>
class BlockRow {
 public:
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  [[nodiscard]] const std::vector<int>& numbers() const { return numbers_; }
  [[nodiscard]] int number(const std::size_t i) const { return numbers_[i]; }
  [[nodiscard]] const Block& block(const std::size_t i) const { return blocks_[i]; }

  std::vector<Block>& blocks() { return blocks_; }

  void clear() {
    numbers_.clear();
    blocks_.clear();
  }

  /// The block of a node, zero if it is new.
  Block& at(const int number) {
    if (Block* const found = find(number)) return *found;
    numbers_.push_back(number);
    blocks_.push_back(Block::Zero());
    return blocks_.back();
  }

  /// The block of a node; none if there is none.
  Block* find(const int number) {
    const auto found = std::find(numbers_.begin(), numbers_.end(), number);
    return found == numbers_.end() ? nullptr
                                   : &blocks_[static_cast<std::size_t>(found - numbers_.begin())];
  }

 private:
  std::vector<int> numbers_;  ///< among the nodes of all ranks
  std::vector<Block> blocks_;
};

/// Adds a number to a short list that lacks it.
inline void add_once(std::vector<int>& list, const int number) {
  if (std::find(list.begin(), list.end(), number) == list.end()) list.push_back(number);
}

/// Displacement of a node by the unknowns of the coarse nodes that move it.
template <int dim>
using NodeRow = BlockRow<RigidDisplacement<dim>>;

}  // namespace geneva::fem
