#pragma once

#include <Eigen/Core>
#include <optional>

namespace geneva::mesh {

// Each of Eigen's decompositions costs 5 to 15 s of compile time in every source file that names
// it; here each is compiled once.

/// The x of minimum |A x - b| (Householder's QR with column pivoting; Golub and Van Loan, 5.4).
/// @param matrix A, at least as many rows as columns
/// @param values b
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values);

/// The x >= 0 of minimum |A x - b|, by active sets (C. L. Lawson and R. J. Hanson, Solving Least
/// Squares Problems, 1974, 23.3).
/// @param matrix A, of any shape
/// @param values b
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& matrix,
                                          const Eigen::VectorXd& values);

struct Eigenpairs {
  Eigen::VectorXd values;   // ascending
  Eigen::MatrixXd vectors;  // orthonormal columns
};

/// @param matrix symmetric
Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& matrix);

/// Inverse by LU with full pivoting; nothing if the reciprocal condition number is not above a
/// limit.
/// @param matrix square
std::optional<Eigen::MatrixXd> inverse(const Eigen::MatrixXd& matrix,
                                       double minimum_reciprocal_condition);

}  // namespace geneva::mesh
