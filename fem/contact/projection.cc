#include "fem/contact/projection.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

namespace {

/// Where the normal of a target node meets the line through a source edge that it looks at:
/// parameter along the edge, and the gap.
struct NodeProjection {
  double xi;
  double gap;
};

std::optional<NodeProjection> project_node(const Surface<2>& source, const SurfaceFace<2>& face,
                                           const SurfaceNode<2>& target_node) {
  const Point<2>& start = source.nodes[face.nodes[0]].position;
  const Tensor<1, 2> chord = source.nodes[face.nodes[1]].position - start;
  // Minus the cosine between the outward normals, times the edge's length: where it changes its
  // sign between two nodes, their normals pass the edge on either side without looking at it.
  const double determinant = cross(chord, target_node.normal);
  if (-determinant > opposed * chord.norm()) return std::nullopt;
  const Tensor<1, 2> to_node = target_node.position - start;
  return NodeProjection{cross(to_node, target_node.normal) / determinant,
                        cross(to_node, chord) / determinant};
}

/// The share of the source edge over one target edge, or nothing.
std::optional<Overlap> overlap_with(const Surface<2>& source, const SurfaceFace<2>& face,
                                    const Surface<2>& target, const unsigned int target_face) {
  const SurfaceFace<2>& other = target.faces[target_face];
  if (flat_normal(source, face) * flat_normal(target, other) > opposed) return std::nullopt;
  const auto first = project_node(source, face, target.nodes[other.nodes[0]]);
  const auto second = project_node(source, face, target.nodes[other.nodes[1]]);
  if (!first || !second) return std::nullopt;
  const double begin = std::max(0., std::min(first->xi, second->xi));
  const double end = std::min(1., std::max(first->xi, second->xi));
  if (end - begin < 1e-12) return std::nullopt;
  const auto gap_at = [&](const double xi) {
    return first->gap + (xi - first->xi) / (second->xi - first->xi) * (second->gap - first->gap);
  };
  // An overlap of a quarter of the surface is no interference: the normal has come out on the
  // body's far side.
  if (std::min(gap_at(begin), gap_at(end)) < -0.25 * target.length) return std::nullopt;
  return Overlap{begin, end, target_face};
}

}  // namespace

Tensor<1, 2> face_normal(const Surface<2>& surface, const SurfaceFace<2>& face, const double eta) {
  const Tensor<1, 2> normal =
      (1. - eta) * surface.nodes[face.nodes[0]].normal + eta * surface.nodes[face.nodes[1]].normal;
  return normal / normal.norm();
}

double project_on_face(const Surface<2>& surface, const SurfaceFace<2>& face,
                       const Point<2>& point) {
  const SurfaceNode<2>& start = surface.nodes[face.nodes[0]];
  const SurfaceNode<2>& end = surface.nodes[face.nodes[1]];
  const Tensor<1, 2> chord = end.position - start.position;
  const Tensor<1, 2> normal_change = end.normal - start.normal;
  const Tensor<1, 2> to_point = point - start.position;
  // cross(to_point - eta chord, n_0 + eta (n_1 - n_0)) = 0, a quadratic that Newton's method solves
  // from the chord's own projection.
  double eta = (to_point * chord) / chord.norm_square();
  for (unsigned int step = 0; step < 20; ++step) {
    const Tensor<1, 2> normal = start.normal + eta * normal_change;
    const Tensor<1, 2> distance = to_point - eta * chord;
    const double slope = cross(distance, normal_change) - cross(chord, normal);
    const double change = cross(distance, normal) / slope;
    eta -= change;
    if (std::abs(change) < 1e-15) break;
  }
  return eta;
}

std::vector<Overlap> overlaps(const Surface<2>& source, const SurfaceFace<2>& source_face,
                              const Surface<2>& target) {
  std::vector<Overlap> result;
  for (unsigned int face = 0; face < target.faces.size(); ++face)
    if (const auto overlap = overlap_with(source, source_face, target, face))
      result.push_back(*overlap);
  std::sort(result.begin(), result.end(),
            [](const Overlap& a, const Overlap& b) { return a.begin < b.begin; });
  for (std::size_t i = 1; i < result.size(); ++i)
    result[i].begin = std::max(result[i].begin, result[i - 1].end);
  result.erase(
      std::remove_if(result.begin(), result.end(),
                     [](const Overlap& overlap) { return overlap.end - overlap.begin < 1e-12; }),
      result.end());
  return result;
}

}  // namespace geneva::fem
