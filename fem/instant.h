#pragma once

#include <cstddef>
#include <vector>

#include "fem/contact/interface.h"
#include "fem/energy.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

/// What a contact pair carries at one load step, SI units.
template <int dim>
struct PairAtInstant {
  Components<dim> force{};           ///< of the pressure on the source [N]
  Components<dim> friction_force{};  ///< on the source [N]
  double dissipated = 0.;            ///< by friction since the first step [J], >= 0
  std::size_t sticking = 0;          ///< nodes
  std::size_t slipping = 0;
  std::vector<NodeMotion<dim>> motions;  ///< in the units of the triangulation
};

/// One load step.
template <int dim>
struct Instant {
  std::vector<PairAtInstant<dim>> pairs;
  Energy energy;  ///< since the first step, of the modelled part [J]
};

}  // namespace geneva::fem
