#include "mesh/flat_faces.h"

#include <Eigen/Geometry>

namespace geneva::mesh {

using Eigen::Vector3d;

template <int dim>
Vector3d place_of(const MeshData<dim>& mesh, const unsigned int vertex) {
  Vector3d place = Vector3d::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(dim); ++i)
    place[static_cast<Eigen::Index>(i)] = mesh.vertices[vertex][i];
  return place;
}

template <int dim>
Vector3d flat_normal(const MeshData<dim>& mesh, const Face<dim>& face) {
  if constexpr (dim == 2) {
    const Vector3d along = place_of(mesh, face.vertices[1]) - place_of(mesh, face.vertices[0]);
    return Vector3d(along[1], -along[0], 0.).normalized();
  } else {
    const Vector3d first = place_of(mesh, face.vertices[2]) - place_of(mesh, face.vertices[0]);
    const Vector3d second = place_of(mesh, face.vertices[3]) - place_of(mesh, face.vertices[1]);
    return first.cross(second).normalized();
  }
}

template Vector3d place_of(const MeshData<2>&, unsigned int);
template Vector3d place_of(const MeshData<3>&, unsigned int);
template Vector3d flat_normal(const MeshData<2>&, const Face<2>&);
template Vector3d flat_normal(const MeshData<3>&, const Face<3>&);

}  // namespace geneva::mesh
