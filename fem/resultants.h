#pragma once

#include <array>
#include <vector>

#include "fem/level.h"
#include "fem/solution.h"

namespace geneva::fem {

/// Forces that supports and ties exert, from the residual at their nodes; SI units.
std::vector<Reaction> reactions(const Solution& solution, const Level<2>& level,
                                const dealii::TrilinosWrappers::MPI::Vector& residual);

/// Resultant of body forces and surface loads [N] and its moment about the origin [N m].
struct AppliedLoad {
  std::array<double, 2> force;
  double moment;
};
AppliedLoad applied_load(const Solution& solution, const Level<2>& level);

}  // namespace geneva::fem
