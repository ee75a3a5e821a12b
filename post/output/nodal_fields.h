#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace geneva::post {

/// Displacement and stress on cells, SI units; z is 0 in the plane.
struct NodalFields {
  std::vector<std::array<double, 3>> places;         ///< of the nodes, undeformed [m]
  std::vector<std::array<double, 3>> displacements;  ///< of the nodes [m]
  std::vector<std::array<double, 6>> stress;         ///< of the nodes: xx, yy, zz, xy, yz, zx [Pa]
  std::vector<double> von_mises;                     ///< of the nodes [Pa]
  /// Nodes of the cells, 4 of a quadrilateral, 8 of a hexahedron, in lexicographic order.
  std::vector<std::vector<std::size_t>> cells;
  std::vector<unsigned int> bodies;  ///< of the cells, in the order of the coarse mesh's bodies

  template <class Archive>
  void serialize(Archive& archive, const unsigned int /*version*/) {
    archive& places& displacements& stress& von_mises& cells& bodies;
  }
};

/// By node: a body whose cells have it; each node has one.
std::vector<unsigned int> bodies_of_nodes(const NodalFields& fields);

/// The mirror image about the plane y = 0.
NodalFields mirrored(NodalFields fields);

/// The greatest and the least principal stress [Pa].
struct PrincipalRange {
  double first;
  double third;
};

PrincipalRange principal_range(const std::array<double, 6>& stress);

/// Von Mises stress at a node [Pa].
double von_mises(const std::array<double, 6>& stress);

/// Maximum tensile stress at a node: the first principal stress [Pa].
inline double first_principal(const std::array<double, 6>& stress) {
  return principal_range(stress).first;
}

/// Unit vector along which the first principal stress acts.
std::array<double, 3> direction_of_first_principal(const std::array<double, 6>& stress);

/// Normal stress along a unit vector n: n.s.n [Pa].
double along(const std::array<double, 3>& n, const std::array<double, 6>& stress);

}  // namespace geneva::post
