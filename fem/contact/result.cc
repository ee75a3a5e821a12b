#include "fem/contact/result.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>

#include "fem/contact/active_set.h"
#include "fem/contact/free_end.h"
#include "fem/contact/peak_in_plane.h"
#include "fem/contact/surface_in_space.h"
#include "mesh/dense_algebra.h"

namespace geneva::fem {

namespace {

/// Where the pressure falls to zero beyond the last active node `edge`: with many nodes that of the
/// parabola, kept between the last but one active node and the first open one.
double contact_end(const std::vector<ContactNode<2>>& nodes, const std::size_t edge,
                   const int inwards, const std::size_t count) {
  constexpr std::size_t many = 24;
  const auto place = [&](const int steps) {
    const auto at = static_cast<std::ptrdiff_t>(edge) + std::ptrdiff_t{inwards} * steps;
    return nodes[static_cast<std::size_t>(at)].arc_length;
  };
  const std::optional<FreeEnd> end = free_end(nodes, edge, inwards, count);
  if (!end) return place(0);
  if (count < many) return place(0) + end->by_last_node * (place(-1) - place(0));
  const double fitted = place(0) + end->by_parabola * (place(-1) - place(0));
  return std::clamp(fitted, std::min(place(1), place(-1)), std::max(place(1), place(-1)));
}

/// The contact between nodes `begin` and `end`, its ends fitted where they are free.
ContactInterval fitted_interval(const std::vector<ContactNode<2>>& nodes, const std::size_t begin,
                                const std::size_t end) {
  const std::size_t count = end - begin + 1;
  const bool at_start = begin == 0;
  const bool at_finish = end + 1 == nodes.size();
  double peak = 0.;
  for (std::size_t i = begin; i <= end; ++i) peak = std::max(peak, nodes[i].pressure);
  constexpr double share = 0.97;  // next to an axis of revolution the pressure is 1 to 2 % off
  const bool peaks_at_end = nodes[at_start ? begin : end].pressure > share * peak;
  return {at_start ? nodes[begin].arc_length : contact_end(nodes, begin, 1, count),
          at_finish ? nodes[end].arc_length : contact_end(nodes, end, -1, count),
          at_start != at_finish && peaks_at_end};
}

std::vector<ContactInterval> fitted_intervals(const std::vector<ContactNode<2>>& nodes) {
  std::vector<ContactInterval> intervals;
  for (std::size_t begin = 0; begin < nodes.size(); ++begin) {
    if (!is_closed(nodes[begin].status)) continue;
    std::size_t end = begin;
    while (end + 1 < nodes.size() && is_closed(nodes[end + 1].status)) ++end;
    intervals.push_back(fitted_interval(nodes, begin, end));
    begin = end;
  }
  return intervals;
}

/// Circle of a face, and whether it bulges outwards.
template <int dim>
std::pair<int, bool> shape_of(const Surface<dim>& surface, const SurfaceFace<dim>& face) {
  if (face.circle < 0) return {-1, false};
  const auto outwards =
      radial(surface.circles[static_cast<std::size_t>(face.circle)], face_middle(surface, face));
  return {face.circle, outwards * flat_normal(surface, face) > 0.};
}

/// Circle of a surface near a point, and whether it bulges outwards.
template <int dim>
std::pair<int, bool> shape_at(const Surface<dim>& surface, const dealii::Point<dim>& point) {
  const auto distance = [&](const SurfaceFace<dim>& face) {
    return point.distance(face_middle(surface, face));
  };
  const auto nearest = std::min_element(
      surface.faces.begin(), surface.faces.end(),
      [&](const auto& one, const auto& other) { return distance(one) < distance(other); });
  return nearest == surface.faces.end() ? std::pair(-1, false) : shape_of(surface, *nearest);
}

/// 1/R of a shape, positive where it bulges.
template <int dim>
double curvature_of(const Surface<dim>& surface, const std::pair<int, bool>& shape) {
  if (shape.first < 0) return 0.;
  return (shape.second ? 1. : -1.) / surface.circles[static_cast<std::size_t>(shape.first)].radius;
}

/// Whether all faces between the chosen nodes have the same curvature, to a thousandth.
template <int dim>
bool has_one_curvature(const Surface<dim>& surface, const std::vector<bool>& nodes) {
  constexpr double same = 1e-3;
  std::optional<double> first;
  for (const SurfaceFace<dim>& face : surface.faces) {
    if (!std::all_of(face.nodes.begin(), face.nodes.end(),
                     [&](const unsigned int node) { return nodes[node]; }))
      continue;
    const double curvature = curvature_of(surface, shape_of(surface, face));
    if (!first) first = curvature;
    if (std::abs(curvature - *first) > same * std::abs(*first)) return false;
  }
  return true;
}

/// Which target nodes the pressure of active rows reaches.
template <int dim>
std::vector<bool> loaded_target_nodes(const ContactInterface<dim>& interface) {
  std::vector<bool> loaded(interface.target.nodes.size(), false);
  for (std::size_t i = 0; i < interface.rows.size(); ++i)
    if (is_closed(interface.status[i]))
      for (const auto& [node, coupling] : interface.rows[i].coupling) loaded[node] = true;
  return loaded;
}

template <int dim>
ContactNode<dim> contact_node(const ContactInterface<dim>& interface, const std::size_t row_index,
                              const ContactState& state, const Scales& scales) {
  const ContactRow<dim>& row = interface.rows[row_index];
  const SurfaceNode<dim>& node = interface.source.nodes[row.node];
  ContactNode<dim> result{node.arc_length * scales.length,
                          {},
                          {},
                          state.pressure[row_index] * scales.stress,
                          state.gap[row_index] * scales.length,
                          row.initial_gap / row.weight * scales.length,
                          row.weight * scales.length * scales.length,
                          interface.status[row_index],
                          {},
                          {}};
  for (unsigned int component = 0; component < dim; ++component) {
    result.position[component] = node.position[component] * scales.length;
    result.normal[component] = row.frame.normal[component];
    for (std::size_t i = 0; i < row.frame.tangents.size(); ++i) {
      const double along = row.frame.tangents[i][component];
      result.friction[component] += state.friction[row_index][i] * along * scales.stress;
      result.slip[component] += state.slip[row_index][i] * along * scales.length;
    }
  }
  return result;
}

/// Of the interval with the peak pressure: a slack ring may touch over a wider one elsewhere.
void take_half_width(ContactResult<2>& result) {
  result.half_width = 0.;
  const auto peak = std::max_element(
      result.nodes.begin(), result.nodes.end(),
      [](const auto& one, const auto& other) { return one.pressure < other.pressure; });
  const auto distance = [&](const ContactInterval& interval) {
    return std::max({0., interval.begin - peak->arc_length, peak->arc_length - interval.end});
  };
  const auto nearest = std::min_element(
      result.intervals.begin(), result.intervals.end(),
      [&](const auto& one, const auto& other) { return distance(one) < distance(other); });
  if (nearest == result.intervals.end()) return;
  result.half_width = nearest->half_width();
  result.symmetric = nearest->symmetric;
}

void add_faces(const ContactInterface<3>& interface, ContactResult<3>& result) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> index(interface.source.nodes.size(), none);
  for (std::size_t i = 0; i < interface.rows.size(); ++i) index[interface.rows[i].node] = i;
  for (const SurfaceFace<3>& face : interface.source.faces) {
    std::array<std::size_t, 4> nodes{};
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = index[face.nodes[i]];
    if (std::find(nodes.begin(), nodes.end(), none) == nodes.end()) result.faces.push_back(nodes);
  }
}

}  // namespace

