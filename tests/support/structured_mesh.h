#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace geneva::test {

/// n equal steps from begin to end: n + 1 values.
std::vector<double> equal_steps(double begin, double end, unsigned int n);

/// A mesh without bodies, with the unnamed surface.
mesh::MeshData<2> empty_mesh();

/// Names of the four sides of a rectangle; "" stays unnamed.
struct RectangleSides {
  std::string bottom, right, top, left;
};

/// Adds a rectangular body with grid lines at the given places, in increasing order [m].
void add_rectangle(mesh::MeshData<2>& mesh, const std::string& body, const std::vector<double>& x,
                   const std::vector<double>& y, const RectangleSides& sides);

/// A ring, or a sector of one, around a centre, with its boundary on true circles.
struct Ring {
  std::array<double, 2> centre;  ///< [m]
  std::vector<double> radii;     ///< of the circles of nodes, increasing [m]
  std::vector<double> angles;  ///< of the rays of nodes, increasing [rad]; closed if they span 2 pi
  std::string inner, outer;    ///< surface names
  std::string first_end, last_end;  ///< surface names of a sector's ends
};

void add_ring(mesh::MeshData<2>& mesh, const std::string& body, const Ring& ring);

/// The mesh with every x turned into -x.
mesh::MeshData<2> mirrored(mesh::MeshData<2> mesh);

/// The mesh with all lengths multiplied by the factor.
mesh::MeshData<2> enlarged(mesh::MeshData<2> mesh, double factor);

/// Index of a surface. @throws std::out_of_range if there is none of this name
unsigned int surface_id(const mesh::MeshData<2>& mesh, const std::string& name);

}  // namespace geneva::test
