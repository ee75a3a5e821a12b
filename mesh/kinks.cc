#include "mesh/kinks.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "mesh/flat_faces.h"

namespace geneva::mesh {

namespace {

constexpr double degree = 3.14159265358979323846 / 180.;
constexpr double minimum_kink = 0.01 * degree;
/// An arc is divided into eight parts a turn at least.
constexpr double maximum_of_polygons = 46. * degree;

using Eigen::Vector3d;

/// What neighbours have in common: the vertices of an edge, in the plane a vertex, in ascending
/// order.
using Joint = std::pair<unsigned int, unsigned int>;

std::vector<Joint> joints_of(const Face<2>& face) {
  return {{face.vertices[0], face.vertices[0]}, {face.vertices[1], face.vertices[1]}};
}
std::vector<Joint> joints_of(const Face<3>& face) {
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < 4; ++i)
    joints.emplace_back(std::minmax(face.vertices[i], face.vertices[(i + 1) % 4]));
  return joints;
}

}  // namespace

template <int dim>
double maximum_kink(const MeshData<dim>& mesh, const std::string& surface) {
  double maximum = 0.;
  std::map<Joint, Vector3d> normal_at;
  for (const Face<dim>& face : mesh.faces) {
    if (mesh.surfaces[face.surface] != surface || face.circle >= 0) continue;
    const Vector3d normal = flat_normal(mesh, face);
    for (const Joint& joint : joints_of(face)) {
      const auto [neighbour, is_new] = normal_at.emplace(joint, normal);
      if (is_new) continue;
      const Vector3d& other = neighbour->second;
      const double kink = std::atan2(normal.cross(other).norm(), normal.dot(other));
      if (kink > minimum_kink && kink < maximum_of_polygons) maximum = std::max(maximum, kink);
    }
  }
  return maximum;
}

template double maximum_kink(const MeshData<2>&, const std::string&);
template double maximum_kink(const MeshData<3>&, const std::string&);

}  // namespace geneva::mesh
