#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "fem/equilibrium.h"
#include "fem/instant.h"

namespace geneva::fem {

/// Told of each step's equilibrium while the equilibrium's level stands there; may be empty.
using StepWatch = std::function<void(std::size_t step, const LevelState&)>;

/// Goes through a problem's load steps on one mesh, from the undisplaced bodies on; what sticks and
/// slips at one follows from those before.
/// @param start first guess of the first step
/// @param instants in: those of the last mesh, if there is one; out: what was found at each step,
/// or as they were if a step has no equilibrium
/// @return the equilibrium of the last step, or why a step has none
template <int dim>
Solved walk(Equilibrium<dim>& equilibrium, const State<dim>& start, const Problem<dim>& problem,
            const Settings& settings, const StepObserver& observer, const StepWatch& watch,
            std::vector<Instant<dim>>& instants);

}  // namespace geneva::fem
