#include "fem/linear/multigrid/coarse_matrix.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geneva::fem {

namespace {

template <int n, int m>
using Row = BlockRow<Eigen::Matrix<double, n, m>>;

/// Rows of P at the nodes of all places of A.
template <int n, int m>
std::vector<Row<n, m>> rows_of(const NodeMatrix<n, m>& prolongation, const NodePattern& nodes,
                               const MPI_Comm communicator) {
  const NodePattern& pattern = prolongation.pattern();
  std::vector<Row<n, m>> rows(pattern.n_rows());
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t i = pattern.first_block(row); i < pattern.first_block(row + 1); ++i)
      rows[row].at(pattern.number(static_cast<std::size_t>(pattern.place(i)))) =
          prolongation.block(i);
  const std::vector<int> others(
      nodes.numbers().begin() + static_cast<std::ptrdiff_t>(nodes.own().size()),
      nodes.numbers().end());
  for (auto& row : rows_of_others(rows, others, nodes.unknowns(), n, communicator))
    rows.push_back(std::move(row));
  return rows;
}

/// The factors of P^T A P: the sum of left^T right over the nodes, and its transpose.
template <int n, int m>
class Factors {
 public:
  Factors(const SymmetricMatrix<n>& matrix, const NodeMatrix<n, m>& prolongation,
          const MPI_Comm communicator)
      : matrix_(matrix), rows_(rows_of(prolongation, matrix.pattern(), communicator)) {}

  [[nodiscard]] std::size_t n_nodes() const { return matrix_.pattern().n_rows(); }
  /// The row of P.
  [[nodiscard]] const Row<n, m>& left(const std::size_t node) const { return rows_[node]; }
  /// Whether the rows of P at a node and at those that it is coupled to have columns of other
  /// ranks.
  [[nodiscard]] std::vector<bool> nodes_with_columns_beyond(const OwnNodes& own) const {
    std::vector<bool> is_beyond;
    for (const Row<n, m>& row : rows_)
      is_beyond.push_back(std::any_of(row.numbers().begin(), row.numbers().end(),
                                      [&](const int number) { return !own.have(number); }));
    std::vector<bool> result(n_nodes(), false);
    for (std::size_t node = 0; node < n_nodes(); ++node)
      matrix_.visit_upper(node, [&](const std::size_t place, const auto&) {
        if (is_beyond[place]) result[node] = true;
      });
    return result;
  }
  /// Columns of find_right().
  void find_columns(const std::size_t node, std::vector<int>& columns) const {
    columns.clear();
    matrix_.visit_upper(node, [&](const std::size_t place, const auto&) {
      for (const int number : rows_[place].numbers()) add_once(columns, number);
    });
  }
  /// Of A P so much that left^T right, added to its transpose, gives the whole of this rank's rows.
  void find_right(const std::size_t node, Row<n, m>& right) const {
    right.clear();
    matrix_.visit_upper(node, [&](const std::size_t place, const auto& block) {
      // The diagonal is its own transpose, and of other ranks' nodes these have the transpose.
      const bool is_shared = place == node || place >= n_nodes();
      const Row<n, m>& row = rows_[place];
      for (std::size_t i = 0; i < row.size(); ++i)
        right.at(row.number(i)).noalias() += (is_shared ? 0.5 : 1.) * block * row.block(i);
    });
  }

 private:
  const SymmetricMatrix<n>& matrix_;
  std::vector<Row<n, m>> rows_;
};

/// Adds first^T second to the rows of other ranks' nodes, as far as these read it.
template <int n, int m>
void add_rows_of_others(const Row<n, m>& first, const Row<n, m>& second, const OwnNodes& own,
                        const UnknownRanges& unknowns,
                        BlockRows<Eigen::Matrix<double, m, m>>& rows) {
  const auto owner_of = [&](const int node) { return unknowns.owner_of(m * node); };
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (own.have(first.number(i))) continue;
    auto& row = rows[first.number(i)];
    for (std::size_t j = 0; j < second.size(); ++j)
      if (second.number(j) >= first.number(i) ||
          owner_of(first.number(i)) != owner_of(second.number(j)))
        row.at(second.number(j)).noalias() += first.block(i).transpose() * second.block(j);
  }
}

