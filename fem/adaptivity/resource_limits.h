#pragma once

#include <mpi.h>

#include <optional>
#include <vector>

#include "fem/adaptivity/level_record.h"
#include "fem/problem/settings.h"
#include "fem/problem/stop.h"

namespace geneva::fem {

/// Maximum resident memory since the last ResourceLimits were made, or since the start of the
/// process if there were none, of all ranks together [byte].
double peak_memory(MPI_Comm communicator);

/// Unknowns, memory and time that a case allows; what the next mesh will take is foreseen from the
/// last ones.
class ResourceLimits {
 public:
  /// Memory that is taken now is not counted as that of a mesh.
  ResourceLimits(MPI_Comm communicator, const Settings& settings);

  /// Which limit a mesh would exceed that is larger than the last one by a factor; the same on all
  /// ranks. It takes at least as much longer as it is larger.
  /// @param history levels so far, the newest last
  /// @param seconds_before of the runs that this one continues, which `history` includes [s]
  [[nodiscard]] std::optional<Stop> exceeded_by_next(double growth,
                                                     const std::vector<LevelRecord>& history,
                                                     double seconds_before) const;

  /// Whether a mesh has too many unknowns.
  [[nodiscard]] std::optional<Stop> exceeded_by(double unknowns) const;

 private:
  MPI_Comm communicator_;
  Settings settings_;
  double memory_at_start_;  ///< [byte]
};

}  // namespace geneva::fem
