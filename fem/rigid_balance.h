#pragma once

#include <deal.II/dofs/dof_handler.h>

#include <optional>
#include <string>

#include "fem/level.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

/// A rigid motion of bodies.
struct UnresistedMotion {
  std::string what;  ///< "body 'block' can rotate freely", of the body that moves most
  bool is_rotation;
};

/// The rigid motion by which the loads do work and that nothing can resist: no pressures with
/// friction within its bounds, at whichever nodes of the contacts, and no supports balance the
/// loads then. Bodies are as they are before they deform.
///
/// By Farkas' lemma it is what the sum of forces and moments is off by where contacts balance the
/// loads best, and there is none if they balance them.
/// @return nothing if there is a balance to a thousandth
template <int dim>
std::optional<UnresistedMotion> unresisted_motion(const dealii::DoFHandler<dim>& dof_handler,
                                                  const Level<dim>& level,
                                                  const Problem<dim>& problem);

}  // namespace geneva::fem
