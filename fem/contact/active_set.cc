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

/// The component to solve a row for; none if all are held.
template <int dim>
int pivot_component(const ContactRow<dim>& row, const SurfaceNode<dim>& node,
                    const std::set<global_dof_index>& held) {
  int pivot = -1;
  for (unsigned int component = 0; component < dim; ++component) {
    const double share = std::abs(row.frame.normal[component]);
    if (held.count(node.dofs[component]) == 0 && share > 1e-6 &&
        (pivot < 0 || share > std::abs(row.frame.normal[static_cast<unsigned int>(pivot)])))
      pivot = static_cast<int>(component);
  }
  return pivot;
}

template <int dim>
ConstraintLine contact_line(const ContactInterface<dim>& interface, const ContactRow<dim>& row,
                            const unsigned int pivot) {
  const SurfaceNode<dim>& node = interface.source.nodes[row.node];
  const double diagonal = row.weight * row.frame.normal[pivot];
  ConstraintLine line{node.dofs[pivot], {}, -row.initial_gap / diagonal};
  for (unsigned int other = 0; other < dim; ++other)
    if (other != pivot && row.frame.normal[other] != 0.)
      line.entries.emplace_back(node.dofs[other],
                                -row.frame.normal[other] / row.frame.normal[pivot]);
  for (const auto& [target_node, coupling] : row.coupling)
    for (unsigned int component = 0; component < dim; ++component)
      if (row.frame.normal[component] != 0.)
        line.entries.emplace_back(interface.target.nodes[target_node].dofs[component],
                                  coupling * row.frame.normal[component] / diagonal);
  return line;
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

template <int dim>
double gap_of(const ContactRow<dim>& row, const Displacements<dim>& source,
              const Displacements<dim>& target) {
  dealii::Tensor<1, dim> relative = row.weight * source[row.node];
  for (const auto& [node, coupling] : row.coupling) relative -= coupling * target[node];
  return (row.initial_gap + row.frame.normal * relative) / row.weight;
}

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

}  // namespace

template <int dim>
std::vector<bool> first_touch(const ContactInterface<dim>& interface) {
  const bool meets_approach =
      std::any_of(interface.rows.begin(), interface.rows.end(), [&](const ContactRow<dim>& row) {
        return closing_rate(row, interface.approach) > least_closing_rate;
      });
  const dealii::Tensor<1, dim> approach =
      meets_approach ? interface.approach : dealii::Tensor<1, dim>();
  double smallest = std::numeric_limits<double>::max();
  for (const ContactRow<dim>& row : interface.rows)
    smallest = std::min(smallest, way_to_touch(row, approach));
  std::vector<bool> active;
  active.reserve(interface.rows.size());
  for (const ContactRow<dim>& row : interface.rows)
    active.push_back(way_to_touch(row, approach) <= smallest + 1e-9 * interface.source.length);
  return active;
}

std::vector<bool> inherited(const ContactInterface<2>& interface,
                            const std::vector<ContactInterval>& intervals, const double length) {
  const double slack = 1e-9 * interface.source.length;
  std::vector<bool> active;
  active.reserve(interface.rows.size());
  for (const ContactRow<2>& row : interface.rows) {
    const double at = interface.source.nodes[row.node].arc_length;
    active.push_back(
        std::any_of(intervals.begin(), intervals.end(), [&](const ContactInterval& interval) {
          return at >= interval.begin / length - slack && at <= interval.end / length + slack;
        }));
  }
  if (std::none_of(active.begin(), active.end(), [](const bool is_active) { return is_active; }))
    return first_touch(interface);
  return active;
}

std::vector<bool> inherited(const ContactInterface<3>& interface,
                            const std::vector<ContactNode<3>>& nodes, const double length) {
  std::vector<dealii::Point<3>> places;
  places.reserve(nodes.size());
  for (const ContactNode<3>& node : nodes)
    places.emplace_back(node.position[0] / length, node.position[1] / length,
                        node.position[2] / length);
  const auto tree = dealii::pack_rtree_of_indices(places);
  std::vector<bool> active;
  active.reserve(interface.rows.size());
  for (const ContactRow<3>& row : interface.rows) {
    const dealii::Point<3>& place = interface.source.nodes[row.node].position;
    std::vector<std::size_t> nearest;
    tree.query(boost::geometry::index::nearest(place, equally_near), std::back_inserter(nearest));
    double distance = std::numeric_limits<double>::max();
    for (const std::size_t node : nearest)
      distance = std::min(distance, place.distance(places[node]));
    active.push_back(!nearest.empty() &&
                     std::all_of(nearest.begin(), nearest.end(), [&](const std::size_t node) {
                       return nodes[node].active ||
                              place.distance(places[node]) > (1. + 1e-6) * distance;
                     }));
  }
  if (std::none_of(active.begin(), active.end(), [](const bool is_active) { return is_active; }))
    return first_touch(interface);
  return active;
}

template <int dim>
std::vector<dealii::Point<dim>> active_places(const ContactInterface<dim>& interface) {
  std::vector<dealii::Point<dim>> places;
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (interface.active[i])
      places.push_back(interface.source.nodes[interface.rows[i].node].position);
  return places;
}

