#include "fem/multigrid/direct_solver.h"

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

namespace geneva::fem {

namespace {

/// Sums over the ranks, in place.
template <typename Dense>
void sum(Dense& values, const MPI_Comm communicator) {
  const dealii::ArrayView<double> view(values.data(), static_cast<std::size_t>(values.size()));
  dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(view), communicator, view);
}

template <int n>
Eigen::MatrixXd whole(const SymmetricMatrix<n>& matrix, const MPI_Comm communicator) {
  const NodePattern& pattern = matrix.pattern();
  const Eigen::Index size = pattern.unknowns().NumGlobalElements();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
  matrix.visit_blocks([&](const std::size_t row, const std::size_t place, const auto& block) {
    result.template block<n, n>(n * pattern.number(row), n * pattern.number(place)) = block;
  });
  sum(result, communicator);
  return result;
}

}  // namespace

template <int n>
DirectSolver<n>::DirectSolver(const SymmetricMatrix<n>& matrix, const MPI_Comm communicator)
    : communicator_(communicator),
      first_(n * matrix.pattern().own().first),
      n_own_(matrix.pattern().unknowns().NumMyElements()),
      factors_(whole(matrix, communicator)) {}

template <int n>
void DirectSolver<n>::vmult(Vector& solution, const Vector& right_hand_side) const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(factors_.rows());
  values.segment(first_, n_own_) =
      Eigen::Map<const Eigen::VectorXd>(right_hand_side.trilinos_vector()[0], n_own_);
  sum(values, communicator_);
  factors_.solveInPlace(values);
  Eigen::Map<Eigen::VectorXd>(solution.trilinos_vector()[0], n_own_) =
      values.segment(first_, n_own_);
}

template class DirectSolver<3>;
template class DirectSolver<6>;

}  // namespace geneva::fem
