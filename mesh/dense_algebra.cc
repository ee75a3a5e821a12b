#include "mesh/dense_algebra.h"

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

namespace geneva::mesh {

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values) {
  return matrix.colPivHouseholderQr().solve(values);
}

namespace {

/// The passive set of Lawson and Hanson: columns whose factors are free, the others' are 0.
class FreeColumns {
 public:
  FreeColumns(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values)
      : matrix_(matrix), values_(values), x_(Eigen::VectorXd::Zero(matrix.cols())) {}

  /// Frees the column along which the residual falls most.
  /// @return whether there is one
  bool free_next() {
    const Eigen::VectorXd fall = matrix_.transpose() * (values_ - matrix_ * x_);
    std::optional<Eigen::Index> next;
    double most = round_off * values_.norm();
    for (Eigen::Index j = 0; j < fall.size(); ++j) {
      const double rate = fall(j) / matrix_.col(j).norm();
      if (!(rate > most) || std::count(columns_.begin(), columns_.end(), j) > 0) continue;
      most = rate;
      next = j;
    }
    if (next) columns_.push_back(*next);
    return next.has_value();
  }

  /// Goes to the least squares of the free columns, which lose those whose factors reach 0 before.
  void settle() {
    while (!columns_.empty()) {
      const Eigen::VectorXd wanted = least_squares(chosen(), values_);
      double share = 1.;
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        const double to = wanted(static_cast<Eigen::Index>(k));
        const double from = x_(columns_[k]);
        if (to <= 0.) share = std::min(share, from / (from - to));
      }
      for (std::size_t k = 0; k < columns_.size(); ++k)
        x_(columns_[k]) += share * (wanted(static_cast<Eigen::Index>(k)) - x_(columns_[k]));
      if (share >= 1.) return;
      drop_zeros();
    }
  }

  [[nodiscard]] const Eigen::VectorXd& x() const { return x_; }

 private:
  static constexpr double round_off = 1e-12;

  [[nodiscard]] Eigen::MatrixXd chosen() const {
    Eigen::MatrixXd result(matrix_.rows(), columns_.size());
    for (std::size_t k = 0; k < columns_.size(); ++k)
      result.col(static_cast<Eigen::Index>(k)) = matrix_.col(columns_[k]);
    return result;
  }

  void drop_zeros() {
    const double zero = round_off * x_.maxCoeff();
    const auto is_zero = [&](const Eigen::Index j) { return x_(j) <= zero; };
    for (const Eigen::Index j : columns_)
      if (is_zero(j)) x_(j) = 0.;
    columns_.erase(std::remove_if(columns_.begin(), columns_.end(), is_zero), columns_.end());
  }

  const Eigen::MatrixXd& matrix_;
  const Eigen::VectorXd& values_;
  Eigen::VectorXd x_;
  std::vector<Eigen::Index> columns_;
};

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& matrix,
                                          const Eigen::VectorXd& values) {
  FreeColumns free_columns(matrix, values);
  const Eigen::Index most_steps = 3 * matrix.cols();  // as they advise
  for (Eigen::Index step = 0; step < most_steps && free_columns.free_next(); ++step)
    free_columns.settle();
  return free_columns.x();
}

Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

std::optional<Eigen::MatrixXd> inverse(const Eigen::MatrixXd& matrix,
                                       const double minimum_reciprocal_condition) {
  const Eigen::FullPivLU<Eigen::MatrixXd> factors(matrix);
  if (factors.rcond() <= minimum_reciprocal_condition) return std::nullopt;
  return factors.inverse();
}

}  // namespace geneva::mesh
