#include "fem/linear/multigrid/node_matrix.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace geneva::fem {

namespace {

std::vector<int> others_in(const std::vector<std::vector<int>>& lists, const OwnNodes& own) {
  std::vector<int> others;
  for (const auto& list : lists)
    std::copy_if(list.begin(), list.end(), std::back_inserter(others),
                 [&](const int number) { return !own.have(number); });
  return others;
}

}  // namespace

NodePattern::NodePattern(const UnknownRanges& unknowns, const int of_each,
                         const std::vector<std::vector<int>>& coupled)
    : unknowns_(unknowns),
      of_each_(static_cast<std::size_t>(of_each)),
      own_(unknowns, of_each),
      columns_(own_, others_in(coupled, own_)),
      numbers_(columns_.numbers()),
      first_blocks_{0} {
  first_blocks_.reserve(coupled.size() + 1);
  for (const auto& list : coupled) first_blocks_.push_back(first_blocks_.back() + list.size());
  places_.reserve(first_blocks_.back());
  for (const auto& list : coupled) {
    const auto first = static_cast<std::ptrdiff_t>(places_.size());
    for (const int number : list) places_.push_back(columns_.place_of(number));
    std::sort(places_.begin() + first, places_.end());
  }
  find_blocks_beyond();
  if (unknowns.n_ranks() > 1)
    exchange_ = std::make_unique<Exchange>(unknowns_, columns_.unknowns_of_others(of_each));
}

void NodePattern::find_blocks_beyond() {
  const auto n_own = static_cast<int>(own_.size());
  for (std::size_t row = 0; row < n_rows(); ++row) {
    const std::size_t end = first_block(row + 1);
    const std::size_t first = block(row, n_own);
    if (first < end) blocks_beyond_.push_back({row, first, end});
  }
}

std::size_t NodePattern::block(const std::size_t row, const int place) const {
  const auto begin = places_.begin() + static_cast<std::ptrdiff_t>(first_blocks_[row]);
  const auto end = places_.begin() + static_cast<std::ptrdiff_t>(first_blocks_[row + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, place) - places_.begin());
}

std::vector<double> NodePattern::on_all_nodes(const std::vector<double>& of_own_nodes) const {
  std::vector<double> own(static_cast<std::size_t>(unknowns_.n_own()), 0.);
  for (std::size_t node = 0; node < of_own_nodes.size(); ++node)
    own[node * of_each_] = of_own_nodes[node];
  const double* const others = on_others(own.data());
  std::vector<double> result = of_own_nodes;
  for (std::size_t node = own_.size(); node < n_places(); ++node)
    result.push_back(others[(node - own_.size()) * of_each_]);
  return result;
}

/// Visits (row, place, block) for the blocks in columns of this rank.
template <int n, int m>
template <typename Visit>
void NodeMatrix<n, m>::visit_own_blocks(const Visit& visit) const {
  const auto n_own = static_cast<int>(pattern_.own().size());
  for (std::size_t row = 0; row < pattern_.n_rows(); ++row)
    for (std::size_t i = pattern_.first_block(row); i < pattern_.first_block(row + 1); ++i) {
      const int place = pattern_.place(i);
      if (place >= n_own) break;
      visit(row, static_cast<std::size_t>(place), blocks_[i]);
    }
}

/// Visits (row, place among them, block) for the blocks in columns of other ranks.
template <int n, int m>
template <typename Visit>
void NodeMatrix<n, m>::visit_blocks_beyond(const Visit& visit) const {
  for (const NodePattern::BlocksBeyond& blocks : pattern_.blocks_beyond())
    for (std::size_t i = blocks.first; i < blocks.end; ++i)
      visit(blocks.row, pattern_.place_beyond(i), blocks_[i]);
}

template <int n, int m>
void NodeMatrix<n, m>::add(const std::size_t row, const BlockRow<Block>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    blocks_[pattern_.block(row, pattern_.place_of(values.number(i)))] += values.block(i);
}

template <int n, int m>
void NodeMatrix<n, m>::vmult_add(Vector& result, const Vector& vector) const {
  using Part = Eigen::Matrix<double, m, 1>;
  const double* const own = vector.begin();
  double* const to = result.begin();
  const auto part_of = [&](const std::size_t row) {
    return Eigen::Map<Eigen::Matrix<double, n, 1>>(to + n * row);
  };
  const double* const others = pattern_.on_others(own, [&] {
    visit_own_blocks([&](const std::size_t row, const std::size_t place, const Block& block) {
      part_of(row).noalias() += block * Eigen::Map<const Part>(own + m * place);
    });
  });
  visit_blocks_beyond([&](const std::size_t row, const std::size_t place, const Block& block) {
    part_of(row).noalias() += block * Eigen::Map<const Part>(others + m * place);
  });
}

template <int n, int m>
void NodeMatrix<n, m>::Tvmult(Vector& result, const Vector& vector) const {
  using Part = Eigen::Matrix<double, m, 1>;
  const double* const from = vector.begin();
  const auto part_of = [&](const std::size_t row) {
    return Eigen::Map<const Eigen::Matrix<double, n, 1>>(from + n * row);
  };
  result = 0.;
  pattern_.add(
      result.begin(),
      [&](double* const others) {
        visit_blocks_beyond(
            [&](const std::size_t row, const std::size_t place, const Block& block) {
              Eigen::Map<Part>(others + m * place).noalias() += block.transpose() * part_of(row);
            });
      },
      [&](double* const own) {
        visit_own_blocks([&](const std::size_t row, const std::size_t place, const Block& block) {
          Eigen::Map<Part>(own + m * place).noalias() += block.transpose() * part_of(row);
        });
      });
}

template <int n, int m>
NodeMatrix<n, m> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, n, m>>>& rows,
                           const UnknownRanges& unknowns) {
  std::vector<std::vector<int>> coupled;
  for (const auto& row : rows) coupled.push_back(row.numbers());
  NodeMatrix<n, m> matrix(NodePattern(unknowns, m, coupled));
  for (std::size_t row = 0; row < rows.size(); ++row) matrix.add(row, rows[row]);
  return matrix;
}

template class NodeMatrix<2, 3>;
template class NodeMatrix<3, 3>;
template class NodeMatrix<3, 6>;
template class NodeMatrix<6, 6>;
template NodeMatrix<2, 3> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, 2, 3>>>&,
                                    const UnknownRanges&);
template NodeMatrix<3, 3> matrix_of(const std::vector<BlockRow<Eigen::Matrix3d>>&,
                                    const UnknownRanges&);
template NodeMatrix<3, 6> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, 3, 6>>>&,
                                    const UnknownRanges&);
template NodeMatrix<6, 6> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, 6, 6>>>&,
                                    const UnknownRanges&);

}  // namespace geneva::fem
