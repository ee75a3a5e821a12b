#pragma once

#include <optional>
#include <vector>

#include "fem/adaptivity/level_record.h"
#include "fem/problem/settings.h"
#include "fem/problem/stop.h"

namespace geneva::fem {

/// What is known of the last mesh when it is asked whether to go on.
struct Standing {
  double error_estimate;             ///< relative
  std::optional<EdgePressure> edge;  ///< in 3-D
  bool peaks_at_corner;              ///< of the surfaces, where a pressure may have no bound
  unsigned int n_refinements;
};

/// Why no finer mesh is of use or allowed, as far as what has been solved tells.
/// @param history levels so far, the newest last
/// @return nothing if the refinement goes on
std::optional<Stop> why_to_stop(const std::vector<LevelRecord>& history, const Standing& standing,
                                const Settings& settings);

}  // namespace geneva::fem
