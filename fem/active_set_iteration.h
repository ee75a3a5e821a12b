#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fem/discretisation/vector.h"
#include "fem/level.h"

namespace geneva::fem {

/// Converged state on one level.
struct LevelState {
  LevelState() = default;
  LevelState(LevelState&&) = default;
  LevelState(const LevelState&) = delete;  // the ghosts would have no values
  LevelState& operator=(const LevelState&) = delete;
  LevelState& operator=(LevelState&&) = delete;  // see replace() of vectors
  ~LevelState() = default;

  Vector displacement;                          ///< ghosted
  SurfaceForces forces;                         ///< K u - f
  std::vector<ContactState> contacts;           ///< by interface
  std::vector<unsigned int> linear_iterations;  ///< by active-set step
  double assemble_and_solve_seconds = 0.;       ///< of the last step
  bool cycled = false;                          ///< the active set came back to an earlier one
  bool lifts_off = false;  ///< a contact would open that alone holds a body: one node pulls
  bool slides = false;     ///< friction cannot hold a body: one node sticks beyond its bound
};

/// The state that a displacement is on a level with its active sets.
/// @param displacement without ghosts
template <int dim>
LevelState state_at(const Level<dim>& level, const Vector& displacement);

/// Told after every active-set step.
using StepObserver = std::function<void(unsigned int step, unsigned int linear_iterations)>;

/// Primal-dual active set iteration (Hintermueller, Ito and Kunisch 2003); level.interfaces hold
/// the first guess of the active sets and then the final ones.
/// @param guess displacement to start from, without ghosts
/// @return nothing if the active set did not settle within the allowed steps
template <int dim>
std::optional<LevelState> solve_level(const dealii::DoFHandler<dim>& dof_handler, Level<dim>& level,
                                      const Vector& guess, const Settings& settings,
                                      const StepObserver& observer);

}  // namespace geneva::fem
