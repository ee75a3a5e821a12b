#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/block_rows.h"
#include "fem/linear/multigrid/exchange.h"
#include "fem/linear/multigrid/unknown_ranges.h"

namespace geneva::fem {

/// Which column nodes each row node of this rank is coupled to. Column nodes have places: the
/// rank's own ones in the order of their numbers, then those of other ranks.
class NodePattern {
 public:
  /// @param unknowns of this rank's column nodes, those of a node after each other
  /// @param of_each number of unknowns of a column node
  /// @param coupled numbers of the column nodes that each row node is coupled to, once each
  NodePattern(const UnknownRanges& unknowns, int of_each,
              const std::vector<std::vector<int>>& coupled);

  [[nodiscard]] std::size_t n_rows() const { return first_blocks_.size() - 1; }
  /// This rank's column nodes.
  [[nodiscard]] const OwnNodes& own() const { return own_; }
  [[nodiscard]] std::size_t n_places() const { return numbers_.size(); }
  [[nodiscard]] int number(const std::size_t place) const { return numbers_[place]; }
  [[nodiscard]] const std::vector<int>& numbers() const { return numbers_; }
  /// @param number of a node that this rank has in a column
  [[nodiscard]] int place_of(const int number) const { return columns_.place_of(number); }
  [[nodiscard]] std::size_t n_blocks() const { return places_.size(); }
  /// Blocks of a row: from this one on, before that of the next row.
  [[nodiscard]] std::size_t first_block(const std::size_t row) const { return first_blocks_[row]; }
  /// Place of a block's column, ascending in a row.
  [[nodiscard]] int place(const std::size_t block) const { return places_[block]; }
  /// Place of a block's column among those of other ranks' nodes.
  /// @param block of a column of another rank
  [[nodiscard]] std::size_t place_beyond(const std::size_t block) const {
    return static_cast<std::size_t>(places_[block]) - own_.size();
  }
  /// The block of two nodes that are coupled; if they are not, that of the next column.
  [[nodiscard]] std::size_t block(std::size_t row, int place) const;

  [[nodiscard]] const UnknownRanges& unknowns() const { return unknowns_; }
  /// Blocks of a row in columns of other ranks.
  struct BlocksBeyond {
    std::size_t row;
    std::size_t first;
    std::size_t end;
  };
  /// Those of each row that has any.
  [[nodiscard]] const std::vector<BlocksBeyond>& blocks_beyond() const { return blocks_beyond_; }

  /// Values at the unknowns of other ranks' nodes, in the order of their places.
  /// @param of_own values at this rank's unknowns
  /// @param meanwhile work that does not need them
  /// @return valid until the next call
  template <typename Work>
  const double* on_others(const double* of_own, const Work& meanwhile) const;
  [[nodiscard]] const double* on_others(const double* const of_own) const {
    return on_others(of_own, [] {});
  }
  /// Values of the nodes of all places from those of the own ones.
  [[nodiscard]] std::vector<double> on_all_nodes(const std::vector<double>& of_own_nodes) const;
  /// Adds to values at the own unknowns what the ranks have at all their places.
  /// @param of_own values at this rank's unknowns, in and out
  /// @param add_to_others adds to zeros at the unknowns of other ranks' nodes
  /// @param add_to_own adds to the values at the own unknowns meanwhile
  template <typename AddToOthers, typename AddToOwn>
  void add(double* of_own, const AddToOthers& add_to_others, const AddToOwn& add_to_own) const;

 private:
  void find_blocks_beyond();

  UnknownRanges unknowns_;
  std::size_t of_each_;
  OwnNodes own_;
  ColumnNodes columns_;
  std::vector<int> numbers_;
  std::vector<std::size_t> first_blocks_;
  std::vector<int> places_;
  std::vector<BlocksBeyond> blocks_beyond_;
  std::unique_ptr<Exchange> exchange_;  ///< none on one rank
};

template <typename Work>
const double* NodePattern::on_others(const double* const of_own, const Work& meanwhile) const {
  if (exchange_) exchange_->begin_to_receive(of_own);
  meanwhile();
  return exchange_ ? exchange_->end_of_receiving() : nullptr;
}

template <typename AddToOthers, typename AddToOwn>
void NodePattern::add(double* const of_own, const AddToOthers& add_to_others,
                      const AddToOwn& add_to_own) const {
  if (exchange_) {
    add_to_others(exchange_->to_send());
    exchange_->begin_to_send();
  }
  add_to_own(of_own);
  if (exchange_) exchange_->add_received(of_own);
}

/// A matrix of n x m blocks by nodes, distributed by rows.
template <int n, int m>
class NodeMatrix {
 public:
  using Block = Eigen::Matrix<double, n, m>;

  /// Zero.
  explicit NodeMatrix(NodePattern pattern)
      : pattern_(std::move(pattern)), blocks_(pattern_.n_blocks(), Block::Zero()) {}

  [[nodiscard]] const NodePattern& pattern() const { return pattern_; }
  /// Of the columns.
  [[nodiscard]] const UnknownRanges& unknowns() const { return pattern_.unknowns(); }
  [[nodiscard]] const Block& block(const std::size_t index) const { return blocks_[index]; }
  Block& block(const std::size_t index) { return blocks_[index]; }

  void add(std::size_t row, const BlockRow<Block>& values);

  /// result + A v
  void vmult_add(Vector& result, const Vector& vector) const;
  /// A^T v
  void Tvmult(Vector& result, const Vector& vector) const;

 private:
  template <typename Visit>
  void visit_own_blocks(const Visit& visit) const;
  template <typename Visit>
  void visit_blocks_beyond(const Visit& visit) const;

  NodePattern pattern_;
  std::vector<Block> blocks_;
};

/// @param rows of this rank's nodes, by the numbers of column nodes
/// @param unknowns of this rank's column nodes
template <int n, int m>
NodeMatrix<n, m> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, n, m>>>& rows,
                           const UnknownRanges& unknowns);

}  // namespace geneva::fem
