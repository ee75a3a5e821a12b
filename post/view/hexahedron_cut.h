#pragma once

#include <array>
#include <vector>

namespace geneva::post {

/// A point on the straight line between two corners of a cell.
struct EdgePoint {
  unsigned int first;   ///< the smaller of the corners
  unsigned int second;  ///< equal to first at a corner
  double fraction;      ///< of the way from first to second
};

/// Triangles of the plane in which a hexahedron is cut, as six tetrahedra around its diagonal; none
/// where it lies on one side.
/// @param distances of the corners from the plane, any unit; corners in lexicographic order
std::vector<std::array<EdgePoint, 3>> cut_hexahedron(const std::array<double, 8>& distances);

}  // namespace geneva::post