template <int dim>
std::vector<bool> active_at(const ContactInterface<dim>& interface,
                            const std::vector<dealii::Point<dim>>& places) {
  const double same = 1e-9 * interface.source.length;
  const auto tree = dealii::pack_rtree_of_indices(places);
  std::vector<bool> active;
  active.reserve(interface.rows.size());
  for (const ContactRow<dim>& row : interface.rows) {
    const dealii::Point<dim>& place = interface.source.nodes[row.node].position;
    std::vector<std::size_t> nearest;
    tree.query(boost::geometry::index::nearest(place, 1), std::back_inserter(nearest));
    active.push_back(!nearest.empty() && place.distance(places[nearest.front()]) < same);
  }
  if (std::count(active.begin(), active.end(), true) != static_cast<std::ptrdiff_t>(places.size()))
    throw base::InputError("the checkpoint does not fit this case: its contact has other nodes");
  return active;
}

template <int dim>
std::vector<bool> active_nodes(const ContactInterface<dim>& interface) {
  return nodes_of(interface, interface.active);
}

template <int dim>
std::vector<bool> zone_rows(const ContactInterface<dim>& interface) {
  std::vector<bool> in_zone = interface.active;
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
    if (!interface.active[i] || bend_of_pressure(interface, state, i) > tolerance)
      for (std::size_t j = i - std::min(i, reach); j < std::min(count, i + reach + 1); ++j)
        is_near_rough[j] = true;
  ArcIntervals intervals;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_near_rough[i]) continue;
    const double at = interface.source.nodes[interface.rows[i].node].arc_length;
    if (i == 0 || is_near_rough[i - 1]) intervals.emplace_back(at, at);
    intervals.back().second = at;
  }
  const auto n_active = std::count(interface.active.begin(), interface.active.end(), true);
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
      std::count(interface.active.begin(), interface.active.end(), true));
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
    if (!interface.active[i]) continue;
    const ContactRow<dim>& row = interface.rows[i];
    const int pivot = pivot_component(row, interface.source.nodes[row.node], held);
    if (pivot < 0) continue;
    lines.push_back(contact_line(interface, row, static_cast<unsigned int>(pivot)));
  }
  for (const ConstraintLine& line : lines) held.insert(line.dof);
  return lines;
}

template <int dim>
ContactState evaluate(const ContactInterface<dim>& interface,
                      const dealii::TrilinosWrappers::MPI::Vector& displacement,
                      const SurfaceForces& forces, const std::set<global_dof_index>& held) {
  const auto source = displacements_of(interface.source, displacement);
  const auto target = displacements_of(interface.target, displacement);
  ContactState state;
  for (const ContactRow<dim>& row : interface.rows) {
    state.gap.push_back(gap_of(row, source, target));
    state.approach = std::max(state.approach, std::abs(state.gap.back() - initial_gap(row)));
    state.pressure.push_back(pressure_of(interface.source.nodes[row.node], row, forces, held));
  }
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (!interface.active[i]) state.pressure[i] = 0.;
  return state;
}

template <int dim>
std::vector<bool> updated(const ContactInterface<dim>& interface, const ContactState& state) {
  double greatest_pressure = 0.;
  for (const double pressure : state.pressure)
    greatest_pressure = std::max(greatest_pressure, std::abs(pressure));
  std::vector<bool> active;
  active.reserve(interface.rows.size());
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    active.push_back(interface.active[i] ? state.pressure[i] >= -round_off * greatest_pressure
                                         : state.gap[i] < -round_off * state.approach);
  return active;
}

template std::vector<bool> first_touch(const ContactInterface<2>&);
template std::vector<ConstraintLine> contact_lines(const ContactInterface<2>&,
                                                   std::set<global_dof_index>&);
template ContactState evaluate(const ContactInterface<2>&,
                               const dealii::TrilinosWrappers::MPI::Vector&, const SurfaceForces&,
                               const std::set<global_dof_index>&);
template std::vector<bool> updated(const ContactInterface<2>&, const ContactState&);
template std::vector<bool> first_touch(const ContactInterface<3>&);
template std::vector<ConstraintLine> contact_lines(const ContactInterface<3>&,
                                                   std::set<global_dof_index>&);
template ContactState evaluate(const ContactInterface<3>&,
                               const dealii::TrilinosWrappers::MPI::Vector&, const SurfaceForces&,
                               const std::set<global_dof_index>&);
template std::vector<bool> updated(const ContactInterface<3>&, const ContactState&);
template std::vector<dealii::Point<2>> active_places(const ContactInterface<2>&);
template std::vector<dealii::Point<3>> active_places(const ContactInterface<3>&);
template std::vector<bool> active_at(const ContactInterface<2>&,
                                     const std::vector<dealii::Point<2>>&);
template std::vector<bool> active_at(const ContactInterface<3>&,
                                     const std::vector<dealii::Point<3>>&);
template std::vector<bool> active_nodes(const ContactInterface<2>&);
template std::vector<bool> active_nodes(const ContactInterface<3>&);
template std::vector<bool> zone_rows(const ContactInterface<2>&);
template std::vector<bool> zone_rows(const ContactInterface<3>&);
template std::vector<bool> zone_nodes(const ContactInterface<2>&);
template std::vector<bool> zone_nodes(const ContactInterface<3>&);

}  // namespace geneva::fem
