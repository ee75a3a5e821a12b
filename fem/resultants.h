#pragma once

#include <array>
#include <map>
#include <vector>

#include "fem/active_set_iteration.h"
#include "fem/solution.h"

namespace geneva::fem {

/// Forces that supports and ties exert, from the forces at their nodes less what the contact
/// exerts there; SI units.
template <int dim>
std::vector<Reaction<dim>> reactions(const Solution<dim>& solution, const Level<dim>& level,
                                     const LevelState& state);

/// Tractions of supports and ties at the nodes of their surfaces, by dof [Pa]; see
/// held_tractions().
template <int dim>
std::map<global_dof_index, double> tractions_of_holders(const Solution<dim>& solution,
                                                        const Level<dim>& level,
                                                        const LevelState& state);

/// Forces of the contacts on the bodies, the hanging nodes' shares given to the nodes that they
/// hang on, by dof, in the units of the triangulation.
template <int dim>
std::map<global_dof_index, double> contact_forces(const Level<dim>& level, const LevelState& state);

/// Couple of the tractions, which act on either surface where it is undeformed: at source node j
/// the arm is D_j x_j - sum_k M_jk x_k, the initial gap and what lies along the surface [N m].
template <int dim>
Moment<dim> contact_couple(const Solution<dim>& solution, const Level<dim>& level,
                           const LevelState& state);

/// Resultant of body forces and surface loads [N] and its moment about the origin [N m].
template <int dim>
struct AppliedLoad {
  Components<dim> force;
  Moment<dim> moment;
};
template <int dim>
AppliedLoad<dim> applied_load(const Solution<dim>& solution, const Level<dim>& level);

}  // namespace geneva::fem
