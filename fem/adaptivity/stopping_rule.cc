#include "fem/adaptivity/stopping_rule.h"

#include "fem/adaptivity/error_estimate.h"

namespace geneva::fem {

std::optional<Stop> why_to_stop(const std::vector<LevelRecord>& history, const Standing& standing,
                                const Settings& settings) {
  const auto& [error_estimate, edge, peaks_at_corner, n_refinements] = standing;
  if (error_estimate <= settings.accuracy) {
    if (!edge || edge->is_bounded) return Stop{Outcome::converged};
    Stop stop{Outcome::unbounded_edge};
    stop.growth = edge->growth_exponent;
    return stop;
  }
  if (grows_without_bound(history) && peaks_at_corner) return Stop{Outcome::unbounded_pressure};
  if (stands_still(history)) return Stop{Outcome::no_progress};
  if (n_refinements >= settings.max_levels)
    return stop_at_limit(Outcome::refinement_limit, n_refinements + 1., settings.max_levels);
  return std::nullopt;
}

}  // namespace geneva::fem
