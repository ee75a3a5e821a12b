#include "fem/multigrid/block_matrix.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <utility>

namespace geneva::fem {

namespace {

/// Coarse nodes of this rank: those from first on, before end.
struct OwnNodes {
  int first;
  int end;
  [[nodiscard]] bool have(const int node) const { return node >= first && node < end; }
};

/// Coarse nodes of the rows and columns that this rank has, its own ones first.
class LocalNodes {
 public:
  template <typename Block>
  LocalNodes(const BlockRows<Block>& rows, const OwnNodes& own) : own_(own) {
    for (const auto& [number, row] : rows)
      for (std::size_t i = 0; i < row.size(); ++i)
        if (!own.have(row.number(i))) others_.push_back(row.number(i));
    std::sort(others_.begin(), others_.end());
    others_.erase(std::unique(others_.begin(), others_.end()), others_.end());
  }

  [[nodiscard]] int place_of(const int node) const {
    if (own_.have(node)) return node - own_.first;
    const auto found = std::lower_bound(others_.begin(), others_.end(), node);
    return own_.end - own_.first + static_cast<int>(found - others_.begin());
  }

  /// Numbers of their unknowns.
  [[nodiscard]] std::vector<int> unknowns(const int of_each) const {
    std::vector<int> result;
    const auto add = [&](const int node) {
      for (int i = 0; i < of_each; ++i) result.push_back(node * of_each + i);
    };
    for (int node = own_.first; node < own_.end; ++node) add(node);
    for (const int node : others_) add(node);
    return result;
  }

 private:
  OwnNodes own_;
  std::vector<int> others_;
};

/// A row as numbers: its coarse node, the number of its blocks, and each with its coarse node.
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

/// Sends the rows of other ranks to these and adds what they send.
template <typename Block>
void exchange(BlockRows<Block>& rows, const OwnNodes& own, const Epetra_Map& unknowns,
              const MPI_Comm communicator) {
  std::vector<int> of_others;
  for (const auto& row : rows)
    if (!own.have(row.first)) of_others.push_back(row.first * Block::ColsAtCompileTime);
  std::vector<int> owners(of_others.size());
  std::vector<int> places(of_others.size());
  unknowns.RemoteIDList(static_cast<int>(of_others.size()), of_others.data(), owners.data(),
                        places.data());
  std::map<unsigned int, std::vector<double>> sent;
  for (std::size_t i = 0; i < of_others.size(); ++i) {
    const auto row = rows.find(of_others[i] / Block::ColsAtCompileTime);
    pack(row->first, row->second, sent[static_cast<unsigned int>(owners[i])]);
    rows.erase(row);
  }
  for (const auto& [rank, packed] : dealii::Utilities::MPI::some_to_some(communicator, sent))
    add_packed(packed, rows);
}

/// Places of a row's coarse nodes, ascending, with the blocks' positions in the row.
template <typename Block>
std::vector<std::pair<int, std::size_t>> places_of(const BlockRow<Block>& row,
                                                   const LocalNodes& nodes) {
  std::vector<std::pair<int, std::size_t>> result;
  result.reserve(row.size());
  for (std::size_t i = 0; i < row.size(); ++i)
    result.emplace_back(nodes.place_of(row.number(i)), i);
  std::sort(result.begin(), result.end());
  return result;
}

template <typename Block>
void fill(const int first_line, const BlockRow<Block>& row, const LocalNodes& nodes,
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
  const int n_own = unknowns.NumMyElements() / n;
  const int first = n_own == 0 ? 0 : unknowns.MinMyGID() / n;
  const OwnNodes own{first, first + n_own};
  exchange(rows, own, unknowns, communicator);
  std::vector<int> lengths;
  for (int node = own.first; node < own.end; ++node) {
    rows[node].at(node);
    lengths.insert(lengths.end(), n, n * static_cast<int>(rows[node].size()));
  }
  const LocalNodes nodes(rows, own);
  const std::vector<int> columns = nodes.unknowns(n);
  const Epetra_Map column_map(-1, static_cast<int>(columns.size()), columns.data(), 0,
                              unknowns.Comm());
  auto result =
      std::make_unique<Epetra_CrsMatrix>(Copy, unknowns, column_map, lengths.data(), true);
  for (const auto& [number, row] : rows) fill((number - own.first) * n, row, nodes, *result);
  result->FillComplete(unknowns, unknowns);
  return result;
}

template std::unique_ptr<Epetra_CrsMatrix> block_matrix(BlockRows<RigidMotion<2>>,
                                                        const Epetra_Map&, MPI_Comm);
template std::unique_ptr<Epetra_CrsMatrix> block_matrix(BlockRows<RigidMotion<3>>,
                                                        const Epetra_Map&, MPI_Comm);

}  // namespace geneva::fem
