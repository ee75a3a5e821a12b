#include "fem/resultants.h"

#include <deal.II/base/mpi.h>

#include <set>

#include "fem/constraints.h"

namespace geneva::fem {

/// Forces that supports and ties exert, from the residual at their nodes.
std::vector<Reaction> reactions(const Solution& solution, const Level& level,
                                const dealii::TrilinosWrappers::MPI::Vector& residual) {
  std::vector<std::string> surfaces;
  for (const Support& support : solution.problem.supports) surfaces.push_back(support.surface);
  for (const RigidTie& tie : solution.problem.ties) surfaces.push_back(tie.surface);
  std::vector<Reaction> result;
  std::set<unsigned int> counted;
  for (const std::string& name : surfaces) {
    Reaction reaction{name, {}, 0.};
    const unsigned int surface = index_of(solution.mesh.surfaces, name);
    for (const BoundaryFace& face : level.boundary.faces) {
      if (face.surface != surface) continue;
      for (const unsigned int index : face.nodes) {
        if (!counted.insert(index).second) continue;
        const BoundaryNode& node = level.boundary.nodes[index];
        const std::array<double, 2> force{
            level.held.count(node.dofs[0]) > 0 ? residual(node.dofs[0]) * solution.scales.force()
                                               : 0.,
            level.held.count(node.dofs[1]) > 0 ? residual(node.dofs[1]) * solution.scales.force()
                                               : 0.};
        reaction.force[0] += force[0];
        reaction.force[1] += force[1];
        reaction.moment +=
            (node.position[0] * force[1] - node.position[1] * force[0]) * solution.scales.length;
      }
    }
    result.push_back(reaction);
  }
  return result;
}

/// Resultant of body forces and surface loads, and its moment about the origin.
AppliedLoad applied_load(const Solution& solution, const Level& level) {
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
