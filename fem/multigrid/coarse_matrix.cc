#include "fem/multigrid/coarse_matrix.h"

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

/// Of the row of a node in A P so much that P^T times it, added to its transpose, is P^T A P.
template <int n, int m>
Row<n, m> half_of_product(const std::size_t node, const SymmetricMatrix<n>& matrix,
                          const std::vector<Row<n, m>>& prolongation) {
  Row<n, m> result;
  matrix.visit_upper(node, [&](const std::size_t place, const auto& block) {
    // The diagonal is its own transpose, and of other ranks' nodes these have the transpose.
    const bool is_shared = place == node || place >= matrix.pattern().n_rows();
    const Row<n, m>& row = prolongation[place];
    for (std::size_t j = 0; j < row.size(); ++j)
      result.at(row.number(j)).noalias() += (is_shared ? 0.5 : 1.) * block * row.block(j);
  });
  return result;
}

/// A matrix and its transpose: of two blocks of own nodes that above the diagonal.
template <int m>
BlockRows<Eigen::Matrix<double, m, m>> with_transpose(
    const BlockRows<Eigen::Matrix<double, m, m>>& rows, const OwnNodes& own) {
  BlockRows<Eigen::Matrix<double, m, m>> result;
  for (const auto& [number, row] : rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int other = row.number(i);
      const bool are_own = own.have(number) && own.have(other);
      if (!are_own || number <= other) result[number].at(other) += row.block(i);
      if (!are_own || other <= number) result[other].at(number) += row.block(i).transpose();
    }
  return result;
}

}  // namespace

template <int n, int m>
SymmetricMatrix<m> coarse_matrix(const SymmetricMatrix<n>& matrix,
                                 const NodeMatrix<n, m>& prolongation,
                                 const MPI_Comm communicator) {
  const auto rows = rows_of(prolongation, matrix.pattern(), communicator);
  BlockRows<Eigen::Matrix<double, m, m>> result;
  for (std::size_t node = 0; node < matrix.pattern().n_rows(); ++node) {
    const Row<n, m>& left = rows[node];
    if (left.size() == 0) continue;
    const Row<n, m> right = half_of_product(node, matrix, rows);
    for (std::size_t i = 0; i < left.size(); ++i) {
      auto& row = result[left.number(i)];
      for (std::size_t j = 0; j < right.size(); ++j)
        row.at(right.number(j)).noalias() += left.block(i).transpose() * right.block(j);
    }
  }
  const Epetra_Map& unknowns = prolongation.pattern().unknowns();
  return sum_of_rows<m>(with_transpose<m>(result, OwnNodes(unknowns, m)), unknowns, communicator);
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
