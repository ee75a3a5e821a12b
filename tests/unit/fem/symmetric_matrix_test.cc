#include "fem/linear/multigrid/symmetric_matrix.h"

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
    for (int column = 0; column < unknowns().n_all(); ++column)
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
  const int first_row = unknowns().first();
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
  const int first = unknowns().first();
  ASSERT_EQ(diagonal.size(), static_cast<std::size_t>(n_own_unknowns));
  for (int i = 0; i < n_own_unknowns; ++i)
    EXPECT_NEAR(diagonal[static_cast<std::size_t>(i)], entry(first + i, first + i), 1e-15);
}

TEST(SymmetricMatrix, TakesOfAddedRowsWhatIsAboveTheDiagonal) {
  BlockRows<Eigen::Matrix3d> rows;
  const int first = unknowns().first() / 3;
  rows[first].at(first) = 7. * Eigen::Matrix3d::Identity();
  rows[first].at(first + 1) << 1., 2., 3., 4., 5., 6., 7., 8., 9.;
  rows[first + 1].at(first) = rows[first].at(first + 1).transpose();
  SymmetricMatrix<3> matrix = whole();
  matrix.add(rows);
  const SymmetricMatrix<3> before = whole();
  EXPECT_EQ(matrix.block(0, 0), before.block(0, 0) + 7. * Eigen::Matrix3d::Identity());
  EXPECT_EQ(matrix.block(0, 1), before.block(0, 1) + rows[first].at(first + 1));
  EXPECT_EQ(matrix.block(1, 0), before.block(1, 0) + rows[first + 1].at(first));
  EXPECT_EQ(matrix.block(1, 1), before.block(1, 1));
}

}  // namespace
}  // namespace geneva::fem::test
