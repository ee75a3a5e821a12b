#include "fem/contact/conditions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace geneva::fem {

namespace {

/// The component to solve a line for; none if all are held.
/// @param direction of the relative displacement that the line constrains
/// @param force_direction of the traction that does it
template <int dim>
int pivot_component(const dealii::Tensor<1, dim>& direction,
                    const dealii::Tensor<1, dim>& force_direction, const SurfaceNode<dim>& node,
                    const std::set<global_dof_index>& held) {
  constexpr double negligible = 1e-12;
  int pivot = -1;
  double maximum = negligible;
  for (unsigned int component = 0; component < dim; ++component) {
    const double share = std::abs(direction[component] * force_direction[component]);
    if (held.count(node.dofs[component]) > 0 || share <= maximum) continue;
    maximum = share;
    pivot = static_cast<int>(component);
  }
  return pivot;
}

/// direction . (D u_j - sum_k M_jk u_k) + constant = 0.
template <int dim>
ConstraintLine contact_line(const ContactInterface<dim>& interface, const ContactRow<dim>& row,
                            const dealii::Tensor<1, dim>& direction, const double constant,
                            const unsigned int pivot) {
  const SurfaceNode<dim>& node = interface.source.nodes[row.node];
  const double diagonal = row.weight * direction[pivot];
  ConstraintLine line{node.dofs[pivot], {}, -constant / diagonal};
  for (unsigned int other = 0; other < dim; ++other)
    if (other != pivot && direction[other] != 0.)
      line.entries.emplace_back(node.dofs[other], -direction[other] / direction[pivot]);
  for (const auto& [target_node, coupling] : row.coupling)
    for (unsigned int component = 0; component < dim; ++component)
      if (direction[component] != 0.)
        line.entries.emplace_back(interface.target.nodes[target_node].dofs[component],
                                  coupling * direction[component] / diagonal);
  return line;
}

template <int dim>
bool is_zero(const Components<dim>& components) {
  return components == Components<dim>{};
}

/// Components along the frame as a vector.
template <int dim>
dealii::Tensor<1, dim> vector_along(const ContactFrame<dim>& frame,
                                    const Components<dim>& components) {
  dealii::Tensor<1, dim> result = components[0] * frame.normal;
  for (std::size_t i = 1; i < dim; ++i) result += components[i] * frame.tangents[i - 1];
  return result;
}

/// Of a surface's nodes.
template <int dim>
using Displacements = std::vector<dealii::Tensor<1, dim>>;

template <int dim>
Displacements<dim> displacements_of(const Surface<dim>& surface, const Vector& displacement) {
  Displacements<dim> result(surface.nodes.size());
  for (std::size_t node = 0; node < result.size(); ++node)
    for (unsigned int component = 0; component < dim; ++component)
      result[node][component] = displacement(surface.nodes[node].dofs[component]);
  return result;
}

/// How far the source's node moved against the target.
template <int dim>
dealii::Tensor<1, dim> relative_displacement(const ContactRow<dim>& row,
                                             const Displacements<dim>& source,
                                             const Displacements<dim>& target) {
  dealii::Tensor<1, dim> relative = row.weight * source[row.node];
  for (const auto& [node, coupling] : row.coupling) relative -= coupling * target[node];
  return relative / row.weight;
}

template <int dim>
Tangential tangential(const ContactFrame<dim>& frame, const dealii::Tensor<1, dim>& vector) {
  Tangential result{};
  for (std::size_t i = 0; i < frame.tangents.size(); ++i) result[i] = vector * frame.tangents[i];
  return result;
}

/// Without displacement and traction, which give the constants of the law's linear equations.
template <int dim>
NodeContact<dim> undisplaced(const ContactInterface<dim>& interface, const std::size_t at) {
  NodeContact<dim> node{interface.status[at], {}, {}, interface.sliding_at(at)};
  for (std::size_t t = 1; t < dim; ++t) node.gap[t] = -interface.slip_before_at(at)[t - 1];
  return node;
}

/// Of the components that no support holds.
template <int dim>
double pressure_of(const SurfaceNode<dim>& node, const ContactRow<dim>& row,
                   const SurfaceForces& forces, const std::set<global_dof_index>& held) {
  double force = 0.;
  double normal_square = 0.;
  for (unsigned int component = 0; component < dim; ++component) {
    if (held.count(node.dofs[component]) > 0) continue;
    force += forces(node.dofs[component]) * row.frame.normal[component];
    normal_square += row.frame.normal[component] * row.frame.normal[component];
  }
  return normal_square > 0. ? force / (row.weight * normal_square) : 0.;
}

template <int dim>
bool is_held(const SurfaceNode<dim>& node, const std::set<global_dof_index>& held) {
  return std::any_of(node.dofs.begin(), node.dofs.end(),
                     [&](const global_dof_index dof) { return held.count(dof) > 0; });
}

/// What the law's equations bind to the pressure.
template <int dim>
Tangential bound_friction(const ContactEquations<dim>& equations, const double pressure) {
  Tangential friction{};
  for (std::size_t t = 1; t < dim; ++t) friction[t - 1] = -equations.by_traction[t][0] * pressure;
  return friction;
}

/// Where a support holds a component of the node, its force cannot be told from friction there: of
/// a node that slips the law tells it, of one that sticks the components that are free.
template <int dim>
Tangential friction_of(const ContactInterface<dim>& interface, const std::size_t at,
                       const double pressure, const SurfaceForces& forces,
                       const std::set<global_dof_index>& held) {
  const ContactRow<dim>& row = interface.rows[at];
  const SurfaceNode<dim>& node = interface.source.nodes[row.node];
  const bool is_at_support = is_held(node, held);
  if (is_at_support && interface.status[at] != NodeStatus::stick)
    return bound_friction<dim>(interface.law->equations(undisplaced(interface, at)), pressure);
  dealii::Tensor<1, dim> traction;
  for (unsigned int component = 0; component < dim; ++component) {
    if (held.count(node.dofs[component]) > 0) continue;
    traction[component] = forces(node.dofs[component]) / row.weight;
    if (is_at_support) traction[component] -= pressure * row.frame.normal[component];
  }
  return tangential(row.frame, traction);
}

/// What one equation of a node's law makes of its relative displacement.
template <int dim>
struct Constraint {
  dealii::Tensor<1, dim> direction;        ///< that it constrains
  dealii::Tensor<1, dim> force_direction;  ///< of the traction that does it
  double constant;                         ///< direction . (D u_j - sum_k M_jk u_k) + constant = 0
};

/// The constraints among a law's equations; where all directions are constrained, along the axes,
/// so that none follows another.
template <int dim>
std::vector<Constraint<dim>> constraints_of(const ContactRow<dim>& row,
                                            const ContactEquations<dim>& equations) {
  std::vector<Constraint<dim>> result;
  for (std::size_t e = 0; e < dim; ++e) {
    const Components<dim>& by_gap = equations.by_gap[e];
    if (is_zero<dim>(by_gap) || !is_zero<dim>(equations.by_traction[e])) continue;
    Components<dim> traction{};  // that the others bind to the one of this constraint
    traction[e] = 1.;
    for (std::size_t other = 0; other < dim; ++other)
      if (other != e) traction[other] -= equations.by_traction[other][e];
    result.push_back({vector_along(row.frame, by_gap), vector_along(row.frame, traction),
                      by_gap[0] * row.initial_gap + row.weight * equations.residual[e]});
  }
  if (result.size() < dim) return result;
  std::vector<Constraint<dim>> along_axes(dim);
  for (unsigned int axis = 0; axis < dim; ++axis) {
    along_axes[axis].direction[axis] = along_axes[axis].force_direction[axis] = 1.;
    along_axes[axis].constant = 0.;
    for (const Constraint<dim>& along_frame : result)
      along_axes[axis].constant += along_frame.constant * along_frame.direction[axis];
  }
  return along_axes;
}

}  // namespace

