#pragma once

#include <cstddef>
#include <stdexcept>

namespace geneva::fem {

/// Why the refinement ended.
enum class Outcome {
  converged,
  unbounded_edge,      ///< the pressure grows at an end of the contact's length; the rest has
                       ///< converged
  unbounded_pressure,  ///< the peak pressure grows from mesh to mesh: the contact reaches a sharp
                       ///< edge
  no_progress,         ///< neither contact nor pressure change while the mesh becomes finer
  refinement_limit,
  dof_limit,         ///< of the next mesh
  coarse_dof_limit,  ///< of the coarse mesh already
  memory_limit,      ///< would be exceeded by the next mesh
  out_of_memory,     ///< an allocation failed
  time_limit,        ///< would be exceeded by the next mesh
  active_set_limit,  ///< it did not settle
  slides,            ///< friction cannot hold a body that nothing else holds
  linear_solver      ///< it did not converge
};

/// Whether all was reached that linear elasticity has to give.
constexpr bool is_success(const Outcome outcome) {
  return outcome == Outcome::converged || outcome == Outcome::unbounded_edge;
}

/// Why the refinement ended, and the figures of that.
struct Stop {
  Outcome outcome = Outcome::converged;
  /// What was needed, or would be on the next mesh: unknowns, memory [byte], time [s], active-set
  /// steps, linear iterations; friction [N].
  double needed = 0.;
  double limit = 0.;         ///< of that
  std::size_t unknowns = 0;  ///< of the mesh that was not solved
  double residual = 0.;      ///< of the linear solver
  double growth = 0.;        ///< exponent gamma of the edge pressure, p ~ h^-gamma
  std::size_t pair = 0;      ///< that slides
  std::size_t step = 0;      ///< of the load, from 0 on
};

/// @param outcome that of the limit
/// @param needed, limit in its unit
/// @param unknowns of the mesh that was not solved
inline Stop stop_at_limit(const Outcome outcome, const double needed, const double limit,
                          const std::size_t unknowns = 0) {
  Stop stop{outcome};
  stop.needed = needed;
  stop.limit = limit;
  stop.unknowns = unknowns;
  return stop;
}

/// There is no state on any mesh.
class NotConverged : public std::runtime_error {
 public:
  explicit NotConverged(const Stop& why)
      : std::runtime_error("the contact solve has no state on any mesh"), stop(why) {}

  Stop stop;
};

}  // namespace geneva::fem
