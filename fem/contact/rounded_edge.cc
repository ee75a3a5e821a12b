#include "fem/contact/rounded_edge.h"

#include <algorithm>

#include "fem/contact/surface_in_space.h"

namespace geneva::fem {

namespace {

double greatest_curvature(const Surface<2>& surface, const SurfaceFace<2>& face) {
  return curvature(surface, face);
}

double greatest_curvature(const Surface<3>& surface, const SurfaceFace<3>& face) {
  double greatest = 0.;
  for (const std::size_t direction : {0U, 1U}) {
    const dealii::Tensor<1, 3> edge = face_edge(surface, face, direction);
    greatest = std::max(greatest, bulge(surface, face, edge) / edge.norm_square());
  }
  return greatest;
}

/// What the faces of a node have in common.
struct AroundNode {
  double least_curvature = 0.;
  double greatest_curvature = 0.;
  bool is_smooth = true;
  bool is_met = false;
};

}  // namespace

template <int dim>
bool has_rounded_edge(const Surface<dim>& surface) {
  // curvatures of one cylinder differ by the faces' slant only
  constexpr double share = 0.1;
  std::vector<AroundNode> nodes(surface.nodes.size());
  for (const SurfaceFace<dim>& face : surface.faces) {
    const double here = greatest_curvature(surface, face);
    for (const unsigned int node : face.nodes) {
      AroundNode& around = nodes[node];
      around.is_smooth = around.is_smooth && leaves_smoothly(surface, face, node);
      around.least_curvature = around.is_met ? std::min(around.least_curvature, here) : here;
      around.greatest_curvature = around.is_met ? std::max(around.greatest_curvature, here) : here;
      around.is_met = true;
    }
  }
  return std::any_of(nodes.begin(), nodes.end(), [](const AroundNode& around) {
    return around.is_smooth && around.greatest_curvature > 0. &&
           around.greatest_curvature - around.least_curvature > share * around.greatest_curvature;
  });
}

template bool has_rounded_edge(const Surface<2>&);
template bool has_rounded_edge(const Surface<3>&);

}  // namespace geneva::fem
