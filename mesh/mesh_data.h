#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

namespace geneva::mesh {

/// The circle that a boundary curve is part of.
struct Circle {
  std::array<double, 2> centre;  ///< [m]
  double radius;                 ///< [m], > 0
};

/// A cell with its four vertices counter-clockwise, and the body that it belongs to.
struct Quad {
  std::array<unsigned int, 4> vertices;
  unsigned int body;  ///< index into MeshData::bodies
};

/// A boundary edge, the surface that it belongs to and the circle that it is a chord of.
struct Edge {
  std::array<unsigned int, 2> vertices;
  unsigned int surface;  ///< index into MeshData::surfaces
  int circle;            ///< index into MeshData::circles; -1: straight
};

/// A coarse plane mesh of linear quadrilaterals with named bodies and surfaces; the bodies share no
/// vertex.
///
/// Every boundary edge is in `edges`; those of no named surface carry the surface "" (index 0,
/// always present).
struct MeshData {
  std::vector<std::array<double, 2>> vertices;  ///< [m]
  std::vector<Quad> quads;
  std::vector<Edge> edges;
  std::vector<Circle> circles;
  std::vector<std::string> bodies;
  std::vector<std::string> surfaces;
};

/// The part of check() on bodies: every body has cells, no vertex is shared by two or unused.
/// @throws std::invalid_argument naming the bodies, the place and what to change
void check_bodies(const MeshData& mesh);

/// Refuses a mesh that a solver cannot use.
///
/// Checked: finite coordinates, indices in range, scaled Jacobian above 0.02 in every cell, every
/// boundary edge listed once and no other, every body has cells, no vertex shared by two bodies, no
/// vertex unused, edges of a circle end on it.
/// @throws std::invalid_argument naming the cell, its place and what to change
void check(const MeshData& mesh);

/// Bodies that the edges of a surface (an index into MeshData::surfaces) belong to.
std::set<unsigned int> bodies_of(const MeshData& mesh, unsigned int surface);

}  // namespace geneva::mesh
