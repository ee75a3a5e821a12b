#include "fem/linear/multigrid/condensed_entries.h"

namespace geneva::fem {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Adds s A_ij s' below the diagonal and on it for the shares s and s' that two unknowns have in
/// others.
void add_shares(const Shares& row, const Shares& column, const double stiffness,
                Triplets& entries) {
  for (const auto& [i, share] : row)
    for (const auto& [j, other] : column)
      if (i >= j) entries.emplace_back(i, j, share * stiffness * other);
}

}  // namespace

template <int n>
std::vector<Eigen::Triplet<double>> condensed_entries(const SymmetricMatrix<n>& matrix,
                                                      const Elimination& elimination) {
  const NodePattern& pattern = matrix.pattern();
  Triplets entries;
  entries.reserve(static_cast<std::size_t>(n * n) * pattern.n_blocks());
  matrix.visit_blocks([&](const std::size_t node, const std::size_t place, const auto& block) {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int row = n * pattern.number(node) + i;
        const int column = n * pattern.number(place) + j;
        const Shares* const of_row = elimination.shares_of(row);
        const Shares* const of_column = elimination.shares_of(column);
        if (of_row == nullptr && of_column == nullptr) {
          if (row >= column) entries.emplace_back(row, column, block(i, j));
          continue;
        }
        add_shares(of_row ? *of_row : Shares{{row, 1.}},
                   of_column ? *of_column : Shares{{column, 1.}}, block(i, j), entries);
        if (row == column) entries.emplace_back(row, row, block(i, i));
      }
  });
  return entries;
}

template std::vector<Eigen::Triplet<double>> condensed_entries(const SymmetricMatrix<2>&,
                                                               const Elimination&);
template std::vector<Eigen::Triplet<double>> condensed_entries(const SymmetricMatrix<3>&,
                                                               const Elimination&);
template std::vector<Eigen::Triplet<double>> condensed_entries(const SymmetricMatrix<6>&,
                                                               const Elimination&);

}  // namespace geneva::fem
