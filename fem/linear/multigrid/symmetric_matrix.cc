#include "fem/linear/multigrid/symmetric_matrix.h"

#include <utility>

namespace geneva::fem {

namespace {

/// Of each row, and the end. Places ascend, and those of other ranks' nodes come last.
std::vector<std::size_t> first_upper_blocks(const NodePattern& pattern) {
  const auto n_own = static_cast<int>(pattern.own().size());
  std::vector<std::size_t> result{0};
  result.reserve(pattern.n_rows() + 1);
  for (std::size_t row = 0; row < pattern.n_rows(); ++row)
    result.push_back(result.back() + pattern.block(row, n_own) -
                     pattern.block(row, static_cast<int>(row)));
  return result;
}

/// Of each row, and the end.
/// @param first of all
std::vector<std::size_t> first_blocks_beyond(const NodePattern& pattern, const std::size_t first) {
  const auto n_own = static_cast<int>(pattern.own().size());
  std::vector<std::size_t> result{first};
  result.reserve(pattern.n_rows() + 1);
  for (std::size_t row = 0; row < pattern.n_rows(); ++row)
    result.push_back(result.back() + pattern.first_block(row + 1) - pattern.block(row, n_own));
  return result;
}

}  // namespace

template <int n>
SymmetricMatrix<n>::SymmetricMatrix(NodePattern pattern)
    : pattern_(std::move(pattern)),
      first_upper_(first_upper_blocks(pattern_)),
      first_beyond_(first_blocks_beyond(pattern_, first_upper_.back())),
      blocks_(first_beyond_.back(), Block::Zero()) {}

template <int n>
std::size_t SymmetricMatrix<n>::index(const std::size_t row, const int place) const {
  const std::size_t in_pattern = pattern_.block(row, place);
  const std::size_t own_end = end_of_own(row);
  return in_pattern < own_end ? first_upper_[row + 1] - (own_end - in_pattern)
                              : first_beyond_[row] + (in_pattern - own_end);
}

template <int n>
typename SymmetricMatrix<n>::Block SymmetricMatrix<n>::block(const std::size_t row,
                                                             const int place) const {
  const auto column = static_cast<std::size_t>(place);
  if (column < row) return blocks_[index(column, static_cast<int>(row))].transpose();
  return blocks_[index(row, place)];
}

template <int n>
void SymmetricMatrix<n>::add(const BlockRows<Block>& rows) {
  for (const auto& [number, values] : rows) {
    const int row = number - pattern_.own().first;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (const int place = pattern_.place_of(values.number(i)); place >= row)
        upper_block(static_cast<std::size_t>(row), place) += values.block(i);
  }
}

template <int n>
void SymmetricMatrix<n>::vmult(Vector& result, const Vector& vector) const {
  result = 0.;
  add_product(result, vector, 1.);
}

template <int n>
void SymmetricMatrix<n>::residual(Vector& result, const Vector& vector,
                                  const Vector& right_hand_side) const {
  result = right_hand_side;
  add_product(result, vector, -1.);
}

template <int n>
void SymmetricMatrix<n>::add_product(Vector& result, const Vector& vector,
                                     const double factor) const {
  using Part = Eigen::Matrix<double, n, 1>;
  const double* const own = vector.begin();
  double* const to = result.begin();
  const double* const others =
      pattern_.on_others(own, [&] { add_product_of_own(to, own, factor); });
  for (const NodePattern::BlocksBeyond& blocks : pattern_.blocks_beyond()) {
    Part sum = Part::Zero();
    const Block* block = &blocks_[first_beyond_[blocks.row]];
    for (std::size_t i = blocks.first; i < blocks.end; ++i, ++block)
      sum.noalias() += *block * Eigen::Map<const Part>(others + n * pattern_.place_beyond(i));
    Eigen::Map<Part>(to + n * blocks.row) += factor * sum;
  }
}

/// What comes from columns of this rank.
template <int n>
void SymmetricMatrix<n>::add_product_of_own(double* const to, const double* const own,
                                            const double factor) const {
  using Part = Eigen::Matrix<double, n, 1>;
  for (std::size_t row = 0; row < pattern_.n_rows(); ++row) {
    const Part of_row = factor * Eigen::Map<const Part>(own + n * row);
    Part sum = diagonal_block(row) * of_row;
    std::size_t in_pattern = first_of_upper(row) + 1;
    for (std::size_t i = first_upper_[row] + 1; i < first_upper_[row + 1]; ++i, ++in_pattern) {
      const auto place = static_cast<std::size_t>(pattern_.place(in_pattern));
      sum.noalias() += factor * (blocks_[i] * Eigen::Map<const Part>(own + n * place));
      Eigen::Map<Part>(to + n * place).noalias() += blocks_[i].transpose() * of_row;
    }
    Eigen::Map<Part>(to + n * row) += sum;
  }
}

template <int n>
std::vector<double> SymmetricMatrix<n>::diagonal() const {
  std::vector<double> result;
  result.reserve(n * pattern_.n_rows());
  for (std::size_t row = 0; row < pattern_.n_rows(); ++row)
    for (int component = 0; component < n; ++component)
      result.push_back(diagonal_block(row)(component, component));
  return result;
}

template class SymmetricMatrix<2>;
template class SymmetricMatrix<3>;
template class SymmetricMatrix<6>;

}  // namespace geneva::fem
