#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <Epetra_Import.h>
#include <Epetra_Map.h>
#include <Epetra_MultiVector.h>
#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

#include "fem/multigrid/block_rows.h"

namespace geneva::fem {

/// Which column nodes each row node of this rank is coupled to. Column nodes have places: the
/// rank's own ones in the order of their numbers, then those of other ranks.
class NodePattern {
 public:
  /// @param unknowns of this rank's column nodes, those of a node after each other
  /// @param of_each number of unknowns of a column node
  /// @param coupled numbers of the column nodes that each row node is coupled to, once each
  NodePattern(const Epetra_Map& unknowns, int of_each, std::vector<std::vector<int>> coupled);

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
  /// The block of two nodes that are coupled.
  [[nodiscard]] std::size_t block(std::size_t row, int place) const;

  [[nodiscard]] const Epetra_Map& unknowns() const { return unknowns_; }
  /// Values at the unknowns of other ranks' nodes, in the order of their places.
  /// @param of_own values at this rank's unknowns
  /// @return valid until the next call
  [[nodiscard]] const double* on_others(const Epetra_MultiVector& of_own) const;
  /// Values of the nodes of all places from those of the own ones.
  [[nodiscard]] std::vector<double> on_all_nodes(const std::vector<double>& of_own_nodes) const;
  /// Values at the own unknowns that are the sums of those that the ranks have at all their places.
  /// @param add adds to the values at own unknowns and to those at others, zero before
  void sum(Epetra_MultiVector& of_own,
           const std::function<void(double* own, double* others)>& add) const;
  /// Adds to values at the own unknowns what the ranks have at all their places.
  /// @param add adds to the values at own unknowns and to those at others, these zero before
  void add(Epetra_MultiVector& of_own,
           const std::function<void(double* own, double* others)>& add) const;

 private:
  Epetra_Map unknowns_;
  std::size_t of_each_;
  OwnNodes own_;
  ColumnNodes columns_;
  std::vector<int> numbers_;
  std::vector<std::size_t> first_blocks_;
  std::vector<int> places_;
  std::unique_ptr<Epetra_Import> import_;       ///< none on one rank
  std::unique_ptr<Epetra_MultiVector> others_;  ///< values that come from or go to other ranks
};

/// A matrix of n x m blocks by nodes, distributed by rows.
template <int n, int m>
class NodeMatrix {
 public:
  using Block = Eigen::Matrix<double, n, m>;
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// Zero.
  explicit NodeMatrix(NodePattern pattern)
      : pattern_(std::move(pattern)), blocks_(pattern_.n_blocks(), Block::Zero()) {}

  [[nodiscard]] const NodePattern& pattern() const { return pattern_; }
  /// Of the columns.
  [[nodiscard]] const Epetra_Map& unknowns() const { return pattern_.unknowns(); }
  [[nodiscard]] const Block& block(const std::size_t index) const { return blocks_[index]; }
  Block& block(const std::size_t index) { return blocks_[index]; }

  void add(std::size_t row, const BlockRow<Block>& values);

  /// result + A v
  void vmult_add(Vector& result, const Vector& vector) const;
  /// A^T v
  void Tvmult(Vector& result, const Vector& vector) const;

 private:
  NodePattern pattern_;
  std::vector<Block> blocks_;
};

/// @param rows of this rank's nodes, by the numbers of column nodes
/// @param unknowns of this rank's column nodes
template <int n, int m>
NodeMatrix<n, m> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, n, m>>>& rows,
                           const Epetra_Map& unknowns);

}  // namespace geneva::fem
