#include "fem/multigrid/symmetric_matrix.h"

#include <utility>

namespace geneva::fem {

namespace {

/// Places ascend, and those of other ranks' nodes come last.
std::vector<std::size_t> first_upper_blocks(const NodePattern& pattern) {
  std::vector<std::size_t> result{0};
  result.reserve(pattern.n_rows() + 1);
  for (std::size_t row = 0; row < pattern.n_rows(); ++row)
    result.push_back(result.back() + pattern.first_block(row + 1) -
                     pattern.block(row, static_cast<int>(row)));
  return result;
}

}  // namespace

template <int n>
SymmetricMatrix<n>::SymmetricMatrix(NodePattern pattern)
    : pattern_(std::move(pattern)),
      first_blocks_(first_upper_blocks(pattern_)),
      blocks_(first_blocks_.back(), Block::Zero()) {}

template <int n>
std::size_t SymmetricMatrix<n>::index(const std::size_t row, const int place) const {
  return first_blocks_[row + 1] - (pattern_.first_block(row + 1) - pattern_.block(row, place));
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
  const double* const own = vector.trilinos_vector()[0];
  const double* const others = pattern_.on_others(vector.trilinos_vector());
  double* const to = result.trilinos_vector()[0];
  const auto n_own = static_cast<int>(pattern_.own().size());
  for (std::size_t row = 0; row < pattern_.n_rows(); ++row) {
    const Part of_row = factor * Eigen::Map<const Part>(own + n * row);
    Part sum = diagonal_block(row) * of_row;
    std::size_t in_pattern = first_of_pattern(row) + 1;
    for (std::size_t i = first_blocks_[row] + 1; i < first_blocks_[row + 1]; ++i, ++in_pattern) {
      const int place = pattern_.place(in_pattern);
      if (place >= n_own) {
        const Eigen::Map<const Part> of_column(others + n * (place - n_own));
        sum.noalias() += factor * (blocks_[i] * of_column);
        continue;
      }
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
