#include "mesh/mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace geneva::mesh {

namespace {

using Place = std::array<double, 2>;
using VertexPair = std::pair<unsigned int, unsigned int>;

VertexPair ordered(unsigned int first, unsigned int second) {
  return {std::min(first, second), std::max(first, second)};
}

Place middle(const Place& a, const Place& b) { return {(a[0] + b[0]) / 2., (a[1] + b[1]) / 2.}; }

/// Middles of the edges that are bent.
std::map<VertexPair, Place> middles_on_circles(const MeshData<2>& mesh) {
  std::map<VertexPair, Place> middles;
  for (const Face<2>& edge : mesh.faces) {
    if (edge.circle < 0) continue;
    const auto& [centre, radius] = mesh.circles[static_cast<std::size_t>(edge.circle)];
    const auto [x, y] = middle(mesh.vertices[edge.vertices[0]], mesh.vertices[edge.vertices[1]]);
    const double scale = radius / std::hypot(x - centre[0], y - centre[1]);
    middles[ordered(edge.vertices[0], edge.vertices[1])] = {centre[0] + scale * (x - centre[0]),
                                                            centre[1] + scale * (y - centre[1])};
  }
  return middles;
}

double least_of_children(const Corners& outer, const Corners& middles) {
  Place centre{0., 0.};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t d = 0; d < 2; ++d) centre[d] += middles[i][d] / 2. - outer[i][d] / 4.;
  double least = 1.;
  for (std::size_t i = 0; i < 4; ++i)
    least = std::min(least, scaled_jacobian({outer[i], middles[i], centre, middles[(i + 3) % 4]}));
  return least;
}

}  // namespace

Corners corners(const MeshData<2>& mesh, const Cell<2>& quad) {
  return {mesh.vertices[quad.vertices[0]], mesh.vertices[quad.vertices[1]],
          mesh.vertices[quad.vertices[2]], mesh.vertices[quad.vertices[3]]};
}

double scaled_jacobian(const Corners& corners) {
  double least = 1.;
  for (std::size_t i = 0; i < 4; ++i) {
    const Place& corner = corners[i];
    const Place& next = corners[(i + 1) % 4];
    const Place& last = corners[(i + 3) % 4];
    const Place a{next[0] - corner[0], next[1] - corner[1]};
    const Place b{last[0] - corner[0], last[1] - corner[1]};
    const double lengths = std::hypot(a[0], a[1]) * std::hypot(b[0], b[1]);
    least = std::min(least, lengths > 0. ? (a[0] * b[1] - a[1] * b[0]) / lengths : 0.);
  }
  return least;
}

double least_scaled_jacobian(const MeshData<2>& mesh) {
  double least = 1.;
  for (const Cell<2>& quad : mesh.cells)
    least = std::min(least, scaled_jacobian(corners(mesh, quad)));
  return least;
}

double least_scaled_jacobian_refined(const MeshData<2>& mesh) {
  const auto bent = middles_on_circles(mesh);
  double least = 1.;
  for (const Cell<2>& quad : mesh.cells) {
    const Corners outer = corners(mesh, quad);
    Corners middles{};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto found = bent.find(ordered(quad.vertices[i], quad.vertices[(i + 1) % 4]));
      middles[i] = found == bent.end() ? middle(outer[i], outer[(i + 1) % 4]) : found->second;
    }
    least = std::min(least, least_of_children(outer, middles));
  }
  return least;
}

}  // namespace geneva::mesh
