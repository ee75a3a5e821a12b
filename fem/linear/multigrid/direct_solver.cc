#include "fem/linear/multigrid/direct_solver.h"

#include <deal.II/base/mpi.h>

#include <cstddef>
#include <numeric>
#include <vector>

#include "fem/discretisation/gather.h"
#include "fem/linear/multigrid/condensed_entries.h"

namespace geneva::fem {

namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

/// The entries of all ranks, on every rank or the first one alone.
Entries collected(const Entries& own, const bool is_everywhere, const MPI_Comm communicator) {
  return is_everywhere ? gathered(communicator, own) : gathered_on_first(communicator, own);
}

Eigen::SparseMatrix<double> matrix_of(const Entries& entries, const int n_unknowns) {
  Eigen::SparseMatrix<double> result(n_unknowns, n_unknowns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

template <int n>
DirectSolver<n>::DirectSolver(const SymmetricMatrix<n>& matrix, const Elimination& elimination,
                              const MPI_Comm communicator, const int most_everywhere)
    : communicator_(communicator),
      is_first_(dealii::Utilities::MPI::this_mpi_process(communicator) == 0),
      is_everywhere_(matrix.unknowns().n_all() <= most_everywhere),
      n_unknowns_(matrix.unknowns().n_all()),
      n_own_(matrix.unknowns().n_own()),
      counts_(gathered_one(communicator, n_own_)),
      firsts_(counts_.size() + 1, 0) {
  std::partial_sum(counts_.begin(), counts_.end(), firsts_.begin() + 1);
  factors_.cholmod().print = 0;  // a matrix that is not definite is for the caller to report
  const Entries entries =
      collected(condensed_entries(matrix, elimination), is_everywhere_, communicator);
  if (has_factors()) factors_.compute(matrix_of(entries, n_unknowns_));
  is_definite_ = dealii::Utilities::MPI::logical_or(
      has_factors() && factors_.info() == Eigen::Success, communicator);
}

template <int n>
void DirectSolver<n>::vmult(Vector& solution, const Vector& right_hand_side) const {
  const double* const own = right_hand_side.begin();
  Eigen::Map<Eigen::VectorXd>(solution.begin(), n_own_) =
      is_everywhere_ ? solved_everywhere(own) : solved_by_first(own);
}

template <int n>
Eigen::VectorXd DirectSolver<n>::solved_everywhere(const double* const own) const {
  Eigen::VectorXd values(n_unknowns_);
  MPI_Allgatherv(own, n_own_, MPI_DOUBLE, values.data(), counts_.data(), firsts_.data(), MPI_DOUBLE,
                 communicator_);
  values = factors_.solve(values).eval();
  return values.segment(
      firsts_[static_cast<std::size_t>(dealii::Utilities::MPI::this_mpi_process(communicator_))],
      n_own_);
}

template <int n>
Eigen::VectorXd DirectSolver<n>::solved_by_first(const double* const own) const {
  Eigen::VectorXd values(is_first_ ? n_unknowns_ : 0);
  MPI_Gatherv(own, n_own_, MPI_DOUBLE, values.data(), counts_.data(), firsts_.data(), MPI_DOUBLE, 0,
              communicator_);
  if (is_first_) values = factors_.solve(values).eval();
  Eigen::VectorXd result(n_own_);
  MPI_Scatterv(values.data(), counts_.data(), firsts_.data(), MPI_DOUBLE, result.data(), n_own_,
               MPI_DOUBLE, 0, communicator_);
  return result;
}

template class DirectSolver<2>;
template class DirectSolver<3>;
template class DirectSolver<6>;

}  // namespace geneva::fem
