#include "post/view/hexahedron_cut.h"

#include <algorithm>

namespace geneva::post {

namespace {

using Tetrahedron = std::array<unsigned int, 4>;

/// Around the diagonal from the first to the last corner.
constexpr std::array<Tetrahedron, 6> tetrahedra{{{{0, 1, 3, 7}},
                                                 {{0, 1, 5, 7}},
                                                 {{0, 2, 3, 7}},
                                                 {{0, 2, 6, 7}},
                                                 {{0, 4, 5, 7}},
                                                 {{0, 4, 6, 7}}}};

EdgePoint edge_point(const unsigned int a, const unsigned int b,
                     const std::array<double, 8>& distances) {
  const auto [first, second] = std::minmax({a, b});
  return {first, second, distances[first] / (distances[first] - distances[second])};
}

}  // namespace

std::vector<std::array<EdgePoint, 3>> cut_hexahedron(const std::array<double, 8>& distances) {
  std::vector<std::array<EdgePoint, 3>> triangles;
  for (const Tetrahedron& corners : tetrahedra) {
    std::vector<unsigned int> above;
    std::vector<unsigned int> below;
    for (const unsigned int corner : corners)
      (distances[corner] >= 0. ? above : below).push_back(corner);
    const auto cut = [&](const unsigned int a, const unsigned int b) {
      return edge_point(a, b, distances);
    };
    if (above.size() == 2) {
      triangles.push_back(
          {cut(above[0], below[0]), cut(above[0], below[1]), cut(above[1], below[1])});
      triangles.push_back(
          {cut(above[0], below[0]), cut(above[1], below[1]), cut(above[1], below[0])});
    } else if (above.size() == 1) {
      triangles.push_back(
          {cut(above[0], below[0]), cut(above[0], below[1]), cut(above[0], below[2])});
    } else if (below.size() == 1) {
      triangles.push_back(
          {cut(above[0], below[0]), cut(above[1], below[0]), cut(above[2], below[0])});
    }
  }
  return triangles;
}

}  // namespace geneva::post
