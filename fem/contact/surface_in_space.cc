#include "fem/contact/surface_in_space.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

namespace geneva::fem {

using dealii::Point;
using dealii::Tensor;

namespace {

/// 1 where the body is inside the cylinder, sphere or torus, -1 where it is outside.
double side(const Surface<3>& surface, const SurfaceFace<3>& face) {
  const mesh::Circle& circle = surface.circles[static_cast<std::size_t>(face.circle)];
  const Point<3> middle = face_middle(surface, face);
  return radial(circle, middle) * flat_normal(surface, face) > 0. ? 1. : -1.;
}

double extent(const Surface<3>& surface) {
  Point<3> lowest = surface.nodes.front().position;
  Point<3> highest = lowest;
  for (const SurfaceNode<3>& node : surface.nodes)
    for (unsigned int component = 0; component < 3; ++component) {
      lowest[component] = std::min(lowest[component], node.position[component]);
      highest[component] = std::max(highest[component], node.position[component]);
    }
  return lowest.distance(highest);
}

}  // namespace

Tensor<1, 3> true_normal(const Surface<3>& surface, const SurfaceFace<3>& face,
                         const Point<3>& node) {
  if (face.circle < 0) return flat_normal(surface, face);
  const Tensor<1, 3> outwards =
      radial(surface.circles[static_cast<std::size_t>(face.circle)], node);
  return side(surface, face) / outwards.norm() * outwards;
}

Surface<3> make_surface(const Boundary<3>& boundary, const unsigned int surface_id) {
  Surface<3> surface;
  surface.circles = boundary.circles;
  std::map<unsigned int, unsigned int> local_node;
  for (const BoundaryFace<3>& face : boundary.faces) {
    if (face.surface != surface_id) continue;
    SurfaceFace<3> taken{{}, face.circle};
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      const auto [entry, is_new] =
          local_node.emplace(face.nodes[i], static_cast<unsigned int>(surface.nodes.size()));
      const BoundaryNode<3>& node = boundary.nodes[face.nodes[i]];
      if (is_new) surface.nodes.push_back({node.position, {}, node.dofs, 0.});
      taken.nodes[i] = entry->second;
    }
    surface.faces.push_back(taken);
  }
  for (const SurfaceFace<3>& face : surface.faces)
    for (const unsigned int node : face.nodes)
      surface.nodes[node].normal += true_normal(surface, face, surface.nodes[node].position);
  for (SurfaceNode<3>& node : surface.nodes) node.normal /= node.normal.norm();
  surface.length = extent(surface);
  return surface;
}

std::vector<unsigned int> steps_from(const Surface<3>& surface, const std::vector<bool>& marked) {
  const auto unreached = static_cast<unsigned int>(surface.nodes.size());
  std::vector<std::vector<unsigned int>> faces_of(surface.nodes.size());
  for (unsigned int face = 0; face < surface.faces.size(); ++face)
    for (const unsigned int node : surface.faces[face].nodes) faces_of[node].push_back(face);
  std::vector<unsigned int> steps(surface.nodes.size(), unreached);
  std::queue<unsigned int> front;
  for (unsigned int node = 0; node < steps.size(); ++node)
    if (marked[node]) {
      steps[node] = 0;
      front.push(node);
    }
  for (; !front.empty(); front.pop())
    for (const unsigned int face : faces_of[front.front()])
      for (const unsigned int node : surface.faces[face].nodes)
        if (steps[node] == unreached) {
          steps[node] = steps[front.front()] + 1;
          front.push(node);
        }
  return steps;
}

std::array<double, 4> bilinear_shapes(const std::array<double, 2>& at) {
  const auto [a, b] = at;
  return {(1. - a) * (1. - b), a * (1. - b), a * b, (1. - a) * b};
}

Point<3> face_point(const Surface<3>& surface, const SurfaceFace<3>& face,
                    const std::array<double, 2>& at) {
  const auto shapes = bilinear_shapes(at);
  Point<3> point;
  for (std::size_t i = 0; i < 4; ++i)
    point += shapes[i] * Tensor<1, 3>(surface.nodes[face.nodes[i]].position);
  return point;
}

Point<3> face_middle(const Surface<3>& surface, const SurfaceFace<3>& face) {
  return face_point(surface, face, {0.5, 0.5});
}

Tensor<1, 3> face_edge(const Surface<3>& surface, const SurfaceFace<3>& face,
                       const std::size_t direction) {
  const auto node = [&](const std::size_t i) -> const Point<3>& {
    return surface.nodes[face.nodes[i]].position;
  };
  return direction == 0 ? 0.5 * ((node(1) - node(0)) + (node(2) - node(3)))
                        : 0.5 * ((node(3) - node(0)) + (node(2) - node(1)));
}

Tensor<1, 3> flat_normal(const Surface<3>& surface, const SurfaceFace<3>& face) {
  const Tensor<1, 3> normal =
      dealii::cross_product_3d(face_edge(surface, face, 0), face_edge(surface, face, 1));
  return normal / normal.norm();
}

Tensor<1, 3> face_normal(const Surface<3>& surface, const SurfaceFace<3>& face,
                         const std::array<double, 2>& at) {
  const auto shapes = bilinear_shapes(at);
  Tensor<1, 3> normal;
  for (std::size_t i = 0; i < 4; ++i) normal += shapes[i] * surface.nodes[face.nodes[i]].normal;
  return normal / normal.norm();
}

Point<3> true_point(const Surface<3>& surface, const SurfaceFace<3>& face,
                    const Point<3>& on_face) {
  if (face.circle < 0) return on_face;
  const mesh::Circle& circle = surface.circles[static_cast<std::size_t>(face.circle)];
  const Tensor<1, 3> outwards = radial(circle, on_face);
  return on_face + (circle.radius / outwards.norm() - 1.) * outwards;
}

double bulge(const Surface<3>& surface, const SurfaceFace<3>& face, const Tensor<1, 3>& along) {
  if (face.circle < 0) return 0.;
  const Point<3> middle = face_middle(surface, face);
  const auto curvature = mesh::curvature(surface.circles[static_cast<std::size_t>(face.circle)],
                                         {middle[0], middle[1], middle[2]}, {});
  double of_edge = 0.;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int k = 0; k < 3; ++k) of_edge += along[i] * curvature[i][k] * along[k];
  return side(surface, face) * of_edge;
}

}  // namespace geneva::fem
