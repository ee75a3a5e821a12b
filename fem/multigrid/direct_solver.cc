#include "fem/multigrid/direct_solver.h"

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

#include <vector>

namespace geneva::fem {

namespace {

template <int n>
using SquareRow = BlockRow<Eigen::Matrix<double, n, n>>;
using Entries = std::vector<Eigen::Triplet<double>>;

/// Rows of this rank's nodes, up to the diagonal.
template <int n>
std::vector<SquareRow<n>> own_rows(const SymmetricMatrix<n>& matrix) {
  const NodePattern& pattern = matrix.pattern();
  std::vector<SquareRow<n>> rows(pattern.n_rows());
  matrix.visit_blocks([&](const std::size_t node, const std::size_t place, const auto& block) {
    if (pattern.number(place) <= pattern.number(node)) rows[node].at(pattern.number(place)) = block;
  });
  return rows;
}

std::vector<int> nodes_of_others(const OwnNodes& own, const int n_nodes) {
  std::vector<int> result;
  for (int node = 0; node < n_nodes; ++node)
    if (!own.have(node)) result.push_back(node);
  return result;
}

template <int n>
void add_entries(const int node, const SquareRow<n>& row, Entries& entries) {
  for (std::size_t k = 0; k < row.size(); ++k)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        entries.emplace_back(n * node + i, n * row.number(k) + j, row.block(k)(i, j));
}

/// The lower part, with all ranks' rows.
template <int n>
Eigen::SparseMatrix<double> whole(const SymmetricMatrix<n>& matrix, const MPI_Comm communicator) {
  const OwnNodes& own = matrix.pattern().own();
  const int n_unknowns = matrix.unknowns().NumGlobalElements();
  const std::vector<int> others = nodes_of_others(own, n_unknowns / n);
  const std::vector<SquareRow<n>> rows = own_rows(matrix);
  const std::vector<SquareRow<n>> received =
      rows_of_others(rows, others, matrix.unknowns(), n, communicator);
  Entries entries;
  for (std::size_t i = 0; i < rows.size(); ++i)
    add_entries<n>(own.first + static_cast<int>(i), rows[i], entries);
  for (std::size_t i = 0; i < others.size(); ++i) add_entries<n>(others[i], received[i], entries);
  Eigen::SparseMatrix<double> result(n_unknowns, n_unknowns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

template <int n>
DirectSolver<n>::DirectSolver(const SymmetricMatrix<n>& matrix, const MPI_Comm communicator)
    : communicator_(communicator),
      first_(n * matrix.pattern().own().first),
      n_own_(matrix.unknowns().NumMyElements()),
      factors_(whole(matrix, communicator)) {}

template <int n>
void DirectSolver<n>::vmult(Vector& solution, const Vector& right_hand_side) const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(factors_.rows());
  values.segment(first_, n_own_) =
      Eigen::Map<const Eigen::VectorXd>(right_hand_side.trilinos_vector()[0], n_own_);
  const dealii::ArrayView<double> view(values.data(), static_cast<std::size_t>(values.size()));
  dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(view), communicator_, view);
  values = factors_.solve(values).eval();
  Eigen::Map<Eigen::VectorXd>(solution.trilinos_vector()[0], n_own_) =
      values.segment(first_, n_own_);
}

template class DirectSolver<3>;
template class DirectSolver<6>;

}  // namespace geneva::fem
