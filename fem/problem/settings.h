#pragma once

#include <optional>

namespace geneva::fem {

/// Which solver of linear systems is taken.
enum class LinearSolver {
  automatic,  ///< ours, and the library's where ours does not converge
  own,
  library  ///< Trilinos' ML
};

/// When to stop refining, and what limits the effort.
struct Settings {
  double accuracy = 0.005;  ///< wanted relative error of the peak contact pressure, without contact
                            ///< of the maxima of stress, > 0
  /// Wanted relative error of the maxima of stress outside of the contacts, > 0; nothing: the mesh
  /// is not refined for them.
  std::optional<double> structural_accuracy = 0.02;
  unsigned int max_levels = 20;     ///< refinements of the coarse mesh
  unsigned int max_dofs = 2000000;  ///< displacement unknowns
  double max_memory = 16e9;         ///< peak resident memory of all ranks together [bytes]
  double max_seconds = 86400.;      ///< wall time of the contact solve [s]
  unsigned int max_active_set_steps = 50;
  double linear_tolerance = 1e-11;  ///< of the conjugate gradients, relative to the load
  LinearSolver linear_solver = LinearSolver::automatic;
};

}  // namespace geneva::fem
