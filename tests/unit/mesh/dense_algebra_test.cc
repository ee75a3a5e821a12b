#include "mesh/dense_algebra.h"

#include <gtest/gtest.h>

#include <random>

namespace geneva::mesh {
namespace {

TEST(NonnegativeLeastSquares, LeavesWhatOnlyNegativeFactorsCouldGive) {
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(2, 2);
  EXPECT_EQ(nonnegative_least_squares(unit, Eigen::Vector2d(1., -1.)), Eigen::Vector2d(1., 0.));
  EXPECT_EQ(nonnegative_least_squares(unit, Eigen::Vector2d(-1., 0.)), Eigen::Vector2d(0., 0.));
}

/// Karush, Kuhn and Tucker: the residual falls along no column, and not at all along those in use.
TEST(NonnegativeLeastSquares, FulfilsTheConditionsOfAMinimum) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int seed = 0; seed < 200; ++seed) {
    const Eigen::Index rows = 1 + seed % 7;
    const Eigen::Index columns = 1 + seed % 40;
    const auto draw = [&](const Eigen::Index) { return normal(random); };
    Eigen::MatrixXd matrix(rows, columns);
    for (Eigen::Index j = 0; j < columns; ++j)
      for (Eigen::Index i = 0; i < rows; ++i) matrix(i, j) = draw(i);
    const Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(rows, draw);
    const Eigen::VectorXd x = nonnegative_least_squares(matrix, values);
    const Eigen::VectorXd fall = matrix.transpose() * (values - matrix * x);
    for (Eigen::Index j = 0; j < columns; ++j) {
      EXPECT_GE(x(j), 0.);
      EXPECT_LE(fall(j), 1e-10);
      EXPECT_NEAR(x(j) > 0. ? fall(j) : 0., 0., 1e-10);
    }
  }
}

}  // namespace
}  // namespace geneva::mesh
