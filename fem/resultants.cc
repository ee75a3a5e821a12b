#include "fem/resultants.h"

#include <deal.II/base/mpi.h>

#include <functional>
#include <map>
#include <set>

#include "fem/held_tractions.h"
#include "fem/linear/constraints.h"

namespace geneva::fem {

using dealii::Tensor;

namespace {

/// A surface and the displacement components that it holds.
template <int dim>
struct Holder {
  std::string surface;
  std::array<bool, static_cast<std::size_t>(dim)> holds;
};

template <int dim>
std::vector<Holder<dim>> holders_of(const Problem<dim>& problem) {
  std::vector<Holder<dim>> holders;
  for (const Support<dim>& support : problem.supports) {
    Holder<dim> holder{support.surface, {}};
    for (std::size_t component = 0; component < dim; ++component)
      holder.holds[component] = support.displacement[component].has_value();
    holders.push_back(holder);
  }
  for (const RigidTie<dim>& tie : problem.ties) {
    holders.push_back({tie.surface, {}});
    holders.back().holds.fill(true);
  }
  return holders;
}

template <int dim>
Components<dim> components(const Tensor<1, dim>& vector) {
  Components<dim> result{};
  for (unsigned int component = 0; component < dim; ++component)
    result[component] = vector[component];
  return result;
}

/// Force that supports and ties exert at a dof: what acts there less what the contact exerts. Valid
/// as long as the level and the state are.
template <int dim>
std::function<double(global_dof_index)> held_force(const Level<dim>& level,
                                                   const LevelState& state) {
  return [&level, &state, contact = contact_forces(level, state)](const global_dof_index dof) {
    if (level.held.count(dof) == 0) return 0.;
    const auto of_contact = contact.find(dof);
    return state.forces(dof) - (of_contact == contact.end() ? 0. : of_contact->second);
  };
}

/// Traction of the friction on the source.
template <int dim>
Tensor<1, dim> friction_vector(const ContactRow<dim>& row, const ContactState& state,
                               const std::size_t at) {
  Tensor<1, dim> friction;
  for (std::size_t t = 0; t < row.frame.tangents.size(); ++t)
    friction += state.friction[at][t] * row.frame.tangents[t];
  return friction;
}

}  // namespace

template <int dim>
std::map<global_dof_index, double> contact_forces(const Level<dim>& level,
                                                  const LevelState& state) {
  std::map<global_dof_index, double> forces;
  for (std::size_t i = 0; i < level.interfaces.size(); ++i) {
    const ContactInterface<dim>& interface = level.interfaces[i];
    for (std::size_t j = 0; j < interface.rows.size(); ++j) {
      const ContactRow<dim>& row = interface.rows[j];
      if (state.contacts[i].pressure[j] == 0.) continue;
      const Tensor<1, dim> traction = state.contacts[i].pressure[j] * row.frame.normal +
                                      friction_vector(row, state.contacts[i], j);
      for (unsigned int component = 0; component < dim; ++component) {
        forces[interface.source.nodes[row.node].dofs[component]] +=
            row.weight * traction[component];
        for (const auto& [node, coupling] : row.coupling)
          forces[interface.target.nodes[node].dofs[component]] -= coupling * traction[component];
      }
    }
  }
  for (const ConstraintLine& line : level.hanging_lines) {
    const auto hanging = forces.find(line.dof);
    if (hanging == forces.end()) continue;
    for (const auto& [dof, share] : line.entries) forces[dof] += share * hanging->second;
    hanging->second = 0.;
  }
  return forces;
}

/// Each dof counts for the first holder that has it: at common nodes only its line is in force.
template <int dim>
std::vector<Reaction<dim>> reactions(const Solution<dim>& solution, const Level<dim>& level,
                                     const LevelState& state) {
  const auto force_at = held_force(level, state);
  std::vector<Reaction<dim>> result;
  std::set<global_dof_index> counted;
  for (const Holder<dim>& holder : holders_of(solution.problem)) {
    Tensor<1, dim> sum;
    Moment<dim> moment{};
    const unsigned int surface = mesh::index_of(solution.mesh.surfaces, holder.surface);
    for (const BoundaryFace<dim>& face : level.boundary.faces) {
      if (face.surface != surface) continue;
      for (const unsigned int index : face.nodes) {
        const BoundaryNode<dim>& node = level.boundary.nodes[index];
        Tensor<1, dim> force;
        for (unsigned int component = 0; component < dim; ++component)
          if (holder.holds[component] && counted.insert(node.dofs[component]).second)
            force[component] = force_at(node.dofs[component]);
        sum += force;
        moment += moment_of<dim>(node.position, force);
      }
    }
    result.push_back({holder.surface, components(Tensor<1, dim>(sum * solution.scales.force())),
                      moment * solution.scales.force() * solution.scales.length});
  }
  return result;
}

template <int dim>
std::map<global_dof_index, double> tractions_of_holders(const Solution<dim>& solution,
                                                        const Level<dim>& level,
                                                        const LevelState& state) {
  HeldComponents<dim> held;
  for (const Holder<dim>& holder : holders_of(solution.problem)) {
    auto& components = held[mesh::index_of(solution.mesh.surfaces, holder.surface)];
    for (std::size_t c = 0; c < components.size(); ++c) components[c] |= holder.holds[c];
  }
  const auto force = held_force(level, state);
  const double scale = solution.scales.stress;
  return held_tractions<dim>(level.boundary, scaled(solution.problem, solution.scales), held,
                             level.hanging_lines,
                             [&](const global_dof_index dof) { return scale * force(dof); });
}

template <int dim>
Moment<dim> contact_couple(const Solution<dim>& solution, const Level<dim>& level,
                           const LevelState& state) {
  Moment<dim> couple{};
  for (std::size_t i = 0; i < level.interfaces.size(); ++i) {
    const ContactInterface<dim>& interface = level.interfaces[i];
    for (std::size_t j = 0; j < interface.rows.size(); ++j) {
      const ContactRow<dim>& row = interface.rows[j];
      Tensor<1, dim> arm = row.weight * interface.source.nodes[row.node].position;
      for (const auto& [node, coupling] : row.coupling)
        arm -= coupling * interface.target.nodes[node].position;
      couple += moment_of<dim>(arm, state.contacts[i].pressure[j] * row.frame.normal +
                                        friction_vector(row, state.contacts[i], j));
    }
  }
  return couple * solution.scales.force() * solution.scales.length;
}

template <int dim>
AppliedLoad<dim> applied_load(const Solution<dim>& solution, const Level<dim>& level) {
  Tensor<1, dim> sum;
  Moment<dim> moment{};
  std::size_t index = 0;
  for (const auto& cell : solution.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const dealii::Vector<double> load = level.cells.load(index++);
    for (unsigned int i = 0; i < load.size(); ++i) {
      const auto [component, vertex] = solution.element->system_to_component_index(i);
      Tensor<1, dim> force;
      force[component] = load[i];
      sum += force;
      moment += moment_of<dim>(cell->vertex(vertex), force);
    }
  }
  const MPI_Comm communicator = solution.dof_handler->get_communicator();
  sum = dealii::Utilities::MPI::sum(sum, communicator);
  moment = dealii::Utilities::MPI::sum(moment, communicator);
  return {components(Tensor<1, dim>(sum * solution.scales.force())),
          moment * solution.scales.force() * solution.scales.length};
}

template std::map<global_dof_index, double> tractions_of_holders(const Solution<2>&,
                                                                 const Level<2>&,
                                                                 const LevelState&);
template std::map<global_dof_index, double> tractions_of_holders(const Solution<3>&,
                                                                 const Level<3>&,
                                                                 const LevelState&);
template std::map<global_dof_index, double> contact_forces(const Level<2>&, const LevelState&);
template std::map<global_dof_index, double> contact_forces(const Level<3>&, const LevelState&);
template std::vector<Reaction<2>> reactions(const Solution<2>&, const Level<2>&, const LevelState&);
template Moment<2> contact_couple(const Solution<2>&, const Level<2>&, const LevelState&);
template Moment<3> contact_couple(const Solution<3>&, const Level<3>&, const LevelState&);
template AppliedLoad<2> applied_load(const Solution<2>&, const Level<2>&);
template std::vector<Reaction<3>> reactions(const Solution<3>&, const Level<3>&, const LevelState&);
template AppliedLoad<3> applied_load(const Solution<3>&, const Level<3>&);

}  // namespace geneva::fem
