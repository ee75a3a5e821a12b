#pragma once

#include <array>

#include "mesh/mesh_data.h"

namespace geneva::mesh {

/// Corners of a quadrilateral, counter-clockwise.
using Corners = std::array<std::array<double, 2>, 4>;

Corners corners(const MeshData<2>& mesh, const Cell<2>& quad);

/// Least over the corners of the sine of the angle there, -1..1: 1 for a rectangle, not positive
/// for a cell that is turned over, pinched or not convex.
double scaled_jacobian(const Corners& corners);

/// The same of a cell: in 3-D the minimum over the corners of the volume that the unit vectors
/// along its edges span.
template <int dim>
double scaled_jacobian(const MeshData<dim>& mesh, const Cell<dim>& cell);

/// Least scaled Jacobian of all cells.
double minimum_scaled_jacobian(const MeshData<2>& mesh);

/// Least scaled Jacobian after every cell has been divided into four and its edges on circles bent
/// to them.
///
/// New inner vertices as in transfinite interpolation: half the sum of the sides' middles less a
/// quarter of the sum of the corners.
double minimum_scaled_jacobian_refined(const MeshData<2>& mesh);

}  // namespace geneva::mesh
