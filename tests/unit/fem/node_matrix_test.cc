#include "fem/linear/multigrid/node_matrix.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fem/linear/multigrid/algebraic_multigrid.h"
#include "fem/linear/multigrid/direct_solver.h"

namespace geneva::fem::test {
namespace {

UnknownRanges unknowns(const int of_each) { return {2 * of_each, MPI_COMM_WORLD}; }

/// Two nodes on each rank, in a ring with those of the others.
std::vector<std::vector<int>> ring(const UnknownRanges& map, const int of_each) {
  const int n_nodes = map.n_all() / of_each;
  const int first = map.first() / of_each;
  std::vector<std::vector<int>> coupled{{first, first + 1}, {first, first + 1}};
  if (n_nodes > 2) {
    coupled[0].push_back((first + n_nodes - 1) % n_nodes);
    coupled[1].push_back((first + 2) % n_nodes);
  }
  return coupled;
}

/// Values that look random and are the same on any number of ranks.
Vector some_vector(const UnknownRanges& map, const double seed) {
  Vector result(map.own(), MPI_COMM_WORLD);
  for (const auto i : result.locally_owned_elements())
    result(i) = std::sin(seed * (1. + static_cast<double>(i)));
  result.compress(dealii::VectorOperation::insert);
  return result;
}

TEST(NodeMatrix, TransposedProductIsTheAdjoint) {
  const UnknownRanges columns = unknowns(6);
  NodeMatrix<3, 6> matrix(NodePattern(columns, 6, ring(columns, 6)));
  for (std::size_t i = 0; i < matrix.pattern().n_blocks(); ++i)
    for (int entry = 0; entry < 18; ++entry)
      matrix.block(i).data()[entry] = std::cos(1. + static_cast<double>(18 * i) + entry);
  const Vector of_columns = some_vector(columns, 0.7);
  const Vector of_rows = some_vector(unknowns(3), 1.9);
  Vector product(of_rows);
  product = 0.;
  Vector transposed(of_columns);
  matrix.vmult_add(product, of_columns);
  matrix.Tvmult(transposed, of_rows);
  EXPECT_NEAR(product * of_rows, transposed * of_columns, 1e-12);
  EXPECT_GT(product.linfty_norm(), 0.1);
}

/// A positive definite one, along the ring.
SymmetricMatrix<3> ring_matrix(const UnknownRanges& map) {
  SymmetricMatrix<3> matrix(NodePattern(map, 3, ring(map, 3)));
  const NodePattern& pattern = matrix.pattern();
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t i = pattern.block(row, static_cast<int>(row));
         i < pattern.first_block(row + 1); ++i)
      matrix.upper_block(row, pattern.place(i)) << 1., 0.2, 0.1, 0.2, 1., 0.3, 0.1, 0.3, 1.;
  for (std::size_t row = 0; row < 2; ++row) matrix.diagonal_block(row) *= 8.;
  return matrix;
}

TEST(DirectSolver, SolvesOnAnyNumberOfRanks) {
  const UnknownRanges map = unknowns(3);
  const SymmetricMatrix<3> matrix = ring_matrix(map);
  const Vector solution = some_vector(map, 0.7);
  Vector load(solution);
  matrix.vmult(load, solution);
  Vector found(solution);
  DirectSolver<3>(matrix, Elimination(matrix.unknowns(), {}), MPI_COMM_WORLD).vmult(found, load);
  found -= solution;
  EXPECT_LT(found.linfty_norm(), 1e-14);
}

TEST(DirectSolver, TellsOfAMatrixThatIsNotPositiveDefinite) {
  const UnknownRanges map = unknowns(3);
  SymmetricMatrix<3> matrix = ring_matrix(map);
  const Elimination none(map, {});
  EXPECT_TRUE(DirectSolver<3>(matrix, none, MPI_COMM_WORLD).is_definite());
  matrix.diagonal_block(0)(1, 1) = -1.;
  EXPECT_FALSE(DirectSolver<3>(matrix, none, MPI_COMM_WORLD).is_definite());
}

TEST(AlgebraicMultigrid, SolvesWhatHasNoMoreUnknownsThanAreFactorised) {
  const UnknownRanges map = unknowns(3);
  const Vector solution = some_vector(map, 0.7);
  const auto error = [&](const int most_for_factors) {
    const double x = map.first();
    const AlgebraicMultigrid<2> multigrid({ring_matrix(map), {{x, 0.}, {x + 1., 0.2}}, {0, 0}},
                                          most_for_factors, MPI_COMM_WORLD);
    Vector load(solution);
    ring_matrix(map).vmult(load, solution);
    Vector found(solution);
    multigrid.vmult(found, load);
    found -= solution;
    return found.linfty_norm();
  };
  const int n_unknowns = map.n_all();
  EXPECT_LT(error(n_unknowns), 1e-9);  // the matrix is shifted by 1e-10
  EXPECT_GT(error(n_unknowns - 1), 1e-6);
}

}  // namespace
}  // namespace geneva::fem::test
