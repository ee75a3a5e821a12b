#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <Epetra_Import.h>
#include <Epetra_Map.h>
#include <Epetra_MultiVector.h>
#include <Eigen/Core>

#include <memory>
#include <vector>

#include "fem/multigrid/block_rows.h"

namespace geneva::fem {

/// Which nodes each node of this rank is coupled to. Nodes have places: the rank's own ones in the
/// order of their numbers, then those of other ranks.
class NodePattern {
 public:
  /// @param unknowns of this rank, those of a node after each other
  /// @param of_each number of unknowns of a node
  /// @param coupled numbers of the nodes that each own node is coupled to, once each
  NodePattern(const Epetra_Map& unknowns, int of_each, std::vector<std::vector<int>> coupled);

  [[nodiscard]] const OwnNodes& own() const { return own_; }
  [[nodiscard]] std::size_t n_places() const { return numbers_.size(); }
  [[nodiscard]] int number(const std::size_t place) const { return numbers_[place]; }
  /// @param number of a node that this rank has in a row or column
  [[nodiscard]] int place_of(const int number) const { return columns_.place_of(number); }
  [[nodiscard]] std::size_t n_blocks() const { return places_.size(); }
  /// Blocks of an own node's row: from this one on, before that of the next place.
  [[nodiscard]] std::size_t first_block(const std::size_t own_place) const {
    return first_blocks_[own_place];
  }
  /// Place of a block's column, ascending in a row.
  [[nodiscard]] int place(const std::size_t block) const { return places_[block]; }
  /// The block of two nodes that are coupled.
  [[nodiscard]] std::size_t block(std::size_t own_place, int place) const;

  [[nodiscard]] const Epetra_Map& unknowns() const { return unknowns_; }
  /// Values at the unknowns of all places from those of the own ones.
  [[nodiscard]] const double* on_all_places(const Epetra_MultiVector& of_own) const;

 private:
  Epetra_Map unknowns_;
  OwnNodes own_;
  ColumnNodes columns_;
  std::vector<int> numbers_;
  std::vector<std::size_t> first_blocks_;
  std::vector<int> places_;
  std::unique_ptr<Epetra_Import> import_;    ///< none on one rank
  std::unique_ptr<Epetra_MultiVector> all_;  ///< what the last import gave
};

/// A square matrix of n x n blocks by nodes, distributed by rows.
template <int n>
class NodeMatrix {
 public:
  using Block = Eigen::Matrix<double, n, n>;
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// Zero.
  explicit NodeMatrix(NodePattern pattern)
      : pattern_(std::move(pattern)), blocks_(pattern_.n_blocks(), Block::Zero()) {}

  [[nodiscard]] const NodePattern& pattern() const { return pattern_; }
  [[nodiscard]] const Block& block(const std::size_t index) const { return blocks_[index]; }
  Block& block(const std::size_t index) { return blocks_[index]; }

  /// Adds what the ranks' rows have in common with this matrix's pattern.
  void add(const BlockRows<Block>& rows);

  /// A v
  void vmult(Vector& result, const Vector& vector) const;
  /// result + A v
  void vmult_add(Vector& result, const Vector& vector) const;
  /// b - A v
  void residual(Vector& result, const Vector& vector, const Vector& right_hand_side) const;

  /// The diagonal's entries, in the order of this rank's unknowns.
  [[nodiscard]] std::vector<double> diagonal() const;

 private:
  /// Calls use(unknown, value) for the entries of A v, by this rank's unknowns.
  template <typename Use>
  void multiply(const Vector& vector, const Use& use) const;

  NodePattern pattern_;
  std::vector<Block> blocks_;
};

}  // namespace geneva::fem
