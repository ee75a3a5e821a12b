#pragma once

#include <Epetra_Map.h>
#include <mpi.h>

#include <cstddef>
#include <map>
#include <vector>

#include "fem/linear/multigrid/block_row.h"

namespace geneva::fem {

/// Rows of a matrix by their nodes, of this mesh or of a coarser one.
template <typename Block>
using BlockRows = std::map<int, BlockRow<Block>>;

/// The nodes of this rank: those from first on, before end.
struct OwnNodes {
  /// @param unknowns of this rank, those of a node after each other
  OwnNodes(const Epetra_Map& unknowns, int of_each);

  [[nodiscard]] bool have(const int node) const { return node >= first && node < end; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end - first); }

  int first;
  int end;
};

/// Which rank each node belongs to, for nodes that are numbered rank by rank.
class NodeRanges {
 public:
  /// @param unknowns of this rank, those of a node after each other
  NodeRanges(const Epetra_Map& unknowns, int of_each);

  [[nodiscard]] bool are_of_one_rank(int node, int other) const;

 private:
  [[nodiscard]] std::ptrdiff_t rank_of(int node) const;

  std::vector<int> ends_;  ///< of each rank's nodes, ascending
};

/// Places of the nodes that a rank's part of a matrix has in its columns: its own ones, then
/// others.
class ColumnNodes {
 public:
  /// @param others in any order, also several times
  ColumnNodes(const OwnNodes& own, std::vector<int> others);

  [[nodiscard]] int place_of(int node) const;
  /// The nodes in the order of their places.
  [[nodiscard]] std::vector<int> numbers() const;
  /// The unknowns of other ranks' nodes, ascending.
  [[nodiscard]] std::vector<int> unknowns_of_others(int of_each) const;

 private:
  OwnNodes own_;
  std::vector<int> others_;
};

/// Ranks that own nodes.
/// @param unknowns of the nodes, of_each of each
std::vector<int> owners_of(const std::vector<int>& nodes, const Epetra_Map& unknowns, int of_each);

/// Rows of other ranks' nodes, which these send.
/// @param rows of this rank's nodes, from the first on
/// @param others numbers of the nodes
/// @param unknowns of the nodes, of_each of each
/// @return in the order of others
template <typename Block>
std::vector<BlockRow<Block>> rows_of_others(const std::vector<BlockRow<Block>>& rows,
                                            const std::vector<int>& others,
                                            const Epetra_Map& unknowns, int of_each,
                                            MPI_Comm communicator);

/// Sends the rows of other ranks' nodes to these and adds what they send.
/// @param unknowns of the nodes
template <typename Block>
void send_to_owners(BlockRows<Block>& rows, const OwnNodes& own, const Epetra_Map& unknowns,
                    MPI_Comm communicator);

}  // namespace geneva::fem
