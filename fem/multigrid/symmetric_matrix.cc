#include "fem/multigrid/symmetric_matrix.h"

#include <utility>

namespace geneva::fem {

namespace {

/// The first block of a row that is kept: places ascend, and those of other ranks' nodes come last.
std::size_t diagonal_block(const NodePattern& pattern, const std::size_t row) {
  return pattern.block(row, static_cast<int>(row));
}

template <int n>
std::vector<Eigen::Matrix<double, n, n>> kept_blocks(const NodeMatrix<n>& matrix) {
  const NodePattern& pattern = matrix.pattern();
  std::size_t n_kept = 0;
  for (std::size_t row = 0; row < pattern.n_rows(); ++row)
    n_kept += pattern.first_block(row + 1) - diagonal_block(pattern, row);
  std::vector<Eigen::Matrix<double, n, n>> blocks;
  blocks.reserve(n_kept);
  for (std::size_t row = 0; row < pattern.n_rows(); ++row)
    for (std::size_t i = diagonal_block(pattern, row); i < pattern.first_block(row + 1); ++i)
      blocks.push_back(matrix.block(i));
  return blocks;
}

}  // namespace

template <int n>
SymmetricMatrix<n>::SymmetricMatrix(NodeMatrix<n> matrix)
    : blocks_(kept_blocks(matrix)), pattern_(std::move(matrix).pattern()) {}

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
  auto block = blocks_.begin();
  for (std::size_t row = 0; row < pattern_.n_rows(); ++row) {
    const Part of_row = factor * Eigen::Map<const Part>(own + n * row);
    Part sum = *block++ * of_row;
    const std::size_t end = pattern_.first_block(row + 1);
    for (std::size_t i = diagonal_block(pattern_, row) + 1; i < end; ++i, ++block) {
      const int place = pattern_.place(i);
      if (place >= n_own) {
        sum.noalias() += factor * (*block * Eigen::Map<const Part>(others + n * (place - n_own)));
        continue;
      }
      sum.noalias() += factor * (*block * Eigen::Map<const Part>(own + n * place));
      Eigen::Map<Part>(to + n * place).noalias() += block->transpose() * of_row;
    }
    Eigen::Map<Part>(to + n * row) += sum;
  }
}

template <int n>
std::vector<double> SymmetricMatrix<n>::diagonal() const {
  std::vector<double> result;
  result.reserve(n * pattern_.n_rows());
  auto block = blocks_.begin();
  for (std::size_t row = 0; row < pattern_.n_rows(); ++row) {
    for (int component = 0; component < n; ++component)
      result.push_back((*block)(component, component));
    block +=
        static_cast<std::ptrdiff_t>(pattern_.first_block(row + 1) - diagonal_block(pattern_, row));
  }
  return result;
}

template class SymmetricMatrix<3>;
template class SymmetricMatrix<6>;

}  // namespace geneva::fem
