#include "fem/resultants.h"

#include <deal.II/base/mpi.h>

#include <set>

#include "fem/constraints.h"

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

}  // namespace

/// Each dof counts for the first holder that has it: at common nodes only its line is in force.
template <int dim>
std::vector<Reaction<dim>> reactions(const Solution<dim>& solution, const Level<dim>& level,
                                     const dealii::TrilinosWrappers::MPI::Vector& residual) {
  std::vector<Reaction<dim>> result;
  std::set<global_dof_index> counted;
  for (const Holder<dim>& holder : holders_of(solution.problem)) {
    Tensor<1, dim> sum;
    Moment<dim> moment{};
    const unsigned int surface = index_of(solution.mesh.surfaces, holder.surface);
    for (const BoundaryFace<dim>& face : level.boundary.faces) {
      if (face.surface != surface) continue;
      for (const unsigned int index : face.nodes) {
        const BoundaryNode<dim>& node = level.boundary.nodes[index];
        Tensor<1, dim> force;
        for (unsigned int component = 0; component < dim; ++component)
          if (holder.holds[component] && counted.insert(node.dofs[component]).second)
            force[component] = residual(node.dofs[component]);
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
AppliedLoad<dim> applied_load(const Solution<dim>& solution, const Level<dim>& level) {
  Tensor<1, dim> sum;
  Moment<dim> moment{};
  auto cell_system = level.cells.begin();
  for (const auto& cell : solution.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (unsigned int i = 0; i < cell_system->load.size(); ++i) {
      const auto [component, vertex] = solution.element->system_to_component_index(i);
      Tensor<1, dim> force;
      force[component] = cell_system->load[i];
      sum += force;
      moment += moment_of<dim>(cell->vertex(vertex), force);
    }
    ++cell_system;
  }
  const MPI_Comm communicator = solution.dof_handler->get_communicator();
  sum = dealii::Utilities::MPI::sum(sum, communicator);
  moment = dealii::Utilities::MPI::sum(moment, communicator);
  return {components(Tensor<1, dim>(sum * solution.scales.force())),
          moment * solution.scales.force() * solution.scales.length};
}

template std::vector<Reaction<2>> reactions(const Solution<2>&, const Level<2>&,
                                            const dealii::TrilinosWrappers::MPI::Vector&);
template AppliedLoad<2> applied_load(const Solution<2>&, const Level<2>&);
template std::vector<Reaction<3>> reactions(const Solution<3>&, const Level<3>&,
                                            const dealii::TrilinosWrappers::MPI::Vector&);
template AppliedLoad<3> applied_load(const Solution<3>&, const Level<3>&);

}  // namespace geneva::fem
