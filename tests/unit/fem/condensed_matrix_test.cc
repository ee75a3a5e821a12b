#include "fem/multigrid/condensed_matrix.h"

#include <Epetra_MpiComm.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace geneva::fem::test {
namespace {

using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr int n_own_nodes = 2;
constexpr int n_own_unknowns = 3 * n_own_nodes;

Epetra_Map unknowns() { return {-1, n_own_unknowns, 0, Epetra_MpiComm(MPI_COMM_WORLD)}; }

/// Every node is coupled to all others; symmetric.
NodeMatrix<3> whole() {
  const Epetra_Map map = unknowns();
  std::vector<int> all;
  for (int node = 0; node < map.NumGlobalElements() / 3; ++node) all.push_back(node);
  NodeMatrix<3> matrix(NodePattern(map, 3, {n_own_nodes, all}));
  for (int row = 0; row < n_own_nodes; ++row)
    for (const int node : all)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const auto place = matrix.pattern().place_of(node);
          matrix.block(matrix.pattern().block(static_cast<std::size_t>(row), place))(i, j) =
              std::cos(map.MinMyGID() + 3. * row + i) * std::cos(3. * node + j) +
              (place == row && i == j ? 4. : 0.);
        }
  return matrix;
}

/// The first unknown of each rank follows the next one, its last but one and, if there are others,
/// one of the next rank; its fourth one two of those.
std::map<int, Shares> lines() {
  const int n_unknowns = unknowns().NumGlobalElements();
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
  matrix.eliminate({{unknowns().MinMyGID() + 2, {{unknowns().MinMyGID(), 2.}}}});
  matrix.eliminate(lines());
  return matrix;
}

Vector vector_of(const std::function<double(int)>& value) {
  Vector result(dealii::IndexSet(unknowns()), MPI_COMM_WORLD);
  for (const auto i : result.locally_owned_elements()) result(i) = value(static_cast<int>(i));
  result.compress(dealii::VectorOperation::insert);
  return result;
}

/// E v, from the values that all ranks know.
Vector distributed(const std::function<double(int)>& value) {
  const auto all = lines();
  return vector_of([&](const int unknown) {
    const auto line = all.find(unknown);
    if (line == all.end()) return value(unknown);
    double sum = 0.;
    for (const auto& [carrier, share] : line->second) sum += share * value(carrier);
    return sum;
  });
}

double some(const int i) { return std::sin(0.7 * (i + 1.)); }
double other(const int i) { return std::sin(1.9 * (i + 1.)); }

TEST(CondensedMatrix, DoesTheWorkOfTheWholeMatrixOnDistributedVectors) {
  const CondensedMatrix<3> matrix = condensed();
  Vector product(vector_of(some));
  matrix.vmult(product, vector_of(some));
  Vector whole_product(product);
  whole().vmult(whole_product, distributed(some));
  EXPECT_NEAR(vector_of(other) * product, distributed(other) * whole_product, 1e-12);
  EXPECT_GT(std::abs(vector_of(other) * product), 0.1);
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
  const Epetra_Map map = unknowns();
  const auto all = lines();
  for (int unknown = 0; unknown < map.NumGlobalElements(); ++unknown) {
    const Vector unit = vector_of([&](const int i) { return i == unknown ? 1. : 0.; });
    Vector product(unit);
    matrix.vmult(product, unit);
    if (!map.MyGID(unknown)) continue;
    const double found = diagonal[static_cast<std::size_t>(map.LID(unknown))];
    if (all.count(unknown) > 0)
      EXPECT_GT(found, 1.);
    else
      EXPECT_NEAR(found, product(static_cast<unsigned int>(unknown)), 1e-13);
  }
}

}  // namespace
}  // namespace geneva::fem::test
