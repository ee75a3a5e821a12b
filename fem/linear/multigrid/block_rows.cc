#include "fem/linear/multigrid/block_rows.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace geneva::fem {

namespace {

template <typename Block>
std::size_t packed_size(const BlockRow<Block>& row) {
  return 2 + row.size() * (1 + Block::SizeAtCompileTime);
}

/// A row as numbers: its node, the number of its blocks, and each with its node.
template <typename Block>
void pack(const int number, const BlockRow<Block>& row, std::vector<double>& packed) {
  packed.push_back(number);
  packed.push_back(static_cast<double>(row.size()));
  for (std::size_t i = 0; i < row.size(); ++i) {
    packed.push_back(row.number(i));
    packed.insert(packed.end(), row.block(i).data(),
                  row.block(i).data() + Block::SizeAtCompileTime);
  }
}

template <typename Block>
void add_packed(const std::vector<double>& packed, BlockRows<Block>& rows) {
  for (const double* next = packed.data(); next != packed.data() + packed.size();) {
    auto& row = rows[static_cast<int>(*next++)];
    const auto size = static_cast<std::size_t>(*next++);
    for (std::size_t i = 0; i < size; ++i) {
      const auto column = static_cast<int>(*next++);
      row.at(column) += Eigen::Map<const Block>(next);
      next += Block::SizeAtCompileTime;
    }
  }
}

}  // namespace

OwnNodes::OwnNodes(const UnknownRanges& unknowns, const int of_each)
    : first(unknowns.first() / of_each), end(unknowns.end() / of_each) {}

ColumnNodes::ColumnNodes(const OwnNodes& own, std::vector<int> others)
    : own_(own), others_(std::move(others)) {
  std::sort(others_.begin(), others_.end());
  others_.erase(std::unique(others_.begin(), others_.end()), others_.end());
}

int ColumnNodes::place_of(const int node) const {
  if (own_.have(node)) return node - own_.first;
  const auto found = std::lower_bound(others_.begin(), others_.end(), node);
  return own_.end - own_.first + static_cast<int>(found - others_.begin());
}

std::vector<int> ColumnNodes::numbers() const {
  std::vector<int> result(own_.size());
  std::iota(result.begin(), result.end(), own_.first);
  result.insert(result.end(), others_.begin(), others_.end());
  return result;
}

std::vector<int> ColumnNodes::unknowns_of_others(const int of_each) const {
  std::vector<int> result;
  result.reserve(others_.size() * static_cast<std::size_t>(of_each));
  for (const int number : others_)
    for (int i = 0; i < of_each; ++i) result.push_back(number * of_each + i);
  return result;
}

template <typename Block>
std::vector<BlockRow<Block>> rows_of_others(const std::vector<BlockRow<Block>>& rows,
                                            const std::vector<int>& others,
                                            const UnknownRanges& unknowns, const int of_each,
                                            const MPI_Comm communicator) {
  const OwnNodes own(unknowns, of_each);
  std::map<unsigned int, std::vector<int>> asked;
  for (const int number : others) asked[unknowns.owner_of(of_each * number)].push_back(number);
  std::map<unsigned int, std::vector<double>> sent;
  for (const auto& [rank, numbers] : dealii::Utilities::MPI::some_to_some(communicator, asked))
    for (const int number : numbers)
      pack(number, rows[static_cast<std::size_t>(number - own.first)], sent[rank]);
  BlockRows<Block> received;
  for (const auto& [rank, packed] : dealii::Utilities::MPI::some_to_some(communicator, sent))
    add_packed(packed, received);
  std::vector<BlockRow<Block>> result;
  result.reserve(others.size());
  for (const int number : others) result.push_back(std::move(received[number]));
  return result;
}

template <typename Block>
void send_to_owners(BlockRows<Block>& rows, const OwnNodes& own, const UnknownRanges& unknowns,
                    const MPI_Comm communicator) {
  const auto owner_of = [&](const int node) {
    return unknowns.owner_of(Block::ColsAtCompileTime * node);
  };
  std::map<unsigned int, std::size_t> sizes;
  for (const auto& [node, row] : rows)
    if (!own.have(node)) sizes[owner_of(node)] += packed_size(row);
  std::map<unsigned int, std::vector<double>> sent;
  for (const auto& [rank, size] : sizes) sent[rank].reserve(size);
  for (auto row = rows.begin(); row != rows.end();) {
    if (own.have(row->first)) {
      ++row;
      continue;
    }
    pack(row->first, row->second, sent[owner_of(row->first)]);
    row = rows.erase(row);
  }
  for (const auto& [rank, packed] : dealii::Utilities::MPI::some_to_some(communicator, sent))
    add_packed(packed, rows);
}

template void send_to_owners(BlockRows<Eigen::Matrix2d>&, const OwnNodes&, const UnknownRanges&,
                             MPI_Comm);
template void send_to_owners(BlockRows<Eigen::Matrix3d>&, const OwnNodes&, const UnknownRanges&,
                             MPI_Comm);
template void send_to_owners(BlockRows<Eigen::Matrix<double, 6, 6>>&, const OwnNodes&,
                             const UnknownRanges&, MPI_Comm);
template std::vector<BlockRow<Eigen::Matrix<double, 2, 3>>> rows_of_others(
    const std::vector<BlockRow<Eigen::Matrix<double, 2, 3>>>&, const std::vector<int>&,
    const UnknownRanges&, int, MPI_Comm);
template std::vector<BlockRow<Eigen::Matrix3d>> rows_of_others(
    const std::vector<BlockRow<Eigen::Matrix3d>>&, const std::vector<int>&, const UnknownRanges&,
    int, MPI_Comm);
template std::vector<BlockRow<Eigen::Matrix<double, 3, 6>>> rows_of_others(
    const std::vector<BlockRow<Eigen::Matrix<double, 3, 6>>>&, const std::vector<int>&,
    const UnknownRanges&, int, MPI_Comm);
template std::vector<BlockRow<Eigen::Matrix<double, 6, 6>>> rows_of_others(
    const std::vector<BlockRow<Eigen::Matrix<double, 6, 6>>>&, const std::vector<int>&,
    const UnknownRanges&, int, MPI_Comm);

}  // namespace geneva::fem
