#include "fem/contact/zone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fem/contact/surface_in_space.h"

namespace geneva::fem {

namespace {

/// How far a node's pressure is off the straight line between its neighbours, as a share of the
/// maximum pressure. At the end of a surface, a plane or axis of symmetry, they are equal.
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

/// Mean length of the edges between chosen nodes; 0 without any.
double mean_edge(const Surface<2>& surface, const std::vector<bool>& chosen) {
  double length = 0.;
  unsigned int count = 0;
  for (const SurfaceFace<2>& face : surface.faces) {
    const auto [begin, end] = face.nodes;
    if (!chosen[begin] || !chosen[end]) continue;
    length += surface.nodes[begin].position.distance(surface.nodes[end].position);
    ++count;
  }
  return count > 0 ? length / count : 0.;
}

}  // namespace

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
  return nodes_of_rows(interface, zone_rows(interface));
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
  std::vector<bool> open = nodes_of_rows(interface, closed(interface.status));
  open.flip();
  unsigned int depth = 0;
  for (const unsigned int steps : steps_from(interface.source, open))
    depth = std::max(depth, steps);
  return depth == 0 ? 0 : 2 * depth - 1;
}

double ratio_of_edges(const ContactInterface<2>& interface) {
  const std::vector<bool> is_closed_row = closed(interface.status);
  std::vector<bool> opposite(interface.target.nodes.size(), false);
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (is_closed_row[i])
      for (const auto& [node, coupling] : interface.rows[i].coupling) opposite[node] = true;
  const double source = mean_edge(interface.source, nodes_of_rows(interface, is_closed_row));
  const double target = mean_edge(interface.target, opposite);
  return source > 0. && target > 0. ? target / source : 1.;
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

template std::vector<bool> zone_rows(const ContactInterface<2>&);
template std::vector<bool> zone_rows(const ContactInterface<3>&);
template std::vector<bool> zone_nodes(const ContactInterface<2>&);
template std::vector<bool> zone_nodes(const ContactInterface<3>&);

}  // namespace geneva::fem