template <int dim>
ContactLines contact_lines(const ContactInterface<dim>& interface,
                           std::set<global_dof_index>& held) {
  ContactLines lines;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const ContactRow<dim>& row = interface.rows[i];
    const auto equations = interface.law->equations(undisplaced(interface, i));
    for (const Constraint<dim>& constraint : constraints_of(row, equations)) {
      const int pivot = pivot_component(constraint.direction, constraint.force_direction,
                                        interface.source.nodes[row.node], held);
      if (pivot < 0) continue;
      const auto component = static_cast<unsigned int>(pivot);
      lines.displacement.push_back(
          contact_line(interface, row, constraint.direction, constraint.constant, component));
      lines.virtual_displacement.push_back(
          contact_line(interface, row, constraint.force_direction, 0., component));
      lines.are_equal &= constraint.direction == constraint.force_direction;
      held.insert(lines.displacement.back().dof);
    }
  }
  return lines;
}

template <int dim>
ContactState evaluate(const ContactInterface<dim>& interface, const Vector& displacement,
                      const SurfaceForces& forces, const std::set<global_dof_index>& held) {
  const auto source = displacements_of(interface.source, displacement);
  const auto target = displacements_of(interface.target, displacement);
  ContactState state;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const ContactRow<dim>& row = interface.rows[i];
    const SurfaceNode<dim>& node = interface.source.nodes[row.node];
    const dealii::Tensor<1, dim> relative = relative_displacement(row, source, target);
    const bool touches = is_closed(interface.status[i]);
    state.gap.push_back(row.initial_gap / row.weight + row.frame.normal * relative);
    state.approach = std::max(state.approach, std::abs(row.frame.normal * relative));
    state.slip.push_back(tangential(row.frame, relative));
    state.pressure.push_back(touches ? pressure_of(node, row, forces, held) : 0.);
    state.friction.push_back(
        touches ? friction_of(interface, i, state.pressure.back(), forces, held) : Tangential{});
  }
  return state;
}

template ContactLines contact_lines(const ContactInterface<2>&, std::set<global_dof_index>&);
template ContactState evaluate(const ContactInterface<2>&, const Vector&, const SurfaceForces&,
                               const std::set<global_dof_index>&);
template ContactLines contact_lines(const ContactInterface<3>&, std::set<global_dof_index>&);
template ContactState evaluate(const ContactInterface<3>&, const Vector&, const SurfaceForces&,
                               const std::set<global_dof_index>&);

}  // namespace geneva::fem
