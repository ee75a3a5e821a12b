#include "fem/linear/multigrid/condensed_matrix.h"

#include <algorithm>
#include <utility>

namespace geneva::fem {

namespace {

/// The share in an unknown; zero if there is none.
double share_in(const Shares& shares, const int unknown) {
  const auto found =
      std::lower_bound(shares.begin(), shares.end(), unknown,
                       [](const auto& share, const int number) { return share.first < number; });
  return found == shares.end() || found->first != unknown ? 0. : found->second;
}

}  // namespace

template <int n>
CondensedMatrix<n>::CondensedMatrix(SymmetricMatrix<n> whole)
    : whole_(std::move(whole)), elimination_(whole_.unknowns(), {}) {}

template <int n>
void CondensedMatrix<n>::eliminate(const std::map<int, Shares>& lines) {
  elimination_ = Elimination(whole_.unknowns(), lines);
}

template <int n>
void CondensedMatrix<n>::vmult(Vector& result, const Vector& vector) const {
  Vector distributed(vector);
  elimination_.distribute(distributed);
  whole_.vmult(result, distributed);
  elimination_.collect(result);
}

template <int n>
void CondensedMatrix<n>::residual(Vector& result, const Vector& vector,
                                  const Vector& right_hand_side) const {
  Vector distributed(vector);
  elimination_.distribute(distributed);
  whole_.residual(result, distributed, right_hand_side);
  elimination_.collect(result);
}

template <int n>
std::vector<double> CondensedMatrix<n>::diagonal() const {
  std::vector<double> result = whole_.diagonal();
  const std::vector<double> contributions = elimination_.sum(contributions_to_diagonal());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] += contributions[i];
  return result;
}

/// Of the rows of this rank's constrained unknowns, with their images in the columns.
template <int n>
std::map<int, double> CondensedMatrix<n>::contributions_to_diagonal() const {
  std::map<int, double> result;
  const NodePattern& pattern = whole_.pattern();
  for (const auto& [unknown, shares] : elimination_.own()) {
    const std::size_t row = unknown / n;
    for (std::size_t i = pattern.first_block(row); i < pattern.first_block(row + 1); ++i) {
      const int place = pattern.place(i);
      const auto block = whole_.block(row, place);
      for (int component = 0; component < n; ++component) {
        const double stiffness = block(static_cast<Eigen::Index>(unknown % n), component);
        const int column = n * pattern.number(static_cast<std::size_t>(place)) + component;
        if (const Shares* const followed = elimination_.shares_of(column)) {
          for (const auto& [carrier, share] : *followed)
            if (const double own = share_in(shares, carrier); own != 0.)
              result[carrier] += own * stiffness * share;
        } else if (const double own = share_in(shares, column); own != 0.) {
          result[column] += 2. * own * stiffness;
        }
      }
    }
  }
  return result;
}

template class CondensedMatrix<2>;
template class CondensedMatrix<3>;

}  // namespace geneva::fem
