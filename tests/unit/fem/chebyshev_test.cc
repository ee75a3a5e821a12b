#include "fem/linear/multigrid/chebyshev.h"

#include <gtest/gtest.h>

#include <vector>

namespace geneva::fem::test {
namespace {

/// Two nodes on each rank, each with the same stiffness and coupled to no other: scaled by its
/// diagonal, the matrix has the eigenvalues 1/2, 3/2 and 1.
SymmetricMatrix<3> pairs() {
  const UnknownRanges unknowns(6, MPI_COMM_WORLD);
  const int first = unknowns.first() / 3;
  SymmetricMatrix<3> matrix(NodePattern(unknowns, 3, {{first}, {first + 1}}));
  for (std::size_t node = 0; node < 2; ++node)
    matrix.diagonal_block(node) << 4., 2., 0., 2., 4., 0., 0., 0., 4.;
  return matrix;
}

/// The eigenvector of an eigenvalue.
Vector eigenvector(const SymmetricMatrix<3>& matrix, const double eigenvalue) {
  Vector result(matrix.pattern().unknowns().own(), MPI_COMM_WORLD);
  for (const auto i : result.locally_owned_elements())
    result(i) = i % 3 == 2 ? 0. : i % 3 == 0 || eigenvalue > 1. ? 1. : -1.;
  result.compress(dealii::VectorOperation::insert);
  return result;
}

/// By which an iteration of degree two multiplies the error of an eigenvector: T2((theta -
/// lambda)/delta)/T2(theta/delta), where T2(x) = 2 x^2 - 1.
double factor(const double eigenvalue, const double lowest, const double highest) {
  const double centre = (highest + lowest) / 2.;
  const double half_width = (highest - lowest) / 2.;
  const auto t2 = [](const double x) { return 2. * x * x - 1.; };
  return t2((centre - eigenvalue) / half_width) / t2(centre / half_width);
}

TEST(Chebyshev, MultipliesErrorsByItsPolynomial) {
  const SymmetricMatrix<3> matrix = pairs();
  const Chebyshev<SymmetricMatrix<3>> iteration(matrix, 0.3, 1.6);
  for (const double eigenvalue : {0.5, 1.5}) {
    const Vector solution = eigenvector(matrix, eigenvalue);
    Vector load(solution);
    matrix.vmult(load, solution);
    Vector from_zero(load);
    iteration.solve(from_zero, load);
    from_zero.add(factor(eigenvalue, 0.3, 1.6) - 1., solution);
    EXPECT_LT(from_zero.linfty_norm(), 1e-14);
    Vector improved(solution);
    improved *= 3.;
    iteration.improve(improved, load);
    improved.add(-1. - 2. * factor(eigenvalue, 0.3, 1.6), solution);
    EXPECT_LT(improved.linfty_norm(), 1e-14);
  }
}

/// Beyond the eigenvalues that it is made for the polynomial grows: from a tenth above them on it
/// magnifies errors.
TEST(Chebyshev, MagnifiesErrorsFarBeyondItsRange) {
  const SymmetricMatrix<3> matrix = pairs();
  const auto maximum_factor = [&](const double highest) {
    const Chebyshev<SymmetricMatrix<3>> iteration(matrix, highest / 10., highest);
    const Vector solution = eigenvector(matrix, 1.5);
    Vector load(solution);
    matrix.vmult(load, solution);
    Vector error(load);
    iteration.solve(error, load);
    error -= solution;
    return error.linfty_norm();
  };
  EXPECT_NEAR(maximum_factor(1.5), 81. / 161., 1e-14) << "1/T2(11/9)";
  EXPECT_NEAR(maximum_factor(1.5 / 1.1), 1., 1e-14) << "T2(11/9)/T2(11/9)";
  EXPECT_GT(maximum_factor(1.5 / 1.6), 4.);
}

TEST(LargestEigenvalue, OfTheScaledMatrixIsFound) {
  Vector vector;
  EXPECT_NEAR(largest_eigenvalue(pairs(), MPI_COMM_WORLD, vector), 1.5, 1e-4);
}

/// The error is that of the vector squared, which a step takes to two thirds.
TEST(LargestEigenvalue, SearchGoesOnFromItsVector) {
  Vector vector;
  const double error = 1.5 - largest_eigenvalue(pairs(), MPI_COMM_WORLD, vector);
  EXPECT_NEAR(1.5 - largest_eigenvalue(pairs(), vector, 1), 4. / 9. * error, 0.01 * error);
}

}  // namespace
}  // namespace geneva::fem::test
