#include "mesh/dense_algebra.h"

#include <Eigen/Dense>

namespace geneva::mesh {

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values) {
  return matrix.colPivHouseholderQr().solve(values);
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
