#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/problem/problem.h"

namespace geneva::fem {

/// A maximum of a stress and where it is; SI units.
template <int dim>
struct StressMaximum {
  double value = 0.;  ///< [Pa]; 0 if there is no place for it
  double error = 0.;  ///< relative, by the mesh
  /// Relative: what the cells of the body would leave open if none of their errors cancelled, see
  /// open_by_cells().
  double open = 0.;
  /// Relative, by the choice of what counts as the contacts' own field; 1 where other choices leave
  /// no place.
  double choice = 0.;
  Components<dim> place{};
  int surface = -1;       ///< index into MeshData::surfaces; -1: inside
  bool is_round = false;  ///< whether the surface is part of a circle there
  /// Whether the cells there are so long beside a notch that they may hide a greater stress.
  bool may_be_hidden = false;
  /// Whether it is a tensile stress so far below the von Mises stress that it decides nothing: no
  /// cells are spent on it beside a contact in 3-D, where they are dear.
  bool is_minor = false;

  /// Whether what is taken for the contacts' own field decides on it: it is not away from them.
  [[nodiscard]] bool is_beside_contact() const {
    constexpr double most = 0.1;
    return choice > most;
  }

  /// Both errors together; 1 or more, if they are not known.
  [[nodiscard]] double total_error() const {
    return may_be_hidden ? std::max(1., std::hypot(error, choice)) : std::hypot(error, choice);
  }
};

/// What decides whether a body holds, outside of the contacts' own field.
template <int dim>
struct BodyStrength {
  StressMaximum<dim> von_mises;
  StressMaximum<dim> tensile;  ///< the first principal stress, where it is positive
};

/// By body the maxima for which cells are refined.
template <int dim>
using WantedMaxima = std::vector<std::vector<const StressMaximum<dim>*>>;

/// What the next mesh is for, beside the maxima of stress.
enum class MeshFor {
  unknown_contact,  ///< one of which it is not known how far it reaches: other cells beside it
                    ///< would make its own uneven, and in 3-D only those that may hide a maximum
                    ///< are halved
  contact,
  stresses  ///< alone
};

/// Why the stress of linear elasticity has no bound at a place.
enum class Singularity {
  end_of_support,     ///< a support or rigid tie ends where the surface beside it is free
  re_entrant_corner,  ///< a sharp corner or edge that points into the body
  growth              ///< a corner where it grows from mesh to mesh
};

/// A vertex of the coarse mesh, in 3-D an edge, with unbounded stress, and how far around it
/// stresses are left out: as far as the coarse cells reach there. SI units.
template <int dim>
struct SingularPlace {
  Components<dim> begin, end;  ///< the same in the plane
  double radius;
  Singularity why;
  unsigned int surface;  ///< that is held, or one at the corner; index into MeshData::surfaces
};

}  // namespace geneva::fem
