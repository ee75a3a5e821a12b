#include "fem/mesh_result.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/adaptivity/lengthwise_pressure.h"
#include "fem/adaptivity/refinement.h"
#include "fem/contact/active_set.h"
#include "fem/contact/peak_in_plane.h"
#include "fem/contact/result.h"
#include "fem/contact/surface_strain.h"
#include "fem/contact/zone.h"
#include "fem/problem/source_sides.h"
#include "fem/resultants.h"
#include "fem/symmetry.h"

namespace geneva::fem {

unsigned int n_active_nodes(const std::vector<NodeStatus>& status) {
  return static_cast<unsigned int>(std::count_if(status.begin(), status.end(), is_closed));
}

template <int dim>
std::vector<ContactResult<dim>> contact_results(const Solution<dim>& solution,
                                                const Level<dim>& level, const LevelState& found) {
  std::vector<ContactResult<dim>> contacts;
  for (std::size_t i = 0; i < level.interfaces.size(); ++i) {
    ContactResult<dim> contact = contact_result(solution.problem.pairs[i], level.interfaces[i],
                                                found.contacts[i], solution.scales);
    const auto places = mirrors(solution.mesh, solution.problem, contact);
    for (unsigned int k = 0; k < dim; ++k) {
      if (!places[k]) continue;
      std::swap(contact.force[k], contact.lateral_force[k]);
      contact.friction_force[k] = 0.;  // its mirror image cancels it
    }
    if constexpr (dim == 2) {
      count_from_mirrors(contact, places, solution.scales.length);
      const ContactInterface<2>& interface = level.interfaces[i];
      if (solution.problem.plane != PlaneKind::axisymmetric)
        correct_for_nodes(contact, {ratio_of_edges(interface), 1. - interface.source_share});
      const auto strains = surface_strains(interface, found.displacement);
      for (std::size_t j = 0; j < strains.size(); ++j) contact.nodes[j].strain = strains[j];
    }
    contacts.push_back(std::move(contact));
  }
  return contacts;
}

template <int dim>
void put_result(Solution<dim>& solution, const Level<dim>& level, const LevelState& found) {
  solution.contacts = contact_results(solution, level, found);
  solution.reactions = reactions(solution, level, found);
  solution.held_tractions = tractions_of_holders(solution, level, found);
  solution.contact_couple = contact_couple(solution, level, found);
  const AppliedLoad<dim> load = applied_load(solution, level);
  solution.applied_force = load.force;
  solution.applied_moment = load.moment;
  replace(solution.displacement, with_ghosts(found.displacement, level.ghosts));
}

namespace {

void record_lengthwise(LevelRecord& record, const Solution<3>& solution) {
  for (const ContactResult<3>& contact : solution.contacts) {
    const LengthwisePressure maximum =
        lengthwise_pressure(contact, symmetry_plane(solution.mesh, solution.problem, contact, 2));
    record.mid_length_pressure = std::max(record.mid_length_pressure, maximum.middle);
    record.end_pressure = std::max(record.end_pressure, maximum.end);
  }
}

}  // namespace

template <int dim>
LevelRecord record_of(const Solution<dim>& solution, const Equilibrium<dim>& equilibrium,
                      const LevelState& found, const SurfaceIds& surface_ids) {
  const Level<dim>& level = equilibrium.level();
  LevelRecord record{};
  record.cells = solution.triangulation->n_global_active_cells();
  record.dofs = solution.dof_handler->n_dofs();
  record.linear_iterations = found.linear_iterations;
  for (const ContactResult<dim>& contact : solution.contacts)
    record.peak_pressure = std::max(record.peak_pressure, contact.peak_pressure);
  if constexpr (dim == 3) record_lengthwise(record, solution);
  record.size_measure = size_measure(*equilibrium.mesh().dof_handler, level.interfaces, surface_ids,
                                     size_decay(solution.problem));
  record.active_nodes = n_active_nodes(level);
  for (const ContactInterface<dim>& interface : level.interfaces)
    record.nodes_across += nodes_across(interface);
  record.cycled = found.cycled;
  record.one_solve_seconds = found.assemble_and_solve_seconds;
  return record;
}

namespace {

template <int dim>
const ContactResult<dim>& with_peak(const std::vector<ContactResult<dim>>& contacts) {
  return *std::max_element(contacts.begin(), contacts.end(), [](const auto& a, const auto& b) {
    return a.peak_pressure < b.peak_pressure;
  });
}

}  // namespace

template <int dim>
double scatter_of_peak([[maybe_unused]] const std::vector<ContactResult<dim>>& contacts) {
  if constexpr (dim == 2)
    if (!contacts.empty()) {
      const ContactResult<2>& contact = with_peak(contacts);
      return std::hypot(fitted_peak(contact.nodes).scatter, share_of_free_ends(contact).doubt);
    }
  return 0.;
}

template <int dim>
double poissons_ratio_at_peak(const Solution<dim>& solution) {
  const auto pair =
      static_cast<std::size_t>(&with_peak(solution.contacts) - solution.contacts.data());
  return mean_poissons_ratio(solution.mesh, solution.problem, solution.problem.pairs[pair]);
}

template <int dim>
bool peaks_at_corner([[maybe_unused]] const Solution<dim>& solution,
                     [[maybe_unused]] const Level<dim>& level,
                     [[maybe_unused]] const LevelState& found) {
  if constexpr (dim == 2) {
    const auto pair =
        static_cast<std::size_t>(&with_peak(solution.contacts) - solution.contacts.data());
    return peaks_at_corner(level.interfaces[pair], found.contacts[pair]);
  }
  return true;
}

template <int dim>
bool reaches_axis(const Problem<dim>& problem, const Level<dim>& level) {
  return problem.plane == PlaneKind::axisymmetric &&
         std::any_of(level.interfaces.begin(), level.interfaces.end(), [](const auto& interface) {
           const auto& status = interface.status;
           return !status.empty() && status.front() != status.back();
         });
}

#define INSTANTIATE(dim)                                                                           \
  template std::vector<ContactResult<dim>> contact_results(const Solution<dim>&,                   \
                                                           const Level<dim>&, const LevelState&);  \
  template void put_result(Solution<dim>&, const Level<dim>&, const LevelState&);                  \
  template LevelRecord record_of(const Solution<dim>&, const Equilibrium<dim>&, const LevelState&, \
                                 const SurfaceIds&);                                               \
  template double scatter_of_peak(const std::vector<ContactResult<dim>>&);                         \
  template double poissons_ratio_at_peak(const Solution<dim>&);                                    \
  template bool peaks_at_corner(const Solution<dim>&, const Level<dim>&, const LevelState&);       \
  template bool reaches_axis(const Problem<dim>&, const Level<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace geneva::fem
