#include "fem/contact/active_set.h"

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "base/errors.h"

namespace geneva::fem {

namespace {

/// Pressures below this share of the maximum one, and overlaps below this share of the approach,
/// are round-off, not a reason to change the active set.
constexpr double round_off = 1e-9;
/// A new node in the middle of a face is as near to all four corners: round-off must not choose.
constexpr unsigned int equally_near = 4;

template <int dim>
double initial_gap(const ContactRow<dim>& row) {
  return row.initial_gap / row.weight;
}

/// Rows that close more slowly than this share of the approach do not stop it.
constexpr double minimum_closing_rate = 0.2;

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
  if (rate <= minimum_closing_rate) return std::numeric_limits<double>::max();
  return gap > 0. ? gap / rate : gap;
}

template <int dim>
NodeContact<dim> node_contact(const ContactInterface<dim>& interface, const ContactState& state,
                              const std::size_t row) {
  NodeContact<dim> node{
      interface.status[row], {state.gap[row]}, {state.pressure[row]}, interface.sliding_at(row)};
  for (std::size_t i = 1; i < dim; ++i) {
    node.gap[i] = state.slip[row][i - 1] - interface.slip_before_at(row)[i - 1];
    node.traction[i] = state.friction[row][i - 1];
  }
  return node;
}

template <int dim>
NodeStatus status_of(const ContactInterface<dim>& interface, const bool touches) {
  return touches ? interface.law->touching() : NodeStatus::open;
}

}  // namespace

template <int dim>
bool is_pulled_apart(const ContactInterface<dim>& interface) {
  constexpr double near = 0.1;
  const auto nearest = std::min_element(
      interface.rows.begin(), interface.rows.end(),
      [](const auto& a, const auto& b) { return initial_gap(a) < initial_gap(b); });
  const auto closes = [&](const ContactRow<dim>& row) {
    return initial_gap(row) < near * interface.source.length &&
           closing_rate(row, interface.approach) > minimum_closing_rate;
  };
  return nearest != interface.rows.end() &&
         closing_rate(*nearest, interface.approach) < -minimum_closing_rate &&
         std::none_of(interface.rows.begin(), interface.rows.end(), closes);
}

template <int dim>
std::vector<NodeStatus> first_touch(const ContactInterface<dim>& interface) {
  const bool meets_approach =
      std::any_of(interface.rows.begin(), interface.rows.end(), [&](const ContactRow<dim>& row) {
        return closing_rate(row, interface.approach) > minimum_closing_rate;
      });
  const dealii::Tensor<1, dim> approach =
      meets_approach ? interface.approach : dealii::Tensor<1, dim>();
  double smallest = std::numeric_limits<double>::max();
  for (const ContactRow<dim>& row : interface.rows)
    smallest = std::min(smallest, way_to_touch(row, approach));
  std::vector<NodeStatus> status;
  status.reserve(interface.rows.size());
  for (const ContactRow<dim>& row : interface.rows)
    status.push_back(status_of(
        interface, way_to_touch(row, approach) <= smallest + 1e-9 * interface.source.length));
  return status;
}

template <int dim>
std::optional<std::size_t> first_ahead(const ContactInterface<dim>& interface,
                                       const ContactState& state,
                                       const dealii::Tensor<1, dim>& direction) {
  std::optional<std::size_t> first;
  double shortest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const double rate = closing_rate(interface.rows[i], direction);
    if (is_closed(interface.status[i]) || rate <= minimum_closing_rate) continue;
    if (state.gap[i] / rate >= shortest) continue;
    shortest = state.gap[i] / rate;
    first = i;
  }
  return first;
}

