#pragma once

#include <vector>

#include "fem/adaptivity/refinement_zone.h"
#include "fem/equilibrium.h"
#include "fem/solution.h"

namespace geneva::fem {

/// What the contact pairs carry, SI units; forces without those that planes of symmetry balance.
template <int dim>
std::vector<ContactResult<dim>> contact_results(const Solution<dim>& solution,
                                                const Level<dim>& level, const LevelState& found);

/// Puts what was found on a mesh into the solution: contacts, reactions, loads, displacement.
template <int dim>
void put_result(Solution<dim>& solution, const Level<dim>& level, const LevelState& found);

/// What a mesh and its solve were; without what the refinement and the time tell.
template <int dim>
LevelRecord record_of(const Solution<dim>& solution, const Equilibrium<dim>& equilibrium,
                      const LevelState& found, const SurfaceIds& surface_ids);

/// Whether the maximum pressure stands at an end or a corner of its surfaces; elsewhere it has a
/// bound, however steeply it rises. In 3-D the surfaces always have edges.
template <int dim>
bool peaks_at_corner(const Solution<dim>& solution, const Level<dim>& level,
                     const LevelState& found);

/// What is open of the maximum pressure by the scatter of its nodes: the 95 % interval of its fit,
/// and the doubt of its ends; relative, 0 in 3-D.
template <int dim>
double scatter_of_peak(const std::vector<ContactResult<dim>>& contacts);

/// See mean_poissons_ratio(), of the contact with the peak pressure.
template <int dim>
double poissons_ratio_at_peak(const Solution<dim>& solution);

/// Whether a contact begins on the axis of revolution.
template <int dim>
bool reaches_axis(const Problem<dim>& problem, const Level<dim>& level);

unsigned int n_active_nodes(const std::vector<NodeStatus>& status);

/// Nodes in contact, of all pairs.
template <int dim>
unsigned int n_active_nodes(const Level<dim>& level) {
  unsigned int count = 0;
  for (const ContactInterface<dim>& interface : level.interfaces)
    count += n_active_nodes(interface.status);
  return count;
}

}  // namespace geneva::fem
