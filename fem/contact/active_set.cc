#include "fem/contact/active_set.h"

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/errors.h"
#include "fem/contact/surface_in_space.h"

namespace geneva::fem {

namespace {

/// Pressures below this share of the greatest one, and overlaps below this share of the approach,
/// are round-off, not a reason to change the active set.
constexpr double round_off = 1e-9;
/// A new node in the middle of a face is as near to all four corners: round-off must not choose.
constexpr unsigned int equally_near = 4;

template <int dim>
double initial_gap(const ContactRow<dim>& row) {
  return row.initial_gap / row.weight;
}

/// Rows that close more slowly than this share of the approach do not stop it.
constexpr double least_closing_rate = 0.2;

template <int dim>
double closing_rate(const ContactRow<dim>& row, const dealii::Tensor<1, dim>& approach) {
  return -(row.frame.normal * approach);
}

/// How far the source has to move along the approach until a row touches, without end where it
/// leads past; the gap itself where the approach is not known or the bodies overlap.
template <int dim>
double way_to_touch(const ContactRow<dim>& row, const dealii::Tensor<1, dim>& approach) {
  const double gap = initial_gap(row);
  if (approach.norm() == 0.) return gap;
  const double rate = closing_rate(row, approach);
  if (rate <= least_closing_rate) return std::numeric_limits<double>::max();
  return gap > 0. ? gap / rate : gap;
}

/// The component to solve a line for; none if all are held.
/// @param direction of the relative displacement that the line constrains
template <int dim>
int pivot_component(const dealii::Tensor<1, dim>& direction, const SurfaceNode<dim>& node,
                    const std::set<global_dof_index>& held) {
  int pivot = -1;
  for (unsigned int component = 0; component < dim; ++component) {
    const double share = std::abs(direction[component]);
    if (held.count(node.dofs[component]) == 0 && share > 1e-6 &&
        (pivot < 0 || share > std::abs(direction[static_cast<unsigned int>(pivot)])))
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
Displacements<dim> displacements_of(const Surface<dim>& surface,
                                    const dealii::TrilinosWrappers::MPI::Vector& displacement) {
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

/// None where a support holds a component, whose force it takes.
template <int dim>
Tangential friction_of(const SurfaceNode<dim>& node, const ContactRow<dim>& row,
                       const SurfaceForces& forces, const std::set<global_dof_index>& held) {
  dealii::Tensor<1, dim> force;
  for (unsigned int component = 0; component < dim; ++component) {
    if (held.count(node.dofs[component]) > 0) return {};
    force[component] = forces(node.dofs[component]);
  }
  return tangential(row.frame, force / row.weight);
}

template <int dim>
NodeContact<dim> node_contact(const NodeStatus status, const ContactState& state,
                              const std::size_t row) {
  NodeContact<dim> node{status, {state.gap[row]}, {state.pressure[row]}};
  for (std::size_t i = 1; i < dim; ++i) {
    node.gap[i] = state.slip[row][i - 1];
    node.traction[i] = state.friction[row][i - 1];
  }
  return node;
}

/// Which nodes of the source belong to the chosen rows.
template <int dim>
std::vector<bool> nodes_of(const ContactInterface<dim>& interface, const std::vector<bool>& rows) {
  std::vector<bool> chosen(interface.source.nodes.size(), false);
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (rows[i]) chosen[interface.rows[i].node] = true;
  return chosen;
}

/// How far a node's pressure is off the straight line between its neighbours, as a share of the
/// greatest pressure. At the end of a surface, a plane or axis of symmetry, they are equal.
double bend_of_pressure(const ContactInterface<2>& interface, const ContactState& state,
                        const std::size_t row) {
  const auto at = [&](const std::size_t i) {
    return interface.source.nodes[interface.rows[i].node].arc_length;
  };
  const std::size_t last = interface.rows.size() - 1;
  const std::size_t before = row == 0 ? std::min<std::size_t>(1, last) : row - 1;
  const std::size_t after = row == last ? last - std::min<std::size_t>(1, last) : row + 1;
  const double share = before == after ? 0.5 : (at(row) - at(before)) / (at(after) - at(before));
  const double straight =
      state.pressure[before] + share * (state.pressure[after] - state.pressure[before]);
  return std::abs(state.pressure[row] - straight) /
         *std::max_element(state.pressure.begin(), state.pressure.end());
}

NodeStatus touching(const bool touches) { return touches ? NodeStatus::slip : NodeStatus::open; }

}  // namespace

template <int dim>
std::vector<NodeStatus> first_touch(const ContactInterface<dim>& interface) {
  const bool meets_approach =
      std::any_of(interface.rows.begin(), interface.rows.end(), [&](const ContactRow<dim>& row) {
        return closing_rate(row, interface.approach) > least_closing_rate;
      });
  const dealii::Tensor<1, dim> approach =
      meets_approach ? interface.approach : dealii::Tensor<1, dim>();
  double smallest = std::numeric_limits<double>::max();
  for (const ContactRow<dim>& row : interface.rows)
    smallest = std::min(smallest, way_to_touch(row, approach));
  std::vector<NodeStatus> status;
  status.reserve(interface.rows.size());
  for (const ContactRow<dim>& row : interface.rows)
    status.push_back(
        touching(way_to_touch(row, approach) <= smallest + 1e-9 * interface.source.length));
  return status;
}

std::vector<NodeStatus> inherited(const ContactInterface<2>& interface,
                                  const std::vector<ContactInterval>& intervals,
                                  const double length) {
  const double slack = 1e-9 * interface.source.length;
  std::vector<NodeStatus> status;
  status.reserve(interface.rows.size());
  for (const ContactRow<2>& row : interface.rows) {
    const double at = interface.source.nodes[row.node].arc_length;
    status.push_back(touching(
        std::any_of(intervals.begin(), intervals.end(), [&](const ContactInterval& interval) {
          return at >= interval.begin / length - slack && at <= interval.end / length + slack;
        })));
  }
  return std::none_of(status.begin(), status.end(), is_closed) ? first_touch(interface) : status;
}

std::vector<NodeStatus> inherited(const ContactInterface<3>& interface,
                                  const std::vector<ContactNode<3>>& nodes, const double length) {
  std::vector<dealii::Point<3>> places;
  places.reserve(nodes.size());
  for (const ContactNode<3>& node : nodes)
    places.emplace_back(node.position[0] / length, node.position[1] / length,
                        node.position[2] / length);
  const auto tree = dealii::pack_rtree_of_indices(places);
  std::vector<NodeStatus> status;
  status.reserve(interface.rows.size());
  for (const ContactRow<3>& row : interface.rows) {
    const dealii::Point<3>& place = interface.source.nodes[row.node].position;
    std::vector<std::size_t> nearest;
    tree.query(boost::geometry::index::nearest(place, equally_near), std::back_inserter(nearest));
    double distance = std::numeric_limits<double>::max();
    for (const std::size_t node : nearest)
      distance = std::min(distance, place.distance(places[node]));
    status.push_back(
        touching(!nearest.empty() &&
                 std::all_of(nearest.begin(), nearest.end(), [&](const std::size_t node) {
                   return is_closed(nodes[node].status) ||
                          place.distance(places[node]) > (1. + 1e-6) * distance;
                 })));
  }
  return std::none_of(status.begin(), status.end(), is_closed) ? first_touch(interface) : status;
}

template <int dim>
std::vector<dealii::Point<dim>> active_places(const ContactInterface<dim>& interface) {
  std::vector<dealii::Point<dim>> places;
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (is_closed(interface.status[i]))
      places.push_back(interface.source.nodes[interface.rows[i].node].position);
  return places;
}

template <int dim>
std::vector<NodeStatus> active_at(const ContactInterface<dim>& interface,
                                  const std::vector<dealii::Point<dim>>& places) {
  const double same = 1e-9 * interface.source.length;
  const auto tree = dealii::pack_rtree_of_indices(places);
  std::vector<NodeStatus> status;
  status.reserve(interface.rows.size());
  for (const ContactRow<dim>& row : interface.rows) {
    const dealii::Point<dim>& place = interface.source.nodes[row.node].position;
    std::vector<std::size_t> nearest;
    tree.query(boost::geometry::index::nearest(place, 1), std::back_inserter(nearest));
    status.push_back(touching(!nearest.empty() && place.distance(places[nearest.front()]) < same));
  }
  if (std::count_if(status.begin(), status.end(), is_closed) !=
      static_cast<std::ptrdiff_t>(places.size()))
    throw base::InputError("the checkpoint does not fit this case: its contact has other nodes");
  return status;
}

template <int dim>
std::vector<bool> active_nodes(const ContactInterface<dim>& interface) {
  return nodes_of(interface, closed(interface.status));
}

template <int dim>
std::vector<bool> zone_rows(const ContactInterface<dim>& interface) {
  std::vector<bool> in_zone = closed(interface.status);
  for (std::size_t i = 0; i < in_zone.size(); ++i) {
    const double at = interface.source.nodes[interface.rows[i].node].arc_length;
    for (const auto& [from, to] : interface.smooth)
      if (at >= from && at <= to) in_zone[i] = false;
  }
  return in_zone;
}

template <int dim>
std::vector<bool> zone_nodes(const ContactInterface<dim>& interface) {
  return nodes_of(interface, zone_rows(interface));
}

ArcIntervals smooth_intervals(const ContactInterface<2>& interface, const ContactState& state,
                              const double tolerance) {
  constexpr std::size_t reach = 8;  // edges between a rough node and the first smooth one
  const std::size_t count = interface.rows.size();
  std::vector<bool> is_near_rough(count, false);
  for (std::size_t i = 0; i < count; ++i)
    if (!is_closed(interface.status[i]) || bend_of_pressure(interface, state, i) > tolerance)
      for (std::size_t j = i - std::min(i, reach); j < std::min(count, i + reach + 1); ++j)
        is_near_rough[j] = true;
  ArcIntervals intervals;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_near_rough[i]) continue;
    const double at = interface.source.nodes[interface.rows[i].node].arc_length;
    if (i == 0 || is_near_rough[i - 1]) intervals.emplace_back(at, at);
    intervals.back().second = at;
  }
  const auto n_active = std::count_if(interface.status.begin(), interface.status.end(), is_closed);
  const auto n_smooth = std::count(is_near_rough.begin(), is_near_rough.end(), false);
  const bool pays = n_smooth < n_active && 4 * n_smooth > 3 * n_active;
  return pays ? intervals : ArcIntervals();
}

bool peaks_at_corner(const ContactInterface<2>& interface, const ContactState& state) {
  const std::size_t count = interface.rows.size();
  const std::size_t reach = std::min<std::size_t>(4, count);
  const auto peak = static_cast<std::size_t>(
      std::max_element(state.pressure.begin(), state.pressure.end()) - state.pressure.begin());
  const std::vector<bool> of_source = corners(interface.source);
  const std::vector<bool> of_target = corners(interface.target);
  // on a closed surface the rows go round
  for (std::size_t i = count + peak - reach; i <= count + peak + reach; ++i) {
    if (!interface.source.closed && (i < count || i >= 2 * count)) continue;
    const ContactRow<2>& row = interface.rows[i % count];
    if (of_source[row.node]) return true;
    for (const auto& [node, coupling] : row.coupling)
      if (of_target[node]) return true;
  }
  return false;
}

unsigned int nodes_across(const ContactInterface<2>& interface) {
  return static_cast<unsigned int>(
      std::count_if(interface.status.begin(), interface.status.end(), is_closed));
}

unsigned int nodes_across(const ContactInterface<3>& interface) {
  std::vector<bool> open = active_nodes(interface);
  open.flip();
  unsigned int depth = 0;
  for (const unsigned int steps : steps_from(interface.source, open))
    depth = std::max(depth, steps);
  return depth == 0 ? 0 : 2 * depth - 1;
}

ArcIntervals zone_intervals(const ContactInterface<2>& interface) {
  const std::vector<bool> in_zone = zone_nodes(interface);
  ArcIntervals intervals;
  bool open = false;
  for (std::size_t i = 0; i < in_zone.size(); ++i) {
    const double at = interface.source.nodes[i].arc_length;
    if (in_zone[i] && open) intervals.back().second = at;
    if (in_zone[i] && !open) intervals.emplace_back(at, at);
    open = in_zone[i];
  }
  return intervals;
}

template <int dim>
std::vector<ConstraintLine> contact_lines(const ContactInterface<dim>& interface,
                                          std::set<global_dof_index>& held) {
  std::vector<ConstraintLine> lines;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const ContactRow<dim>& row = interface.rows[i];
    // the equations are linear: it does not matter where they are taken
    const auto equations = interface.law->equations({interface.status[i], {}, {}});
    for (std::size_t e = 0; e < dim; ++e) {
      const Components<dim>& by_gap = equations.by_gap[e];
      if (is_zero<dim>(by_gap) || !is_zero<dim>(equations.by_traction[e])) continue;
      const dealii::Tensor<1, dim> direction = vector_along(row.frame, by_gap);
      const int pivot = pivot_component(direction, interface.source.nodes[row.node], held);
      if (pivot < 0) continue;
      const double constant = by_gap[0] * row.initial_gap + row.weight * equations.residual[e];
      lines.push_back(
          contact_line(interface, row, direction, constant, static_cast<unsigned int>(pivot)));
      held.insert(lines.back().dof);
    }
  }
  return lines;
}

template <int dim>
ContactState evaluate(const ContactInterface<dim>& interface,
                      const dealii::TrilinosWrappers::MPI::Vector& displacement,
                      const SurfaceForces& forces, const std::set<global_dof_index>& held) {
  const auto source = displacements_of(interface.source, displacement);
  const auto target = displacements_of(interface.target, displacement);
  ContactState state;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const ContactRow<dim>& row = interface.rows[i];
    const SurfaceNode<dim>& node = interface.source.nodes[row.node];
    const dealii::Tensor<1, dim> relative = relative_displacement(row, source, target);
    const bool touches = is_closed(interface.status[i]);
    state.gap.push_back(initial_gap(row) + row.frame.normal * relative);
    state.approach = std::max(state.approach, std::abs(row.frame.normal * relative));
    state.slip.push_back(tangential(row.frame, relative));
    state.pressure.push_back(touches ? pressure_of(node, row, forces, held) : 0.);
    state.friction.push_back(touches ? friction_of(node, row, forces, held) : Tangential{});
  }
  return state;
}

