#pragma once

#include <cmath>

#include "fem/problem/problem.h"

namespace geneva::fem {

/// A maximum of a stress and where it is; SI units.
template <int dim>
struct StressMaximum {
  double value = 0.;  ///< [Pa]; 0 if there is no place for it
  double error = 0.;  ///< relative, by the mesh
  /// Relative, by the choice of what counts as the contacts' own field; 1 where other choices leave
  /// no place.
  double choice = 0.;
  Components<dim> place{};
  int surface = -1;       ///< index into MeshData::surfaces; -1: inside
  bool is_round = false;  ///< whether the surface is part of a circle there

  /// Both errors together.
  [[nodiscard]] double total_error() const { return std::hypot(error, choice); }
};

/// What decides whether a body holds, outside of the contacts' own field.
template <int dim>
struct BodyStrength {
  StressMaximum<dim> von_mises;
  StressMaximum<dim> tensile;  ///< the first principal stress, where it is positive
};

}  // namespace geneva::fem
