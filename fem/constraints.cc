#include "fem/constraints.h"

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace geneva::fem {

unsigned int index_of(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::out_of_range("no surface or body is named '" + name + "'");
  return static_cast<unsigned int>(found - names.begin());
}

namespace {

/// Nodes of one surface, in the order of the boundary's nodes.
std::vector<BoundaryNode> nodes_of(const Boundary& boundary, const unsigned int surface) {
  std::set<unsigned int> indices;
  for (const BoundaryFace& face : boundary.faces)
    if (face.surface == surface) indices.insert(face.nodes.begin(), face.nodes.end());
  std::vector<BoundaryNode> nodes;
  nodes.reserve(indices.size());
  for (const unsigned int index : indices) nodes.push_back(boundary.nodes[index]);
  return nodes;
}

}  // namespace

std::vector<ConstraintLine> support_lines(const Boundary& boundary,
                                          const std::vector<Support>& supports,
                                          const std::vector<std::string>& surfaces) {
  std::map<global_dof_index, double> values;
  for (const Support& support : supports)
    for (const BoundaryNode& node : nodes_of(boundary, index_of(surfaces, support.surface)))
      for (unsigned int component = 0; component < 2; ++component)
        if (const auto value = support.displacement[component]) {
          const auto [entry, is_new] = values.emplace(node.dofs[component], *value);
          if (!is_new && entry->second != *value)
            throw std::invalid_argument(
                "support '" + support.surface +
                "' meets another support that prescribes a different displacement "
                "at their common node");
        }
  std::vector<ConstraintLine> lines;
  lines.reserve(values.size());
  for (const auto& [dof, value] : values) lines.push_back({dof, {}, value});
  return lines;
}

TieLines tie_lines(const Boundary& boundary, const RigidTie& tie,
                   const std::vector<std::string>& surfaces) {
  const auto nodes = nodes_of(boundary, index_of(surfaces, tie.surface));
  const unsigned int leading = std::abs(tie.direction[0]) > std::abs(tie.direction[1]) ? 0 : 1;
  TieLines result{{}, nodes.front().dofs[leading], tie.force / tie.direction[leading]};
  for (const BoundaryNode& node : nodes)
    for (unsigned int component = 0; component < 2; ++component) {
      if (node.dofs[component] == result.master) continue;
      const double ratio = tie.direction[component] / tie.direction[leading];
      ConstraintLine line{node.dofs[component], {}, 0.};
      if (ratio != 0.) line.entries.emplace_back(result.master, ratio);
      result.lines.push_back(line);
    }
  return result;
}

dealii::AffineConstraints<double> make_constraints(const dealii::DoFHandler<2>& dof_handler,
                                                   const dealii::IndexSet& ghosts,
                                                   const std::vector<ConstraintLine>& lines) {
  dealii::AffineConstraints<double> constraints(ghosts);
  dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  for (const ConstraintLine& line : lines) {
    if (constraints.is_constrained(line.dof)) continue;
    constraints.add_line(line.dof);
    constraints.add_entries(line.dof, line.entries);
    constraints.set_inhomogeneity(line.dof, line.inhomogeneity);
  }
  constraints.close();
  return constraints;
}

}  // namespace geneva::fem
