#pragma once

#include <array>
#include <boost/serialization/array_wrapper.hpp>
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
    as_block(archive, places);
    as_block(archive, displacements);
    as_block(archive, stress);
    archive& von_mises;
    std::size_t corners = cells.empty() ? 0 : cells.front().size();  // of each cell
    std::vector<std::size_t> nodes;
    nodes.reserve(corners * cells.size());
    for (const std::vector<std::size_t>& cell : cells)
      nodes.insert(nodes.end(), cell.begin(), cell.end());
    archive& corners& nodes& bodies;
    if constexpr (Archive::is_loading::value) {
      cells.clear();
      const auto width = static_cast<std::ptrdiff_t>(corners);
      for (auto at = nodes.begin(); at != nodes.end(); at += width)
        cells.emplace_back(at, at + width);
    }
  }

 private:
  /// Boost would take each array for an object of its own.
  template <class Archive, std::size_t n>
  static void as_block(Archive& archive, std::vector<std::array<double, n>>& values) {
    std::size_t size = values.size();
    archive& size;
    values.resize(size);
    if (size > 0) {
      auto block = boost::serialization::make_array(values.front().data(), n * size);
      archive& block;
    }
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
