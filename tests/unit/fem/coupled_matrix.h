#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/linear/multigrid/symmetric_matrix.h"
#include "fem/linear/multigrid/unknown_ranges.h"

// A small matrix on any number of ranks, and vectors for it.

namespace geneva::fem::test {

constexpr int n_own_nodes = 2;
constexpr int n_own_unknowns = 3 * n_own_nodes;

inline UnknownRanges unknowns() { return {n_own_unknowns, MPI_COMM_WORLD}; }

/// Every unknown is coupled to all others: cos i cos j, with 4 more on the diagonal.
inline SymmetricMatrix<3> whole() {
  const UnknownRanges map = unknowns();
  std::vector<int> all;
  for (int node = 0; node < map.n_all() / 3; ++node) all.push_back(node);
  SymmetricMatrix<3> matrix(NodePattern(map, 3, {n_own_nodes, all}));
  for (int row = 0; row < n_own_nodes; ++row)
    for (const int node : all)
      if (const int place = matrix.pattern().place_of(node); place >= row)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            matrix.upper_block(static_cast<std::size_t>(row), place)(i, j) =
                std::cos(map.first() + 3. * row + i) * std::cos(3. * node + j) +
                (place == row && i == j ? 4. : 0.);
  return matrix;
}

inline Vector vector_of(const std::function<double(int)>& value) {
  Vector result(unknowns().own(), MPI_COMM_WORLD);
  for (const auto i : result.locally_owned_elements()) result(i) = value(static_cast<int>(i));
  result.compress(dealii::VectorOperation::insert);
  return result;
}

inline double some(const int i) { return std::sin(0.7 * (i + 1.)); }
inline double other(const int i) { return std::sin(1.9 * (i + 1.)); }

}  // namespace geneva::fem::test
