#pragma once

#include <string>

#include "fem/level.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

/// Which nodes of the contact pairs are taken as closed; those that stick, or may, hold a body
/// along the surface, too.
enum class TakenAsClosed {
  all_nodes,
  all_nodes_sliding,  ///< without friction
  active_nodes
};

/// Whether supports, ties and contact pairs leave a body free to move rigidly.
template <int dim>
bool has_free_motion(const Level<dim>& level, const Problem<dim>& problem, TakenAsClosed closed);

/// Whether a body is free to move rigidly if one pair has no friction, and all others stick.
template <int dim>
bool is_held_by_friction(const Level<dim>& level, const Problem<dim>& problem,
                         const ContactInterface<dim>& interface);

/// Whether a body is free to move rigidly if one pair is open, and all others are closed.
template <int dim>
bool is_held_by_contact(const Level<dim>& level, const Problem<dim>& problem,
                        const ContactInterface<dim>& interface);

/// Checks that supports, ties and contact pairs leave no body free to move rigidly, taking every
/// contact that could close as closed.
/// @throws base::InputError naming the body that moves most and how
template <int dim>
void check_rigid_motions(const Level<dim>& level, const Problem<dim>& problem);

}  // namespace geneva::fem
