#include "fem/multigrid/chebyshev.h"

#include <Epetra_MpiComm.h>
#include <gtest/gtest.h>

#include <vector>

namespace geneva::fem::test {
namespace {

using Vector = dealii::TrilinosWrappers::MPI::Vector;

/// Two nodes on each rank, each with the same stiffness and coupled to no other: scaled by its
/// diagonal, the matrix has the eigenvalues 1/2, 3/2 and 1.
SymmetricMatrix<3> pairs() {
  const Epetra_MpiComm communicator(MPI_COMM_WORLD);
  const Epetra_Map unknowns(-1, 6, 0, communicator);
  const int first = unknowns.MinMyGID() / 3;
  SymmetricMatrix<3> matrix(NodePattern(unknowns, 3, {{first}, {first + 1}}));
  for (std::size_t node = 0; node < 2; ++node)
    matrix.diagonal_block(node) << 4., 2., 0., 2., 4., 0., 0., 0., 4.;
  return matrix;
}

/// The eigenvector of an eigenvalue.
Vector eigenvector(const SymmetricMatrix<3>& matrix, const double eigenvalue) {
  Vector result(dealii::IndexSet(matrix.pattern().unknowns()), MPI_COMM_WORLD);
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

TEST(LargestEigenvalue, OfTheScaledMatrixIsFound) {
  EXPECT_NEAR(largest_eigenvalue(pairs(), MPI_COMM_WORLD), 1.5, 1e-4);
}

}  // namespace
}  // namespace geneva::fem::test
