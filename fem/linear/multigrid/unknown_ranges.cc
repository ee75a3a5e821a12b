#include "fem/linear/multigrid/unknown_ranges.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>

#include "fem/discretisation/gather.h"

namespace geneva::fem {

UnknownRanges::UnknownRanges(const int n_own, const MPI_Comm communicator)
    : communicator_(communicator),
      rank_(dealii::Utilities::MPI::this_mpi_process(communicator)),
      firsts_{0} {
  const std::vector<int> counts = gathered_one(communicator, n_own);
  std::partial_sum(counts.begin(), counts.end(), std::back_inserter(firsts_));
}

dealii::IndexSet UnknownRanges::own() const {
  dealii::IndexSet result(static_cast<dealii::types::global_dof_index>(n_all()));
  result.add_range(static_cast<dealii::types::global_dof_index>(first()),
                   static_cast<dealii::types::global_dof_index>(end()));
  return result;
}

unsigned int UnknownRanges::owner_of(const int unknown) const {
  const auto after = std::upper_bound(firsts_.begin(), firsts_.end(), unknown);
  return static_cast<unsigned int>(after - firsts_.begin() - 1);
}

}  // namespace geneva::fem
