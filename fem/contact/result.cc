#include "fem/contact/result.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "fem/contact/surface_in_space.h"
#include "mesh/dense_algebra.h"

namespace geneva::fem {

namespace {

/// Least-squares parabola c0 + c1 x + c2 x^2 through points (x, q), x scaled to about 1 by the
/// caller.
Eigen::Vector3d fitted_parabola(const std::vector<std::pair<double, double>>& points) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd values(matrix.rows());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const auto& [x, q] = points[static_cast<std::size_t>(i)];
    matrix.row(i) << 1., x, x * x;
    values(i) = q;
  }
  return mesh::least_squares(matrix, values);
}

/// Where the pressure falls to zero beyond the last active node `edge`: between smooth bodies p^2
/// is a smooth function of the place up to the end of the contact (a parabola after Hertz), so the
/// parabola fitted to this half of the contact without its last node is followed to zero, and kept
/// between the last but one active node and the first open one.
double contact_end(const std::vector<ContactNode<2>>& nodes, const std::size_t edge,
                   const int inwards, const std::size_t count) {
  const auto edge_node = nodes.begin() + static_cast<std::ptrdiff_t>(edge);
  const auto node = [&](const int steps) -> const ContactNode<2>& {
    return edge_node[inwards * steps];
  };
  const double last = node(0).arc_length;
  const int half = static_cast<int>(count) / 2;
  if (half < 4) return last;
  const double reach = std::abs(node(half).arc_length - last);
  std::vector<std::pair<double, double>> points;
  for (int i = 1; i <= half; ++i)
    points.emplace_back(std::abs(node(i).arc_length - last) / reach,
                        node(i).pressure * node(i).pressure);
  const Eigen::Vector3d c = fitted_parabola(points);
  const double discriminant = c(1) * c(1) - 4. * c(0) * c(2);
  if (c(1) <= 0. || discriminant < 0.) return last;
  const double inside =
      -2. * c(0) / (c(1) + std::sqrt(discriminant));  // distance inwards, usually negative
  const double end = last + inwards * inside * reach;
  const double inner = node(1).arc_length;
  const double outside = node(-1).arc_length;
  return std::clamp(end, std::min(inner, outside), std::max(inner, outside));
}

/// The contact between nodes `begin` and `end`, its ends fitted where they are free.
ContactInterval fitted_interval(const std::vector<ContactNode<2>>& nodes, const std::size_t begin,
                                const std::size_t end) {
  const std::size_t count = end - begin + 1;
  const bool at_start = begin == 0;
  const bool at_finish = end + 1 == nodes.size();
  double peak = 0.;
  for (std::size_t i = begin; i <= end; ++i) peak = std::max(peak, nodes[i].pressure);
  const bool peaks_at_end = nodes[at_start ? begin : end].pressure > 0.99 * peak;
  return {at_start ? nodes[begin].arc_length : contact_end(nodes, begin, 1, count),
          at_finish ? nodes[end].arc_length : contact_end(nodes, end, -1, count),
          at_start != at_finish && peaks_at_end};
}

std::vector<ContactInterval> fitted_intervals(const std::vector<ContactNode<2>>& nodes) {
  std::vector<ContactInterval> intervals;
  for (std::size_t begin = 0; begin < nodes.size(); ++begin) {
    if (!nodes[begin].active) continue;
    std::size_t end = begin;
    while (end + 1 < nodes.size() && nodes[end + 1].active) ++end;
    intervals.push_back(fitted_interval(nodes, begin, end));
    begin = end;
  }
  return intervals;
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
  if (nearest == surface.faces.end() || nearest->circle < 0) return {-1, false};
  const auto outwards = radial(surface.circles[static_cast<std::size_t>(nearest->circle)],
                               face_middle(surface, *nearest));
  return {nearest->circle, outwards * flat_normal(surface, *nearest) > 0.};
}

template <int dim>
ContactNode<dim> contact_node(const ContactInterface<dim>& interface, const std::size_t row_index,
                              const ContactState& state, const Scales& scales) {
  const MortarRow<dim>& row = interface.rows[row_index];
  const SurfaceNode<dim>& node = interface.source.nodes[row.node];
  ContactNode<dim> result{node.arc_length * scales.length,
                          {},
                          {},
                          state.pressure[row_index] * scales.stress,
                          state.gap[row_index] * scales.length,
                          row.initial_gap / row.weight * scales.length,
                          row.weight * scales.length * scales.length,
                          interface.active[row_index]};
  for (unsigned int component = 0; component < dim; ++component) {
    result.position[component] = node.position[component] * scales.length;
    result.normal[component] = row.normal[component];
  }
  return result;
}

void add_intervals(ContactResult<2>& result) {
  result.intervals = fitted_intervals(result.nodes);
  for (const ContactInterval& interval : result.intervals)
    if (interval.half_width() > result.half_width) {
      result.half_width = interval.half_width();
      result.symmetric = interval.symmetric;
    }
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
    }
    result.moment += moment_of<dim>(arm, force);
    if (node.active) ++result.active_nodes;
    if (!node.active) result.max_penetration = std::max(result.max_penetration, -node.gap);
    if (node.pressure > result.peak_pressure) {
      result.peak_pressure = node.pressure;
      peak = interface.source.nodes[interface.rows[i].node].position;
    }
  }
  if constexpr (dim == 2)
    add_intervals(result);
  else
    add_faces(interface, result);
  std::tie(result.source_circle, result.source_is_convex) = shape_at(interface.source, peak);
  std::tie(result.target_circle, result.target_is_convex) = shape_at(interface.target, peak);
  return result;
}

template ContactResult<2> contact_result(const ContactPair&, const ContactInterface<2>&,
                                         const ContactState&, const Scales&);
template ContactResult<3> contact_result(const ContactPair&, const ContactInterface<3>&,
                                         const ContactState&, const Scales&);

}  // namespace geneva::fem
