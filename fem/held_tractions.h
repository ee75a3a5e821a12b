#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "fem/discretisation/boundary.h"
#include "fem/linear/constraints.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

template <int dim>
using HeldComponents = std::map<unsigned int, std::array<bool, static_cast<std::size_t>(dim)>>;

/// Tractions at the nodes of surfaces that are held, by dof: the force at a node over its share of
/// the surface, F_i / integral of N_i. Since the forces balance the stresses in the body exactly,
/// they are more accurate than stresses evaluated in cells (G. F. Carey, S. S. Chow and M. K.
/// Seager, Comput. Methods Appl. Mech. Engrg. 50, 1985).
/// @param held by boundary id, which components are: a dof has its share of the surfaces that hold
/// it, and no traction if none does
/// @param hanging_lines of the boundary's dofs: a hanging node's share is that of the nodes that it
/// hangs on
/// @param force exerted on the body at a dof of those surfaces
/// @return in the unit of the force over that of the mesh's length squared; none of hanging nodes
template <int dim>
std::map<global_dof_index, double> held_tractions(
    const Boundary<dim>& boundary, const Problem<dim>& problem, const HeldComponents<dim>& held,
    const std::vector<ConstraintLine>& hanging_lines,
    const std::function<double(global_dof_index)>& force);

}  // namespace geneva::fem
