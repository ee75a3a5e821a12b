#pragma once

#include <deal.II/base/point.h>

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "fem/adaptivity/level_record.h"
#include "fem/contact/surface.h"
#include "fem/discretisation/saved_field.h"

namespace geneva::fem {

/// What the choice of the next mesh knows beside the history of the meshes.
struct RefinementState {
  unsigned int n_refinements = 0;
  bool surroundings_are_fine = false;  ///< no cell around the contact is larger than asked for
  double open_gap = std::numeric_limits<double>::max();  ///< least gap of the last open mesh
  unsigned int same_open_gaps = 0;                       ///< meshes in a row that left it as it was
  double unevenness_levelled = std::numeric_limits<double>::max();  ///< before the last levelling
  unsigned int cells_beside = 0;  ///< more cells for the stresses away from the contacts, at least
};

/// All that the nested iteration needs to go on from a mesh that it has solved.
template <int dim>
struct Checkpoint {
  SavedField<dim> field;
  SurfaceOrigins<dim> origins;
  /// Places of the active nodes of every pair, in the units of the triangulation.
  std::vector<std::vector<dealii::Point<dim>>> active;
  std::vector<LevelRecord> history;  ///< its last mesh is the field's
  RefinementState refinement;
};

/// Everything but the field.
template <int dim>
nlohmann::json json_of(const Checkpoint<dim>& checkpoint);

/// @param field already checked
/// @throws base::InputError unless it is complete, finite and in range
template <int dim>
Checkpoint<dim> checkpoint_of(const nlohmann::json& given, SavedField<dim> field);

}  // namespace geneva::fem
