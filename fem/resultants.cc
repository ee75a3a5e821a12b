#include "fem/resultants.h"

#include <deal.II/base/mpi.h>

#include <set>

#include "fem/constraints.h"

namespace geneva::fem {

/// A surface and the displacement components that it holds.
struct Holder {
  std::string surface;
  std::array<bool, 2> holds;
};

/// Each dof counts for the first holder that has it: at common nodes only its line is in force.
std::vector<Reaction> reactions(const Solution& solution, const Level<2>& level,
                                const dealii::TrilinosWrappers::MPI::Vector& residual) {
  std::vector<Holder> holders;
  for (const Support<2>& support : solution.problem.supports)
    holders.push_back({support.surface,
                       {support.displacement[0].has_value(), support.displacement[1].has_value()}});
  for (const RigidTie<2>& tie : solution.problem.ties)
    holders.push_back({tie.surface, {true, true}});
  std::vector<Reaction> result;
  std::set<global_dof_index> counted;
  for (const Holder& holder : holders) {
    Reaction reaction{holder.surface, {}, 0.};
    const unsigned int surface = index_of(solution.mesh.surfaces, holder.surface);
    for (const BoundaryFace<2>& face : level.boundary.faces) {
      if (face.surface != surface) continue;
      for (const unsigned int index : face.nodes)
        for (unsigned int component = 0; component < 2; ++component) {
          const BoundaryNode<2>& node = level.boundary.nodes[index];
          const global_dof_index dof = node.dofs[component];
          if (!holder.holds[component] || !counted.insert(dof).second) continue;
          const double force = residual(dof) * solution.scales.force();
          const double arm = component == 0 ? -node.position[1] : node.position[0];
          reaction.force[component] += force;
          reaction.moment += force * arm * solution.scales.length;
        }
    }
    result.push_back(reaction);
  }
  return result;
}

/// Resultant of body forces and surface loads, and its moment about the origin.
AppliedLoad applied_load(const Solution& solution, const Level<2>& level) {
  std::array<double, 3> sums{0., 0., 0.};
  auto cell_system = level.cells.begin();
  for (const auto& cell : solution.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (unsigned int i = 0; i < cell_system->load.size(); ++i) {
      const auto [component, vertex] = solution.element->system_to_component_index(i);
      const double force = cell_system->load[i] * solution.scales.force();
      sums[component] += force;
      const double arm = component == 0 ? -cell->vertex(vertex)[1] : cell->vertex(vertex)[0];
      sums[2] += force * arm * solution.scales.length;
    }
    ++cell_system;
  }
  const MPI_Comm communicator = solution.dof_handler->get_communicator();
  for (double& sum : sums) sum = dealii::Utilities::MPI::sum(sum, communicator);
  return {{sums[0], sums[1]}, sums[2]};
}

}  // namespace geneva::fem
