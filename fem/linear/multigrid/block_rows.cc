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

OwnNodes::OwnNodes(const Epetra_Map& unknowns, const int of_each)
    : first(unknowns.NumMyElements() == 0 ? 0 : unknowns.MinMyGID() / of_each),
      end(first + unknowns.NumMyElements() / of_each) {}

NodeRanges::NodeRanges(const Epetra_Map& unknowns, const int of_each)
    : ends_(static_cast<std::size_t>(unknowns.Comm().NumProc())) {
  int n_own = unknowns.NumMyElements() / of_each;
  unknowns.Comm().GatherAll(&n_own, ends_.data(), 1);
  std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
}

bool NodeRanges::are_of_one_rank(const int node, const int other) const {
  return rank_of(node) == rank_of(other);
}

std::ptrdiff_t NodeRanges::rank_of(const int node) const {
  return std::upper_bound(ends_.begin(), ends_.end(), node) - ends_.begin();
}

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

std::vector<int> owners_of(const std::vector<int>& nodes, const Epetra_Map& unknowns,
                           const int of_each) {
  std::vector<int> numbers(nodes);
  for (int& number : numbers) number *= of_each;
  std::vector<int> owners(nodes.size());
  std::vector<int> places(nodes.size());
  unknowns.RemoteIDList(static_cast<int>(numbers.size()), numbers.data(), owners.data(),
                        places.data());
  return owners;
}

template <typename Block>
std::vector<BlockRow<Block>> rows_of_others(const std::vector<BlockRow<Block>>& rows,
                                            const std::vector<int>& others,
                                            const Epetra_Map& unknowns, const int of_each,
                                            const MPI_Comm communicator) {
  const OwnNodes own(unknowns, of_each);
  const std::vector<int> owners = owners_of(others, unknowns, of_each);
  std::map<unsigned int, std::vector<int>> asked;
  for (std::size_t i = 0; i < others.size(); ++i)
    asked[static_cast<unsigned int>(owners[i])].push_back(others[i]);
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
void send_to_owners(BlockRows<Block>& rows, const OwnNodes& own, const Epetra_Map& unknowns,
                    const MPI_Comm communicator) {
  std::vector<int> of_others;
  for (const auto& row : rows)
    if (!own.have(row.first)) of_others.push_back(row.first);
  const std::vector<int> owners = owners_of(of_others, unknowns, Block::ColsAtCompileTime);
  std::map<unsigned int, std::size_t> sizes;
  for (std::size_t i = 0; i < of_others.size(); ++i)
    sizes[static_cast<unsigned int>(owners[i])] += packed_size(rows.at(of_others[i]));
  std::map<unsigned int, std::vector<double>> sent;
  for (const auto& [rank, size] : sizes) sent[rank].reserve(size);
  for (std::size_t i = 0; i < of_others.size(); ++i) {
    const auto row = rows.find(of_others[i]);
    pack(row->first, row->second, sent[static_cast<unsigned int>(owners[i])]);
    rows.erase(row);
  }
  for (const auto& [rank, packed] : dealii::Utilities::MPI::some_to_some(communicator, sent))
    add_packed(packed, rows);
}

template void send_to_owners(BlockRows<Eigen::Matrix2d>&, const OwnNodes&, const Epetra_Map&,
                             MPI_Comm);
template void send_to_owners(BlockRows<Eigen::Matrix3d>&, const OwnNodes&, const Epetra_Map&,
                             MPI_Comm);
template void send_to_owners(BlockRows<Eigen::Matrix<double, 6, 6>>&, const OwnNodes&,
                             const Epetra_Map&, MPI_Comm);
template std::vector<BlockRow<Eigen::Matrix<double, 2, 3>>> rows_of_others(
    const std::vector<BlockRow<Eigen::Matrix<double, 2, 3>>>&, const std::vector<int>&,
    const Epetra_Map&, int, MPI_Comm);
template std::vector<BlockRow<Eigen::Matrix3d>> rows_of_others(
    const std::vector<BlockRow<Eigen::Matrix3d>>&, const std::vector<int>&, const Epetra_Map&, int,
    MPI_Comm);
template std::vector<BlockRow<Eigen::Matrix<double, 3, 6>>> rows_of_others(
    const std::vector<BlockRow<Eigen::Matrix<double, 3, 6>>>&, const std::vector<int>&,
    const Epetra_Map&, int, MPI_Comm);
template std::vector<BlockRow<Eigen::Matrix<double, 6, 6>>> rows_of_others(
    const std::vector<BlockRow<Eigen::Matrix<double, 6, 6>>>&, const std::vector<int>&,
    const Epetra_Map&, int, MPI_Comm);

}  // namespace geneva::fem