std::vector<NodeStatus> inherited(const ContactInterface<2>& interface,
                                  const std::vector<ContactInterval>& intervals,
                                  const double length) {
  const double slack = 1e-9 * interface.source.length;
  std::vector<NodeStatus> status;
  status.reserve(interface.rows.size());
  for (const ContactRow<2>& row : interface.rows) {
    const double at = interface.source.nodes[row.node].arc_length;
    status.push_back(status_of(
        interface,
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
    status.push_back(status_of(
        interface, !nearest.empty() &&
                       std::all_of(nearest.begin(), nearest.end(), [&](const std::size_t node) {
                         return is_closed(nodes[node].status) ||
                                place.distance(places[node]) > (1. + 1e-6) * distance;
                       })));
  }
  return std::none_of(status.begin(), status.end(), is_closed) ? first_touch(interface) : status;
}

template <int dim>
std::vector<NodeMotion<dim>> motions_of(const ContactInterface<dim>& interface) {
  std::vector<NodeMotion<dim>> motions;
  motions.reserve(interface.rows.size());
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const ContactRow<dim>& row = interface.rows[i];
    NodeMotion<dim> motion{interface.source.nodes[row.node].position, interface.status[i], {}};
    for (std::size_t t = 1; t < dim; ++t)
      motion.sliding += interface.sliding_at(i)[t] * row.frame.tangents[t - 1];
    motions.push_back(motion);
  }
  return motions;
}

template <int dim>
void recall(ContactInterface<dim>& interface, const std::vector<NodeMotion<dim>>& motions) {
  if (!interface.may_stick()) return;
  std::vector<dealii::Point<dim>> places;
  std::vector<std::size_t> closed_ones;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (!is_closed(motions[i].status)) continue;
    places.push_back(motions[i].place);
    closed_ones.push_back(i);
  }
  if (places.empty()) return;
  interface.sliding.resize(interface.rows.size());
  const auto tree = dealii::pack_rtree_of_indices(places);
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    if (!is_closed(interface.status[i])) continue;
    const ContactRow<dim>& row = interface.rows[i];
    std::vector<std::size_t> nearest;
    tree.query(boost::geometry::index::nearest(interface.source.nodes[row.node].position, 1),
               std::back_inserter(nearest));
    const NodeMotion<dim>& motion = motions[closed_ones[nearest.front()]];
    interface.status[i] = motion.status;
    for (std::size_t t = 1; t < dim; ++t)
      interface.sliding[i][t] = motion.sliding * row.frame.tangents[t - 1];
  }
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
    status.push_back(
        status_of(interface, !nearest.empty() && place.distance(places[nearest.front()]) < same));
  }
  if (std::count_if(status.begin(), status.end(), is_closed) !=
      static_cast<std::ptrdiff_t>(places.size()))
    throw base::InputError("the checkpoint does not fit this case: its contact has other nodes");
  return status;
}

template <int dim>
std::vector<bool> active_nodes(const ContactInterface<dim>& interface) {
  return nodes_of_rows(interface, closed(interface.status));
}

template <int dim>
std::vector<NodeStatus> updated(const ContactInterface<dim>& interface, const ContactState& state) {
  ContactRounding rounding{round_off * state.approach, 0.};
  for (const double pressure : state.pressure)
    rounding.pressure = std::max(rounding.pressure, round_off * std::abs(pressure));
  std::vector<NodeStatus> status;
  status.reserve(interface.rows.size());
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    status.push_back(interface.law->next_status(node_contact(interface, state, i), rounding));
  return status;
}

template <int dim>
std::vector<Components<dim>> next_sliding(const ContactInterface<dim>& interface,
                                          const ContactState& state) {
  std::vector<Components<dim>> sliding;
  sliding.reserve(interface.rows.size());
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    sliding.push_back(interface.law->next_sliding(node_contact(interface, state, i)));
  return sliding;
}

template bool is_pulled_apart(const ContactInterface<2>&);
template bool is_pulled_apart(const ContactInterface<3>&);
template std::optional<std::size_t> first_ahead(const ContactInterface<2>&, const ContactState&,
                                                const dealii::Tensor<1, 2>&);
template std::optional<std::size_t> first_ahead(const ContactInterface<3>&, const ContactState&,
                                                const dealii::Tensor<1, 3>&);
template std::vector<NodeStatus> first_touch(const ContactInterface<2>&);
template std::vector<NodeStatus> updated(const ContactInterface<2>&, const ContactState&);
template std::vector<NodeMotion<2>> motions_of(const ContactInterface<2>&);
template std::vector<NodeMotion<3>> motions_of(const ContactInterface<3>&);
template void recall(ContactInterface<2>&, const std::vector<NodeMotion<2>>&);
template void recall(ContactInterface<3>&, const std::vector<NodeMotion<3>>&);
template std::vector<Components<2>> next_sliding(const ContactInterface<2>&, const ContactState&);
template std::vector<Components<3>> next_sliding(const ContactInterface<3>&, const ContactState&);
template std::vector<NodeStatus> first_touch(const ContactInterface<3>&);
template std::vector<NodeStatus> updated(const ContactInterface<3>&, const ContactState&);
template std::vector<dealii::Point<2>> active_places(const ContactInterface<2>&);
template std::vector<dealii::Point<3>> active_places(const ContactInterface<3>&);
template std::vector<NodeStatus> active_at(const ContactInterface<2>&,
                                           const std::vector<dealii::Point<2>>&);
template std::vector<NodeStatus> active_at(const ContactInterface<3>&,
                                           const std::vector<dealii::Point<3>>&);
template std::vector<bool> active_nodes(const ContactInterface<2>&);
template std::vector<bool> active_nodes(const ContactInterface<3>&);

}  // namespace geneva::fem
