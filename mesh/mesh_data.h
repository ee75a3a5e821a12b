#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mesh/grading.h"

namespace geneva::mesh {

/// The circle that a boundary curve of a plane mesh is part of; in 3-D the cylinder, the sphere or
/// the torus that a boundary surface is part of.
struct Circle {
  std::array<double, 3> centre;               ///< [m]; of a cylinder a point of its axis
  double radius;                              ///< [m], > 0; of a torus that of its tube
  std::array<double, 3> axis = {0., 0., 1.};  ///< unit vector; zero: a sphere
  double ring_radius = 0.;                    ///< [m], of the middle of a torus's tube; else 0
};

/// From the axis of the circle or cylinder, the centre of the sphere or the middle of the torus's
/// tube to a point [m].
std::array<double, 3> radial(const Circle& circle, const std::array<double, 3>& point);

/// Curvatures of a cylinder, sphere or torus at a point of it as a tensor [1/m], positive towards
/// the axis, the centre or the middle of the tube: 1/r; around a torus's axis cos(a)/(R + r
/// cos(a)), a being the angle around the tube from its outermost point.
/// @param normal unit vector; may be 0 if the tensor is only used with tangent directions
std::array<std::array<double, 3>, 3> curvature(const Circle& circle,
                                               const std::array<double, 3>& point,
                                               const std::array<double, 3>& normal);

/// A quadrilateral or hexahedron, and the body that it belongs to: four vertices counter-clockwise,
/// or four counter-clockwise as seen from above and the four above them.
template <int dim>
struct Cell {
  std::array<unsigned int, 1U << dim> vertices;
  unsigned int body;  ///< index into MeshData::bodies
};

/// A boundary edge or quadrilateral (its vertices one after the other around it), the surface that
/// it belongs to and the circle, cylinder, sphere or torus that its vertices lie on.
template <int dim>
struct Face {
  std::array<unsigned int, 1U << (dim - 1)> vertices;
  unsigned int surface;  ///< index into MeshData::surfaces
  int circle;            ///< index into MeshData::circles; -1: straight
};

/// A coarse mesh of linear quadrilaterals or hexahedra with named bodies and surfaces; the bodies
/// share no vertex.
///
/// Every face of the boundary is in `faces`; those of no named surface carry the surface "" (index
/// 0, always present).
template <int dim>
struct MeshData {
  std::vector<std::array<double, static_cast<std::size_t>(dim)>> vertices;  ///< [m]
  std::vector<Cell<dim>> cells;
  std::vector<Face<dim>> faces;
  std::vector<Circle> circles;
  std::vector<std::string> bodies;
  std::vector<std::string> surfaces;
  std::optional<Grading> grading;  ///< of the layers along z that refinement makes; in 3-D only
};

/// The faces of a cell: counter-clockwise edges, or quadrilaterals counter-clockwise as seen from
/// outside.
template <int dim>
std::vector<std::array<unsigned int, 1U << (dim - 1)>> sides(const Cell<dim>& cell);

/// The part of check() on bodies: every body has cells, no vertex is shared by two or unused.
/// @throws base::InputError naming the bodies, the place and what to change
template <int dim>
void check_bodies(const MeshData<dim>& mesh);

/// Refuses a mesh that a solver cannot use.
///
/// Checked: finite coordinates, indices in range, scaled Jacobian above 0.02 in every cell, every
/// boundary face listed once and no other, no two of them with three vertices in common, every body
/// has cells, no vertex shared by two bodies, no vertex unused, the vertices of faces on a circle,
/// cylinder or sphere lie on it.
/// @throws base::InputError naming the cell, its place and what to change
template <int dim>
void check(const MeshData<dim>& mesh);

/// Index of a name in a list. @throws std::out_of_range if it is not there (a bug: names are
/// checked before)
unsigned int index_of(const std::vector<std::string>& names, const std::string& name);

/// Bodies that the faces of a surface (an index into MeshData::surfaces) belong to.
template <int dim>
std::set<unsigned int> bodies_of(const MeshData<dim>& mesh, unsigned int surface);

}  // namespace geneva::mesh
