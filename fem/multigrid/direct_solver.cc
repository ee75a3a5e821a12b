#include "fem/multigrid/direct_solver.h"

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

#include <vector>

#include "fem/gather.h"

namespace geneva::fem {

namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

/// Adds s A_ij s' below the diagonal and on it for the shares s and s' that two unknowns have in
/// others.
void add_shares(const Shares& row, const Shares& column, const double stiffness, Entries& entries) {
  for (const auto& [i, share] : row)
    for (const auto& [j, other] : column)
      if (i >= j) entries.emplace_back(i, j, share * stiffness * other);
}

/// What this rank's rows of A add to the lower part of E^T A E.
template <int n>
Entries own_entries(const SymmetricMatrix<n>& matrix, const Elimination& elimination) {
  const NodePattern& pattern = matrix.pattern();
  Entries entries;
  entries.reserve(n * n * pattern.n_blocks());
  matrix.visit_blocks([&](const std::size_t node, const std::size_t place, const auto& block) {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int row = n * pattern.number(node) + i;
        const int column = n * pattern.number(place) + j;
        const Shares* const of_row = elimination.shares_of(row);
        const Shares* const of_column = elimination.shares_of(column);
        if (of_row == nullptr && of_column == nullptr) {
          if (row >= column) entries.emplace_back(row, column, block(i, j));
          continue;
        }
        add_shares(of_row ? *of_row : Shares{{row, 1.}},
                   of_column ? *of_column : Shares{{column, 1.}}, block(i, j), entries);
        if (row == column) entries.emplace_back(row, row, block(i, i));
      }
  });
  return entries;
}

/// The lower part of E^T A E, with all ranks' rows.
template <int n>
Eigen::SparseMatrix<double> whole(const SymmetricMatrix<n>& matrix, const Elimination& elimination,
                                  const MPI_Comm communicator) {
  const Entries entries = gathered(communicator, own_entries(matrix, elimination));
  const int n_unknowns = matrix.unknowns().NumGlobalElements();
  Eigen::SparseMatrix<double> result(n_unknowns, n_unknowns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

template <int n>
DirectSolver<n>::DirectSolver(const SymmetricMatrix<n>& matrix, const Elimination& elimination,
                              const MPI_Comm communicator)
    : communicator_(communicator),
      first_(n * matrix.pattern().own().first),
      n_own_(matrix.unknowns().NumMyElements()) {
  factors_.cholmod().print = 0;  // a matrix that is not definite is for the caller to report
  factors_.compute(whole(matrix, elimination, communicator));
}

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

template class DirectSolver<2>;
template class DirectSolver<3>;
template class DirectSolver<6>;

}  // namespace geneva::fem
