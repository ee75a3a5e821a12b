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

/// A P at one node.
template <int n, int m>
Row<n, m> product_row(const std::size_t node, const NodeMatrix<n>& matrix,
                      const std::vector<Row<n, m>>& prolongation) {
  Row<n, m> result;
  const NodePattern& pattern = matrix.pattern();
  for (std::size_t i = pattern.first_block(node); i < pattern.first_block(node + 1); ++i) {
    const Row<n, m>& row = prolongation[static_cast<std::size_t>(pattern.place(i))];
    for (std::size_t j = 0; j < row.size(); ++j)
      result.at(row.number(j)).noalias() += matrix.block(i) * row.block(j);
  }
  return result;
}

}  // namespace

template <int n, int m>
NodeMatrix<m> coarse_matrix(const NodeMatrix<n>& matrix, const NodeMatrix<n, m>& prolongation,
                            const MPI_Comm communicator) {
  const auto rows = rows_of(prolongation, matrix.pattern(), communicator);
  BlockRows<Eigen::Matrix<double, m, m>> result;
  for (std::size_t node = 0; node < matrix.pattern().n_rows(); ++node) {
    const Row<n, m>& left = rows[node];
    if (left.size() == 0) continue;
    const Row<n, m> right = product_row(node, matrix, rows);
    for (std::size_t i = 0; i < left.size(); ++i) {
      auto& row = result[left.number(i)];
      for (std::size_t j = 0; j < right.size(); ++j)
        row.at(right.number(j)).noalias() += left.block(i).transpose() * right.block(j);
    }
  }
  return sum_of_rows<m>(std::move(result), prolongation.pattern().unknowns(), communicator);
}

template NodeMatrix<3> coarse_matrix(const NodeMatrix<2>&, const NodeMatrix<2, 3>&, MPI_Comm);
template NodeMatrix<3> coarse_matrix(const NodeMatrix<3>&, const NodeMatrix<3>&, MPI_Comm);
template NodeMatrix<6> coarse_matrix(const NodeMatrix<3>&, const NodeMatrix<3, 6>&, MPI_Comm);
template NodeMatrix<6> coarse_matrix(const NodeMatrix<6>&, const NodeMatrix<6>&, MPI_Comm);

}  // namespace geneva::fem
