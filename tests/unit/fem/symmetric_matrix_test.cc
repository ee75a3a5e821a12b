#include "fem/multigrid/symmetric_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/unit/fem/coupled_matrix.h"

namespace geneva::fem::test {
namespace {

/// Of whole().
double entry(const int row, const int column) {
  return std::cos(row) * std::cos(column) + (row == column ? 4. : 0.);
}

Vector expected_product() {
  return vector_of([](const int row) {
    double sum = 0.;
    for (int column = 0; column < unknowns().NumGlobalElements(); ++column)
      sum += entry(row, column) * some(column);
    return sum;
  });
}

TEST(SymmetricMatrix, MultipliesByBothHalves) {
  Vector difference = expected_product();
  Vector product(difference);
  whole().vmult(product, vector_of(some));
  EXPECT_GT(product.linfty_norm(), 1.);
  difference -= product;
  EXPECT_LT(difference.linfty_norm(), 1e-13);
}

TEST(SymmetricMatrix, GivesTheResidual) {
  Vector difference = expected_product();
  Vector residual(difference);
  whole().residual(residual, vector_of(some), vector_of(other));
  difference += residual;
  difference -= vector_of(other);
  EXPECT_LT(difference.linfty_norm(), 1e-13);
}

TEST(SymmetricMatrix, ShowsBlocksOfBothHalves) {
  const SymmetricMatrix<3> matrix = whole();
  const int first_row = unknowns().MinMyGID();
  std::vector<std::vector<std::size_t>> places(n_own_nodes);
  matrix.visit_blocks([&](const std::size_t row, const std::size_t place, const auto& block) {
    places[row].push_back(place);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(block(i, j),
                    entry(first_row + 3 * static_cast<int>(row) + i,
                          3 * matrix.pattern().number(place) + j),
                    1e-15);
    EXPECT_EQ(matrix.block(row, static_cast<int>(place)), block);
  });
  for (const auto& of_row : places) {
    EXPECT_EQ(of_row.size(), matrix.pattern().n_places());
    EXPECT_TRUE(std::is_sorted(of_row.begin(), of_row.end()));
  }
}

TEST(SymmetricMatrix, KnowsItsDiagonal) {
  const std::vector<double> diagonal = whole().diagonal();
  const int first = unknowns().MinMyGID();
  ASSERT_EQ(diagonal.size(), static_cast<std::size_t>(n_own_unknowns));
  for (int i = 0; i < n_own_unknowns; ++i)
    EXPECT_NEAR(diagonal[static_cast<std::size_t>(i)], entry(first + i, first + i), 1e-15);
}

/// Each rank gives the whole of a matrix: 1 + |i - j| in the blocks of nodes i and j.
TEST(SymmetricMatrix, SumsTheRowsOfAllRanks) {
  const Epetra_Map map = unknowns();
  const int n_nodes = map.NumGlobalElements() / 3;
  BlockRows<Eigen::Matrix3d> rows;
  for (int i = 0; i < n_nodes; ++i)
    for (int j = 0; j < n_nodes; ++j)
      rows[i].at(j) = Eigen::Matrix3d::Constant(1. + std::abs(i - j));
  const SymmetricMatrix<3> matrix = sum_of_rows<3>(std::move(rows), map, MPI_COMM_WORLD);
  const double n_ranks = n_nodes / n_own_nodes;
  std::size_t n_blocks = 0;
  matrix.visit_blocks([&](const std::size_t row, const std::size_t place, const auto& block) {
    const int distance = std::abs(matrix.pattern().number(row) - matrix.pattern().number(place));
    EXPECT_EQ(block, Eigen::Matrix3d::Constant(n_ranks * (1. + distance)).eval());
    ++n_blocks;
  });
  EXPECT_EQ(n_blocks, static_cast<std::size_t>(n_own_nodes * n_nodes));
}

}  // namespace
}  // namespace geneva::fem::test
