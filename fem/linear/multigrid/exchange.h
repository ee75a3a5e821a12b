#pragma once

#include <deal.II/base/partitioner.h>

#include <vector>

#include "fem/linear/multigrid/unknown_ranges.h"

namespace geneva::fem {

/// Values at unknowns of other ranks: they come from these, or go to them, while this rank works.
class Exchange {
 public:
  /// @param unknowns of this rank
  /// @param others the unknowns of other ranks, ascending
  Exchange(const UnknownRanges& unknowns, const std::vector<int>& others);

  /// Begins to receive the values of the others.
  /// @param own values at this rank's unknowns
  void begin_to_receive(const double* own);
  /// @return values at the others, until the next exchange
  const double* end_of_receiving();

  /// Values at the others to send, zero at first.
  double* to_send();
  /// Begins to send them.
  void begin_to_send();
  /// Adds to the own values what other ranks have sent.
  void add_received(double* own);

 private:
  dealii::Utilities::MPI::Partitioner partitioner_;
  std::vector<double> at_others_;
  std::vector<double> at_own_;  ///< in other ranks' exchanges
  std::vector<MPI_Request> requests_;
};

}  // namespace geneva::fem
