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
    const Circle& circle = mesh.circles[static_cast<std::size_t>(edge.circle)];
    const auto& centre = circle.centre;
    const auto [x, y] = middle(mesh.vertices[edge.vertices[0]], mesh.vertices[edge.vertices[1]]);
    const double scale = circle.radius / std::hypot(x - centre[0], y - centre[1]);
    middles[ordered(edge.vertices[0], edge.vertices[1])] = {centre[0] + scale * (x - centre[0]),
                                                            centre[1] + scale * (y - centre[1])};
  }
  return middles;
}

using PlaceInSpace = std::array<double, 3>;

/// From one point to another; zero if they are the same.
PlaceInSpace unit_vector(const PlaceInSpace& from, const PlaceInSpace& to) {
  PlaceInSpace vector{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  for (double& component : vector) component = length > 0. ? component / length : 0.;
  return vector;
}

double triple_product(const PlaceInSpace& a, const PlaceInSpace& b, const PlaceInSpace& c) {
  return (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1] +
         (a[0] * b[1] - a[1] * b[0]) * c[2];
}

double minimum_of_children(const Corners& outer, const Corners& middles) {
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

template <int dim>
double scaled_jacobian(const MeshData<dim>& mesh, const Cell<dim>& cell) {
  if constexpr (dim == 2) {
    return scaled_jacobian(corners(mesh, cell));
  } else {
    double least = 1.;
    for (std::size_t i = 0; i < 8; ++i) {
      const bool is_above = i > 3;
      const std::size_t ring = is_above ? 4 : 0;
      const std::size_t next = ring + (i + 1) % 4;
      const std::size_t last = ring + (i + 3) % 4;
      const auto edge = [&](const std::size_t to) {
        return unit_vector(mesh.vertices[cell.vertices[i]], mesh.vertices[cell.vertices[to]]);
      };
      least = std::min(least, triple_product(edge(is_above ? last : next),
                                             edge(is_above ? next : last), edge((i + 4) % 8)));
    }
    return least;
  }
}

template double scaled_jacobian(const MeshData<2>&, const Cell<2>&);
template double scaled_jacobian(const MeshData<3>&, const Cell<3>&);

double minimum_scaled_jacobian(const MeshData<2>& mesh) {
  double least = 1.;
  for (const Cell<2>& quad : mesh.cells)
    least = std::min(least, scaled_jacobian(corners(mesh, quad)));
  return least;
}

double minimum_scaled_jacobian_refined(const MeshData<2>& mesh) {
  const auto bent = middles_on_circles(mesh);
  double least = 1.;
  for (const Cell<2>& quad : mesh.cells) {
    const Corners outer = corners(mesh, quad);
    Corners middles{};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto found = bent.find(ordered(quad.vertices[i], quad.vertices[(i + 1) % 4]));
      middles[i] = found == bent.end() ? middle(outer[i], outer[(i + 1) % 4]) : found->second;
    }
    least = std::min(least, minimum_of_children(outer, middles));
  }
  return least;
}

}  // namespace geneva::mesh
