#pragma once

#include <mpi.h>

#include "fem/level.h"
#include "fem/problem/scaling.h"

namespace geneva::fem {

/// Whether the system of a mesh is factorised because point smoothers would fail on it: in the
/// plane, with a nearly incompressible body (lambda > 10 mu, nu > 0.4545; there all motions are
/// stiff but those that keep the cells' volumes) or with a body a hundred times as stiff as another
/// (where they touch, nodes of the soft one carry the stiffness of both).
/// @param problem in any units
template <int dim>
bool is_factorised(const Problem<dim>& problem);

/// Checks that no body is so much stiffer than another that the roundings of its rigid motion would
/// be forces comparable to the contact's; in 3-D, also that no source is so much stiffer than its
/// target that smoothers fail (their nodes follow the target's, which then carry a stiff body).
/// @param problem in any units, its bodies in the order of the mesh's
/// @throws base::InputError naming the bodies, their ratio, what is allowed and what to do
template <int dim>
void check_stiffness_ratio(const Problem<dim>& problem, const mesh::MeshData<dim>& mesh);

/// Checks that loads and supports push the bodies into each other by more than the roundings of
/// their coordinates.
/// @param level of the first mesh
/// @param scaled_problem in the units of the triangulation
/// @throws base::InputError naming the approach and the rounding
template <int dim>
void check_approach(const Level<dim>& level, const Problem<dim>& scaled_problem,
                    const Scales& scales, MPI_Comm communicator);

}  // namespace geneva::fem
