#include "fem/multigrid/block_matrix.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geneva::fem {

namespace {

/// Nodes of other ranks in the columns.
template <typename Block>
std::vector<int> others_in(const BlockRows<Block>& rows, const OwnNodes& own) {
  std::vector<int> others;
  for (const auto& [number, row] : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      if (!own.have(row.number(i))) others.push_back(row.number(i));
  return others;
}

/// Places of a row's coarse nodes, ascending, with the blocks' positions in the row.
template <typename Block>
std::vector<std::pair<int, std::size_t>> places_of(const BlockRow<Block>& row,
                                                   const ColumnNodes& nodes) {
  std::vector<std::pair<int, std::size_t>> result;
  result.reserve(row.size());
  for (std::size_t i = 0; i < row.size(); ++i)
    result.emplace_back(nodes.place_of(row.number(i)), i);
  std::sort(result.begin(), result.end());
  return result;
}

template <typename Block>
void fill(const int first_line, const BlockRow<Block>& row, const ColumnNodes& nodes,
          Epetra_CrsMatrix& matrix) {
  constexpr int n = Block::ColsAtCompileTime;
  const auto places = places_of(row, nodes);
  std::vector<int> columns;
  columns.reserve(places.size() * n);
  for (const auto& entry : places)
    for (int i = 0; i < n; ++i) columns.push_back(entry.first * n + i);
  std::vector<double> values(columns.size());
  for (int line = 0; line < n; ++line) {
    auto value = values.begin();
    for (const auto& entry : places)
      for (int i = 0; i < n; ++i) *value++ = row.block(entry.second)(line, i);
    matrix.InsertMyValues(first_line + line, static_cast<int>(values.size()), values.data(),
                          columns.data());
  }
}

}  // namespace

template <typename Block>
std::unique_ptr<Epetra_CrsMatrix> block_matrix(BlockRows<Block> rows, const Epetra_Map& unknowns,
                                               const MPI_Comm communicator) {
  constexpr int n = Block::ColsAtCompileTime;
  const OwnNodes own(unknowns, n);
  send_to_owners(rows, own, unknowns, communicator);
  std::vector<int> lengths;
  for (int node = own.first; node < own.end; ++node) {
    rows[node].at(node);
    lengths.insert(lengths.end(), n, n * static_cast<int>(rows[node].size()));
  }
  const ColumnNodes nodes(own, others_in(rows, own));
  auto result = std::make_unique<Epetra_CrsMatrix>(
      Copy, unknowns, nodes.unknowns(n, unknowns.Comm()), lengths.data(), true);
  for (const auto& [number, row] : rows) fill((number - own.first) * n, row, nodes, *result);
  result->FillComplete(unknowns, unknowns);
  return result;
}

template std::unique_ptr<Epetra_CrsMatrix> block_matrix(BlockRows<RigidMotion<2>>,
                                                        const Epetra_Map&, MPI_Comm);
template std::unique_ptr<Epetra_CrsMatrix> block_matrix(BlockRows<RigidMotion<3>>,
                                                        const Epetra_Map&, MPI_Comm);

}  // namespace geneva::fem
