#include "fem/multigrid/symmetric_matrix.h"

#include <gtest/gtest.h>

#include "tests/unit/fem/coupled_matrix.h"

namespace geneva::fem::test {
namespace {

TEST(SymmetricMatrix, HasTheProductsOfTheWholeOne) {
  const SymmetricMatrix<3> symmetric(whole());
  const Vector load = vector_of(other);
  Vector expected(load);
  Vector found(load);
  whole().vmult(expected, vector_of(some));
  symmetric.vmult(found, vector_of(some));
  EXPECT_GT(found.linfty_norm(), 1.);
  found -= expected;
  EXPECT_LT(found.linfty_norm(), 1e-13);
  whole().residual(expected, vector_of(some), load);
  symmetric.residual(found, vector_of(some), load);
  found -= expected;
  EXPECT_LT(found.linfty_norm(), 1e-13);
}

TEST(SymmetricMatrix, HasTheDiagonalOfTheWholeOne) {
  EXPECT_EQ(SymmetricMatrix<3>(whole()).diagonal(), whole().diagonal());
}

}  // namespace
}  // namespace geneva::fem::test
