#pragma once

#include <mpi.h>

#include <cstddef>
#include <map>
#include <vector>

#include "fem/linear/multigrid/block_row.h"
#include "fem/linear/multigrid/unknown_ranges.h"

namespace geneva::fem {

/// Rows of a matrix by their nodes, of this mesh or of a coarser one.
template <typename Block>
using BlockRows = std::map<int, BlockRow<Block>>;

/// The nodes of this rank: those from first on, before end.
struct OwnNodes {
  /// @param unknowns of this rank, those of a node after each other
  OwnNodes(const UnknownRanges& unknowns, int of_each);

  [[nodiscard]] bool have(const int node) const { return node >= first && node < end; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end - first); }

  int first;
  int end;
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

/// Rows of other ranks' nodes, which these send.
/// @param rows of this rank's nodes, from the first on
/// @param others numbers of the nodes
/// @param unknowns of the nodes, of_each of each
/// @return in the order of others
template <typename Block>
std::vector<BlockRow<Block>> rows_of_others(const std::vector<BlockRow<Block>>& rows,
                                            const std::vector<int>& others,
                                            const UnknownRanges& unknowns, int of_each,
                                            MPI_Comm communicator);

/// Sends the rows of other ranks' nodes to these and adds what they send.
/// @param unknowns of the nodes
template <typename Block>
void send_to_owners(BlockRows<Block>& rows, const OwnNodes& own, const UnknownRanges& unknowns,
                    MPI_Comm communicator);

}  // namespace geneva::fem