template <int dim>
ContactResult<dim> contact_result(const ContactPair& pair, const ContactInterface<dim>& interface,
                                  const ContactState& state, const Scales& scales) {
  ContactResult<dim> result{};
  result.source = pair.source;
  result.target = pair.target;
  dealii::Point<dim> peak;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const ContactNode<dim> node = contact_node(interface, i, state, scales);
    result.nodes.push_back(node);
    dealii::Tensor<1, dim> force;
    dealii::Tensor<1, dim> arm;
    for (unsigned int component = 0; component < dim; ++component) {
      force[component] = node.pressure * node.tributary * node.normal[component];
      arm[component] = node.position[component];
      result.force[component] += force[component];
      result.friction_force[component] += node.friction[component] * node.tributary;
    }
    result.moment += moment_of<dim>(arm, force);
    if (is_closed(node.status))
      ++result.active_nodes;
    else
      result.max_penetration = std::max(result.max_penetration, -node.gap);
    if (node.pressure > result.peak_pressure) {
      result.peak_pressure = node.pressure;
      peak = interface.source.nodes[interface.rows[i].node].position;
    }
  }
  if constexpr (dim == 2) {
    result.intervals = fitted_intervals(result.nodes);
    take_half_width(result);
    result.peak_pressure = fitted_peak(result.nodes).pressure;
  } else {
    add_faces(interface, result);
  }
  std::tie(result.source_circle, result.source_is_convex) = shape_at(interface.source, peak);
  std::tie(result.target_circle, result.target_is_convex) = shape_at(interface.target, peak);
  result.has_one_curvature = has_one_curvature(interface.source, active_nodes(interface)) &&
                             has_one_curvature(interface.target, loaded_target_nodes(interface));
  return result;
}

void count_from_mirrors(ContactResult<2>& contact,
                        const std::array<std::optional<double>, 2>& places, const double size) {
  constexpr double rounding = 1e-9;
  const auto is_mirrored = [&](const ContactNode<2>& node) {
    for (std::size_t i = 0; i < 2; ++i)
      if (places[i] && std::abs(node.position[i] - *places[i]) <= rounding * size) return true;
    return false;
  };
  for (ContactInterval& interval : contact.intervals) {
    const ContactNode<2>& first = contact.nodes.front();
    const ContactNode<2>& last = contact.nodes.back();
    const bool at_start = interval.begin <= first.arc_length;
    const bool at_end = interval.end >= last.arc_length;
    if (at_start != at_end && is_mirrored(at_start ? first : last)) interval.symmetric = true;
  }
  take_half_width(contact);
}

template ContactResult<2> contact_result(const ContactPair&, const ContactInterface<2>&,
                                         const ContactState&, const Scales&);
template ContactResult<3> contact_result(const ContactPair&, const ContactInterface<3>&,
                                         const ContactState&, const Scales&);

}  // namespace geneva::fem
