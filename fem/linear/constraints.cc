#include "fem/linear/constraints.h"

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "fem/discretisation/gather.h"

namespace geneva::fem {

namespace {

/// Nodes of one surface, in the order of the boundary's nodes.
template <int dim>
std::vector<BoundaryNode<dim>> nodes_of(const Boundary<dim>& boundary, const unsigned int surface) {
  std::set<unsigned int> indices;
  for (const BoundaryFace<dim>& face : boundary.faces)
    if (face.surface == surface) indices.insert(face.nodes.begin(), face.nodes.end());
  std::vector<BoundaryNode<dim>> nodes;
  nodes.reserve(indices.size());
  for (const unsigned int index : indices) nodes.push_back(boundary.nodes[index]);
  return nodes;
}

struct LineHead {
  global_dof_index dof;
  std::size_t n_entries;
  double inhomogeneity;
};

struct LineEntry {
  global_dof_index dof;
  double coefficient;
};

/// The lines of all ranks, the same on every rank.
std::vector<ConstraintLine> gathered_lines(const MPI_Comm communicator,
                                           const std::vector<ConstraintLine>& own) {
  std::vector<LineHead> heads;
  std::vector<LineEntry> entries;
  for (const ConstraintLine& line : own) {
    heads.push_back({line.dof, line.entries.size(), line.inhomogeneity});
    for (const auto& [dof, coefficient] : line.entries) entries.push_back({dof, coefficient});
  }
  const std::vector<LineEntry> all_entries = gathered(communicator, entries);
  auto next = all_entries.begin();
  std::vector<ConstraintLine> lines;
  for (const LineHead& head : gathered(communicator, heads)) {
    lines.push_back({head.dof, {}, head.inhomogeneity});
    for (std::size_t i = 0; i < head.n_entries; ++i, ++next)
      lines.back().entries.emplace_back(next->dof, next->coefficient);
  }
  return lines;
}

}  // namespace

template <int dim>
std::vector<ConstraintLine> support_lines(const Boundary<dim>& boundary,
                                          const std::vector<Support<dim>>& supports,
                                          const std::vector<std::string>& surfaces) {
  std::map<global_dof_index, double> values;
  for (const Support<dim>& support : supports)
    for (const BoundaryNode<dim>& node :
         nodes_of(boundary, mesh::index_of(surfaces, support.surface)))
      for (unsigned int component = 0; component < dim; ++component)
        if (const auto value = support.displacement[component]) {
          const auto [entry, is_new] = values.emplace(node.dofs[component], *value);
          if (!is_new && entry->second != *value)
            throw base::InputError(
                "support '" + support.surface +
                "' meets another support that prescribes a different displacement "
                "at their common node");
        }
  std::vector<ConstraintLine> lines;
  lines.reserve(values.size());
  for (const auto& [dof, value] : values) lines.push_back({dof, {}, value});
  return lines;
}

template <int dim>
TieLines tie_lines(const Boundary<dim>& boundary, const RigidTie<dim>& tie,
                   const std::vector<std::string>& surfaces) {
  const auto nodes = nodes_of(boundary, mesh::index_of(surfaces, tie.surface));
  const auto leading = static_cast<std::size_t>(
      std::max_element(tie.direction.begin(), tie.direction.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      tie.direction.begin());
  TieLines result{{}, nodes.front().dofs[leading], tie.force / tie.direction[leading]};
  for (const BoundaryNode<dim>& node : nodes)
    for (unsigned int component = 0; component < dim; ++component) {
      if (node.dofs[component] == result.master) continue;
      const double ratio = tie.direction[component] / tie.direction[leading];
      ConstraintLine line{node.dofs[component], {}, 0.};
      if (ratio != 0.) line.entries.emplace_back(result.master, ratio);
      result.lines.push_back(line);
    }
  return result;
}

template <int dim>
dealii::AffineConstraints<double> hanging_nodes(const dealii::DoFHandler<dim>& dof_handler,
                                                const dealii::IndexSet& ghosts) {
  dealii::AffineConstraints<double> constraints(ghosts);
  dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  return constraints;
}

template <int dim>
std::vector<ConstraintLine> hanging_lines(const dealii::DoFHandler<dim>& dof_handler,
                                          const dealii::AffineConstraints<double>& hanging_nodes,
                                          const Boundary<dim>& boundary) {
  if (dim == 2) return {};
  std::vector<ConstraintLine> own;
  for (const BoundaryNode<dim>& node : boundary.nodes)
    for (const global_dof_index dof : node.dofs)
      if (dof_handler.locally_owned_dofs().is_element(dof) && hanging_nodes.is_constrained(dof))
        own.push_back({dof, *hanging_nodes.get_constraint_entries(dof), 0.});
  return gathered_lines(dof_handler.get_communicator(), own);
}

dealii::AffineConstraints<double> make_constraints(
    const dealii::AffineConstraints<double>& hanging_nodes,
    const std::vector<ConstraintLine>& lines) {
  dealii::AffineConstraints<double> constraints(hanging_nodes);
  for (const ConstraintLine& line : lines) {
    if (constraints.is_constrained(line.dof)) continue;
    constraints.add_line(line.dof);
    constraints.add_entries(line.dof, line.entries);
    constraints.set_inhomogeneity(line.dof, line.inhomogeneity);
  }
  constraints.close();
  return constraints;
}

template std::vector<ConstraintLine> support_lines(const Boundary<2>&,
                                                   const std::vector<Support<2>>&,
                                                   const std::vector<std::string>&);
template TieLines tie_lines(const Boundary<2>&, const RigidTie<2>&,
                            const std::vector<std::string>&);
template dealii::AffineConstraints<double> hanging_nodes(const dealii::DoFHandler<2>&,
                                                         const dealii::IndexSet&);
template std::vector<ConstraintLine> support_lines(const Boundary<3>&,
                                                   const std::vector<Support<3>>&,
                                                   const std::vector<std::string>&);
template TieLines tie_lines(const Boundary<3>&, const RigidTie<3>&,
                            const std::vector<std::string>&);
template dealii::AffineConstraints<double> hanging_nodes(const dealii::DoFHandler<3>&,
                                                         const dealii::IndexSet&);
template std::vector<ConstraintLine> hanging_lines(const dealii::DoFHandler<2>&,
                                                   const dealii::AffineConstraints<double>&,
                                                   const Boundary<2>&);
template std::vector<ConstraintLine> hanging_lines(const dealii::DoFHandler<3>&,
                                                   const dealii::AffineConstraints<double>&,
                                                   const Boundary<3>&);

}  // namespace geneva::fem