template <int dim>
std::vector<NodeStatus> updated(const ContactInterface<dim>& interface, const ContactState& state) {
  ContactRounding rounding{round_off * state.approach, 0.};
  for (const double pressure : state.pressure)
    rounding.pressure = std::max(rounding.pressure, round_off * std::abs(pressure));
  std::vector<NodeStatus> status;
  status.reserve(interface.rows.size());
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    status.push_back(
        interface.law->next_status(node_contact<dim>(interface.status[i], state, i), rounding));
  return status;
}

template std::vector<NodeStatus> first_touch(const ContactInterface<2>&);
template std::vector<ConstraintLine> contact_lines(const ContactInterface<2>&,
                                                   std::set<global_dof_index>&);
template ContactState evaluate(const ContactInterface<2>&,
                               const dealii::TrilinosWrappers::MPI::Vector&, const SurfaceForces&,
                               const std::set<global_dof_index>&);
template std::vector<NodeStatus> updated(const ContactInterface<2>&, const ContactState&);
template std::vector<NodeStatus> first_touch(const ContactInterface<3>&);
template std::vector<ConstraintLine> contact_lines(const ContactInterface<3>&,
                                                   std::set<global_dof_index>&);
template ContactState evaluate(const ContactInterface<3>&,
                               const dealii::TrilinosWrappers::MPI::Vector&, const SurfaceForces&,
                               const std::set<global_dof_index>&);
template std::vector<NodeStatus> updated(const ContactInterface<3>&, const ContactState&);
template std::vector<dealii::Point<2>> active_places(const ContactInterface<2>&);
template std::vector<dealii::Point<3>> active_places(const ContactInterface<3>&);
template std::vector<NodeStatus> active_at(const ContactInterface<2>&,
                                           const std::vector<dealii::Point<2>>&);
template std::vector<NodeStatus> active_at(const ContactInterface<3>&,
                                           const std::vector<dealii::Point<3>>&);
template std::vector<bool> active_nodes(const ContactInterface<2>&);
template std::vector<bool> active_nodes(const ContactInterface<3>&);
template std::vector<bool> zone_rows(const ContactInterface<2>&);
template std::vector<bool> zone_rows(const ContactInterface<3>&);
template std::vector<bool> zone_nodes(const ContactInterface<2>&);
template std::vector<bool> zone_nodes(const ContactInterface<3>&);

}  // namespace geneva::fem
