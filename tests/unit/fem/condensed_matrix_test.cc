#include "fem/linear/multigrid/condensed_matrix.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "fem/linear/frictional_matrix.h"
#include "tests/unit/fem/coupled_matrix.h"

namespace geneva::fem::test {
namespace {

/// The first unknown of each rank follows the next one, its last but one and, if there are others,
/// one of the next rank; its fourth one two of those.
std::map<int, Shares> lines() {
  const int n_unknowns = unknowns().n_all();
  std::map<int, Shares> result;
  for (int first = 0; first < n_unknowns; first += n_own_unknowns) {
    std::map<int, double> shares{{first + 1, 0.3}, {first + 4, -0.6}};
    shares[(first + n_own_unknowns + 5) % n_unknowns] += 0.9;
    result[first].assign(shares.begin(), shares.end());
    result[first + 3] = {{first + 1, 0.2}, {first + 4, 0.7}};
  }
  return result;
}

CondensedMatrix<3> condensed() {
  CondensedMatrix<3> matrix(whole());
  matrix.eliminate({{unknowns().first() + 2, {{unknowns().first(), 2.}}}});
  matrix.eliminate(lines());
  return matrix;
}

/// E v, from the values that all ranks know.
Vector distributed(const std::function<double(int)>& value,
                   const std::map<int, Shares>& all = lines()) {
  return vector_of([&](const int unknown) {
    const auto line = all.find(unknown);
    if (line == all.end()) return value(unknown);
    double sum = 0.;
    for (const auto& [carrier, share] : line->second) sum += share * value(carrier);
    return sum;
  });
}

TEST(CondensedMatrix, DoesTheWorkOfTheWholeMatrixOnDistributedVectors) {
  const CondensedMatrix<3> matrix = condensed();
  Vector product(vector_of(some));
  matrix.vmult(product, vector_of(some));
  Vector whole_product(product);
  whole().vmult(whole_product, distributed(some));
  EXPECT_NEAR(vector_of(other) * product, distributed(other) * whole_product, 1e-12);
  EXPECT_GT(std::abs(vector_of(other) * product), 0.1);
}

/// Other shares than lines() for the same unknowns.
std::map<int, Shares> virtual_lines() {
  std::map<int, Shares> result = lines();
  for (auto& line : result)
    for (auto& share : line.second) share.second += 0.1 * std::sin(line.first + share.first);
  return result;
}

/// w . W^T A E v = (W w) . A (E v)
TEST(FrictionalMatrix, DoesTheWorkOfTheWholeMatrixOnVirtualDisplacements) {
  const CondensedMatrix<3> matrix = condensed();
  const FrictionalMatrix<3> frictional(matrix, virtual_lines());
  Vector product(vector_of(some));
  frictional.vmult(product, vector_of(some));
  Vector whole_product(product);
  whole().vmult(whole_product, distributed(some));
  EXPECT_NEAR(vector_of(other) * product, distributed(other, virtual_lines()) * whole_product,
              1e-12);
  Vector residual(product);
  frictional.residual(residual, vector_of(some), product);
  EXPECT_LT(residual.linfty_norm(), 1e-13);
}

TEST(FrictionalMatrix, IsTheCondensedOneWithoutFriction) {
  const CondensedMatrix<3> matrix = condensed();
  const FrictionalMatrix<3> frictional(matrix, lines());
  Vector product(vector_of(some));
  matrix.vmult(product, vector_of(some));
  Vector same(product);
  frictional.vmult(same, vector_of(some));
  same -= product;
  EXPECT_EQ(same.linfty_norm(), 0.);
}

TEST(CondensedMatrix, DoesNotSeeWhatFollows) {
  const CondensedMatrix<3> matrix = condensed();
  const auto all = lines();
  Vector product(vector_of(some));
  matrix.vmult(product, vector_of(some));
  Vector changed(product);
  matrix.vmult(changed, vector_of([&](const int i) { return all.count(i) > 0 ? 7. : some(i); }));
  for (const auto i : product.locally_owned_elements()) {
    EXPECT_NEAR(changed(i), product(i), 1e-14);
    EXPECT_EQ(product(i) == 0., all.count(static_cast<int>(i)) > 0);
  }
}

TEST(CondensedMatrix, GivesTheResidualOfItsProduct) {
  const CondensedMatrix<3> matrix = condensed();
  const auto all = lines();
  const Vector load = vector_of([&](const int i) { return all.count(i) > 0 ? 0. : other(i); });
  Vector product(load);
  matrix.vmult(product, vector_of(some));
  Vector residual(load);
  matrix.residual(residual, vector_of(some), load);
  residual += product;
  residual -= load;
  EXPECT_LT(residual.linfty_norm(), 1e-13);
}

TEST(CondensedMatrix, KnowsItsDiagonal) {
  const CondensedMatrix<3> matrix = condensed();
  const std::vector<double> diagonal = matrix.diagonal();
  const UnknownRanges map = unknowns();
  const auto all = lines();
  for (int unknown = 0; unknown < map.n_all(); ++unknown) {
    const Vector unit = vector_of([&](const int i) { return i == unknown ? 1. : 0.; });
    Vector product(unit);
    matrix.vmult(product, unit);
    if (!map.have(unknown)) continue;
    const double found = diagonal[static_cast<std::size_t>(unknown - map.first())];
    if (all.count(unknown) > 0)
      EXPECT_GT(found, 1.);
    else
      EXPECT_NEAR(found, product(static_cast<unsigned int>(unknown)), 1e-13);
  }
}

}  // namespace
}  // namespace geneva::fem::test
