#pragma once

#include <optional>
#include <vector>

#include "fem/adaptivity/error_estimate.h"
#include "fem/adaptivity/force_error.h"

namespace geneva::fem {

/// What is known of the contacts on the last mesh beside the pressures of all meshes.
struct ContactTraits {
  Convergence convergence;
  double grading;              ///< maximum ratio of cell size to distance from the contact
  double error_by_nodes;       ///< where the ends lie between them, and their scatter; relative
  bool has_free_ends;          ///< see there
  bool is_uneven;              ///< edges of very different lengths, whose pressure is of no use
  bool surroundings_are_fine;  ///< no cell around the contact is larger than asked for
  ForcePower force = {};       ///< how the peak pressure goes with it
};

/// Estimated error of the peak pressure, or, where that has no bound, of the pressure in the middle
/// of the length; relative, from 0 to 1.
struct PressureError {
  double zone = 1.;                  ///< by the resolution of the contact itself
  double surroundings = 1.;          ///< by the cells around it
  double correction = 0.;            ///< to be added to the pressure of the mesh
  std::optional<EdgePressure> edge;  ///< in 3-D

  [[nodiscard]] bool is_of_peak() const { return !edge || edge->is_bounded; }
  [[nodiscard]] double total() const { return error_of(zone, surroundings); }
};

/// @param history levels so far, the newest last
template <int dim>
PressureError pressure_error(const std::vector<LevelRecord>& history, const ContactTraits& contact);

}  // namespace geneva::fem
