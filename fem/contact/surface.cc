#include "fem/contact/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

namespace {

/// Faces of the surface by the boundary node they start from.
std::map<unsigned int, BoundaryFace<2>> faces_by_start(const Boundary<2>& boundary,
                                                       const unsigned int surface_id) {
  std::map<unsigned int, BoundaryFace<2>> faces;
  for (const BoundaryFace<2>& face : boundary.faces)
    if (face.surface == surface_id) faces.emplace(face.nodes[0], face);
  return faces;
}

/// Where to begin: the starts of open chains first, then any remaining (closed) chain, each nearest
/// to the origin.
unsigned int chain_start(const Boundary<2>& boundary,
                         const std::map<unsigned int, BoundaryFace<2>>& faces,
                         const Point<2>& origin) {
  std::set<unsigned int> ends;
  for (const auto& [start, face] : faces) ends.insert(face.nodes[1]);
  const bool has_open_chain = std::any_of(
      faces.begin(), faces.end(), [&](const auto& entry) { return ends.count(entry.first) == 0; });
  unsigned int best = faces.begin()->first;
  double best_distance = std::numeric_limits<double>::max();
  for (const auto& [start, face] : faces) {
    if (has_open_chain && ends.count(start) > 0) continue;
    const double distance = origin.distance(boundary.nodes[start].position);
    if (distance < best_distance) {
      best = start;
      best_distance = distance;
    }
  }
  return best;
}

double arc_length(const Surface<2>& surface, const SurfaceFace<2>& face) {
  const double chord =
      surface.nodes[face.nodes[0]].position.distance(surface.nodes[face.nodes[1]].position);
  if (face.circle < 0) return chord;
  const double radius = surface.circles[static_cast<std::size_t>(face.circle)].radius;
  return 2. * radius * std::asin(std::min(1., chord / (2. * radius)));
}

void set_normals(Surface<2>& surface) {
  for (const SurfaceFace<2>& face : surface.faces)
    for (const unsigned int node : face.nodes)
      surface.nodes[node].normal += true_normal(surface, face, surface.nodes[node].position);
  for (SurfaceNode<2>& node : surface.nodes) node.normal /= node.normal.norm();
}

}  // namespace

Tensor<1, 2> true_normal(const Surface<2>& surface, const SurfaceFace<2>& face,
                         const Point<2>& node) {
  const Tensor<1, 2> of_chord = flat_normal(surface, face);
  if (face.circle < 0) return of_chord;
  const Tensor<1, 2> outwards =
      radial(surface.circles[static_cast<std::size_t>(face.circle)], node);
  return outwards / outwards.norm() * (outwards * of_chord > 0. ? 1. : -1.);
}

std::vector<bool> corners(const Surface<2>& surface) {
  std::vector<bool> result(surface.nodes.size(), false);
  std::vector<unsigned int> edges(surface.nodes.size(), 0);
  for (const SurfaceFace<2>& face : surface.faces)
    for (const unsigned int node : face.nodes) {
      if (!leaves_smoothly(surface, face, node)) result[node] = true;
      ++edges[node];
    }
  for (std::size_t node = 0; node < result.size(); ++node)
    if (edges[node] != 2) result[node] = true;
  return result;
}

template <int dim>
Tensor<1, dim> radial(const mesh::Circle& circle, const Point<dim>& point) {
  std::array<double, 3> place{};
  for (unsigned int component = 0; component < dim; ++component)
    place[component] = point[component];
  const std::array<double, 3> arm = mesh::radial(circle, place);
  Tensor<1, dim> result;
  for (unsigned int component = 0; component < dim; ++component) result[component] = arm[component];
  return result;
}

template Tensor<1, 2> radial(const mesh::Circle&, const Point<2>&);
template Tensor<1, 3> radial(const mesh::Circle&, const Point<3>&);

Point<2> chord_point(const Surface<2>& surface, const SurfaceFace<2>& face, const double xi) {
  const Point<2>& start = surface.nodes[face.nodes[0]].position;
  return start + xi * (surface.nodes[face.nodes[1]].position - start);
}

Point<2> face_middle(const Surface<2>& surface, const SurfaceFace<2>& face) {
  return chord_point(surface, face, 0.5);
}

Point<2> true_point(const Surface<2>& surface, const SurfaceFace<2>& face,
                    const Point<2>& on_chord) {
  if (face.circle < 0) return on_chord;
  const mesh::Circle& circle = surface.circles[static_cast<std::size_t>(face.circle)];
  const Tensor<1, 2> outwards = radial(circle, on_chord);
  return Point<2>(circle.centre[0], circle.centre[1]) + circle.radius / outwards.norm() * outwards;
}

double curvature(const Surface<2>& surface, const SurfaceFace<2>& face) {
  if (face.circle < 0) return 0.;
  const mesh::Circle& circle = surface.circles[static_cast<std::size_t>(face.circle)];
  const Tensor<1, 2> outwards = radial(circle, face_middle(surface, face));
  return (outwards * flat_normal(surface, face) > 0. ? 1. : -1.) / circle.radius;
}

Tensor<1, 2> flat_normal(const Surface<2>& surface, const SurfaceFace<2>& face) {
  const Tensor<1, 2> tangent =
      surface.nodes[face.nodes[1]].position - surface.nodes[face.nodes[0]].position;
  return Tensor<1, 2>({tangent[1], -tangent[0]}) / tangent.norm();
}

Surface<2> make_surface(const Boundary<2>& boundary, const unsigned int surface_id,
                        const Point<2>& origin) {
  Surface<2> surface;
  surface.circles = boundary.circles;
  auto faces = faces_by_start(boundary, surface_id);
  std::map<unsigned int, unsigned int> local_node;
  const auto add_node = [&](const unsigned int node, const double at) {
    const auto [entry, is_new] =
        local_node.emplace(node, static_cast<unsigned int>(surface.nodes.size()));
    if (is_new)
      surface.nodes.push_back({boundary.nodes[node].position, {}, boundary.nodes[node].dofs, at});
    return entry->second;
  };

  while (!faces.empty()) {
    auto next = faces.find(chain_start(boundary, faces, origin));
    while (next != faces.end()) {
      const BoundaryFace<2>& face = next->second;
      const unsigned int start = add_node(face.nodes[0], surface.length);
      const unsigned int end_node = face.nodes[1];
      surface.closed = local_node.count(end_node) > 0;
      surface.faces.push_back({{start, start}, face.circle});
      surface.faces.back().nodes[1] = add_node(end_node, 0.);
      const double length = arc_length(surface, surface.faces.back());
      surface.length += length;
      if (!surface.closed) surface.nodes.back().arc_length = surface.length;
      faces.erase(next);
      next = faces.find(end_node);
    }
  }
  set_normals(surface);
  return surface;
}

}  // namespace geneva::fem
