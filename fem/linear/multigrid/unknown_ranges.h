#pragma once

#include <deal.II/base/index_set.h>

#include <mpi.h>

#include <vector>

namespace geneva::fem {

/// Unknowns of all ranks, numbered rank by rank.
class UnknownRanges {
 public:
  /// Collective.
  /// @param n_own number of this rank's unknowns
  UnknownRanges(int n_own, MPI_Comm communicator);

  [[nodiscard]] MPI_Comm communicator() const { return communicator_; }
  [[nodiscard]] std::size_t n_ranks() const { return firsts_.size() - 1; }
  [[nodiscard]] int n_all() const { return firsts_.back(); }
  /// This rank's unknowns: from first() on, before end().
  [[nodiscard]] int first() const { return firsts_[rank_]; }
  [[nodiscard]] int end() const { return firsts_[rank_ + 1]; }
  [[nodiscard]] int n_own() const { return end() - first(); }
  [[nodiscard]] bool have(const int unknown) const { return unknown >= first() && unknown < end(); }
  /// This rank's unknowns.
  [[nodiscard]] dealii::IndexSet own() const;
  /// The rank that owns an unknown.
  [[nodiscard]] unsigned int owner_of(int unknown) const;

 private:
  MPI_Comm communicator_;
  std::size_t rank_;
  std::vector<int> firsts_;  ///< first unknown of each rank, and the end
};

}  // namespace geneva::fem
