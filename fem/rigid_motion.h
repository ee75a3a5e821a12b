#pragma once

#include "fem/level.h"
#include "fem/problem.h"

namespace geneva::fem {

/// Checks that supports, ties and contact pairs leave no body free to move rigidly, taking every
/// contact that could close as closed.
/// @throws base::InputError naming the body that moves most and how
template <int dim>
void check_rigid_motions(const Level<dim>& level, const Problem<dim>& problem);

}  // namespace geneva::fem