/// What other ranks add to rows of this one, for what it adds to theirs.
template <int n, int m>
BlockRows<Eigen::Matrix<double, m, m>> received_rows(const Factors<n, m>& factors,
                                                     const UnknownRanges& unknowns,
                                                     const MPI_Comm communicator) {
  const OwnNodes own(unknowns, m);
  const std::vector<bool> is_at_others = factors.nodes_with_columns_beyond(own);
  BlockRows<Eigen::Matrix<double, m, m>> rows;
  Row<n, m> right;
  for (std::size_t node = 0; node < factors.n_nodes(); ++node) {
    if (!is_at_others[node] || factors.left(node).size() == 0) continue;
    factors.find_right(node, right);
    add_rows_of_others(factors.left(node), right, own, unknowns, rows);
    add_rows_of_others(right, factors.left(node), own, unknowns, rows);
  }
  send_to_owners(rows, own, unknowns, communicator);
  return rows;
}

/// Of the products and of what was received; each node is coupled to itself at least.
template <int n, int m>
NodePattern pattern_of(const Factors<n, m>& factors,
                       const BlockRows<Eigen::Matrix<double, m, m>>& received,
                       const UnknownRanges& unknowns) {
  const OwnNodes own(unknowns, m);
  std::vector<std::vector<int>> coupled;
  for (int node = own.first; node < own.end; ++node) coupled.push_back({node});
  const auto couple = [&](const int row, const int column) {
    if (own.have(row)) add_once(coupled[static_cast<std::size_t>(row - own.first)], column);
  };
  std::vector<int> columns;
  for (std::size_t node = 0; node < factors.n_nodes(); ++node) {
    if (factors.left(node).size() == 0) continue;
    factors.find_columns(node, columns);
    for (const int row : factors.left(node).numbers())
      for (const int column : columns) {
        couple(row, column);
        couple(column, row);
      }
  }
  for (const auto& [node, row] : received)
    for (const int column : row.numbers()) {
      couple(node, column);
      couple(column, node);
    }
  return {unknowns, m, coupled};
}

/// Adds first^T second to the rows of this rank's nodes.
template <int n, int m>
void add_own_rows(const Row<n, m>& first, const Row<n, m>& second, SymmetricMatrix<m>& coarse) {
  const NodePattern& pattern = coarse.pattern();
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (!pattern.own().have(first.number(i))) continue;
    const int row = pattern.place_of(first.number(i));
    for (std::size_t j = 0; j < second.size(); ++j)
      if (const int place = pattern.place_of(second.number(j)); place >= row)
        coarse.upper_block(static_cast<std::size_t>(row), place).noalias() +=
            first.block(i).transpose() * second.block(j);
  }
}

template <int n, int m>
void add(const Factors<n, m>& factors, SymmetricMatrix<m>& coarse) {
  Row<n, m> right;
  for (std::size_t node = 0; node < factors.n_nodes(); ++node) {
    if (factors.left(node).size() == 0) continue;
    factors.find_right(node, right);
    add_own_rows(factors.left(node), right, coarse);
    add_own_rows(right, factors.left(node), coarse);
  }
}

}  // namespace

template <int n, int m>
SymmetricMatrix<m> coarse_matrix(const SymmetricMatrix<n>& matrix,
                                 const NodeMatrix<n, m>& prolongation,
                                 const MPI_Comm communicator) {
  const Factors<n, m> factors(matrix, prolongation, communicator);
  const UnknownRanges& unknowns = prolongation.pattern().unknowns();
  const auto received = received_rows(factors, unknowns, communicator);
  SymmetricMatrix<m> coarse(pattern_of(factors, received, unknowns));
  add(factors, coarse);
  coarse.add(received);
  return coarse;
}

template SymmetricMatrix<3> coarse_matrix(const SymmetricMatrix<2>&, const NodeMatrix<2, 3>&,
                                          MPI_Comm);
template SymmetricMatrix<3> coarse_matrix(const SymmetricMatrix<3>&, const NodeMatrix<3, 3>&,
                                          MPI_Comm);
template SymmetricMatrix<6> coarse_matrix(const SymmetricMatrix<3>&, const NodeMatrix<3, 6>&,
                                          MPI_Comm);
template SymmetricMatrix<6> coarse_matrix(const SymmetricMatrix<6>&, const NodeMatrix<6, 6>&,
                                          MPI_Comm);

}  // namespace geneva::fem
