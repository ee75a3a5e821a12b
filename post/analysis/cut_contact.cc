#include "post/analysis/cut_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "fem/symmetry.h"

namespace geneva::post {

namespace {

/// Whether a node lies where the surface ends: first or last in the plane.
bool is_at_end(const fem::ContactResult<2>& contact, const std::size_t node) {
  return node == 0 || node + 1 == contact.nodes.size();
}

/// In 3-D: on an edge of one face alone.
bool is_at_end(const fem::ContactResult<3>& contact, const std::size_t node) {
  std::map<std::pair<std::size_t, std::size_t>, int> faces_of;
  for (const auto& face : contact.faces)
    for (std::size_t i = 0; i < face.size(); ++i)
      if (face[i] == node || face[(i + 1) % face.size()] == node)
        ++faces_of[std::minmax(face[i], face[(i + 1) % face.size()])];
  return std::any_of(faces_of.begin(), faces_of.end(),
                     [](const auto& edge) { return edge.second == 1; });
}

/// Whether the surfaces that are in contact part from each other on the way along an axis, as they
/// do not along the line of a line contact.
/// @param end of the surface [m]
template <int dim>
bool parts_along(const fem::ContactResult<dim>& contact, const unsigned int axis,
                 const double end) {
  constexpr double far = 0.7;     // of the contact's reach, where a parabola has half of its height
  constexpr double share = 0.25;  // of the greatest gap: half of that, however far the mesh is off
  double reach = 0.;
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const auto& node : contact.nodes) {
    if (node.pressure <= 0.) continue;
    reach = std::max(reach, std::abs(node.position[axis] - end));
    least = std::min(least, node.initial_gap);
    most = std::max(most, node.initial_gap);
  }
  return std::all_of(contact.nodes.begin(), contact.nodes.end(), [&](const auto& node) {
    const bool is_far = node.pressure > 0. && std::abs(node.position[axis] - end) > far * reach;
    return !is_far || node.initial_gap - least > share * (most - least);
  });
}

}  // namespace

template <int dim>
std::optional<unsigned int> cut_axis(const fem::Solution<dim>& solution,
                                     const fem::ContactResult<dim>& contact) {
  constexpr double same = 1e-6;
  constexpr double amid = 0.5;    // of the peak; towards its own end Hertz's pressure falls to 0
  constexpr double across = 0.5;  // of a normal: a plane of symmetry holds those of its points
  const auto& nodes = contact.nodes;
  const auto planes = fem::mirrors(solution.mesh, solution.problem, contact);
  for (unsigned int axis = 0; axis < dim; ++axis) {
    const auto [low, high] = std::minmax_element(
        nodes.begin(), nodes.end(),
        [&](const auto& a, const auto& b) { return a.position[axis] < b.position[axis]; });
    if (low == nodes.end()) continue;
    const double slack = same * (high->position[axis] - low->position[axis]);
    for (const double end : {low->position[axis], high->position[axis]}) {
      const bool is_mirror = planes[axis] && std::abs(*planes[axis] - end) <= slack;
      if (is_mirror || slack == 0. || !parts_along(contact, axis, end)) continue;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (std::abs(nodes[i].normal[axis]) < across &&
            nodes[i].pressure > amid * contact.peak_pressure &&
            std::abs(nodes[i].position[axis] - end) <= slack && is_at_end(contact, i))
          return axis;
    }
  }
  return std::nullopt;
}

template std::optional<unsigned int> cut_axis(const fem::Solution<2>&,
                                              const fem::ContactResult<2>&);
template std::optional<unsigned int> cut_axis(const fem::Solution<3>&,
                                              const fem::ContactResult<3>&);

}  // namespace geneva::post
