#include "mesh/onto_circles.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "base/errors.h"
#include "mesh/dense_algebra.h"
#include "mesh/flat_faces.h"

namespace geneva::mesh {

namespace {

using Eigen::Vector3d;

/// A flat face nearly along the circle does not say where on it the vertex is.
constexpr double too_parallel = 0.9;
/// Normals whose part across the others is less are the same plane's.
constexpr double another_plane = 0.1;
constexpr double on_circle = 1e-11;  // of the radius, before the last step

/// What a vertex has to keep: the circles it lies on, and planes through it.
struct Bounds {
  std::set<int> circles;
  std::vector<Vector3d> normals;  ///< of flat faces
};

/// Bounds of the vertices of some circles' faces.
template <int dim>
std::map<unsigned int, Bounds> bounds_of(const MeshData<dim>& mesh, const std::set<int>& circles) {
  std::map<unsigned int, Bounds> bounds;
  for (const Face<dim>& face : mesh.faces)
    if (circles.count(face.circle) > 0)
      for (const unsigned int vertex : face.vertices) bounds[vertex];
  for (const Face<dim>& face : mesh.faces)
    for (const unsigned int vertex : face.vertices) {
      const auto found = bounds.find(vertex);
      if (found == bounds.end()) continue;
      if (face.circle >= 0)
        found->second.circles.insert(face.circle);
      else
        found->second.normals.push_back(flat_normal(mesh, face));
    }
  return bounds;
}

/// From the circle's axis or centre to a place.
Vector3d arm_to(const Circle& circle, const Vector3d& place) {
  const auto [x, y, z] = radial(circle, {place[0], place[1], place[2]});
  return {x, y, z};
}

/// The bounds' gradients at a place, one in each row: circles first, then the planes that are not
/// along them.
template <int dim>
Eigen::MatrixXd gradients(const MeshData<dim>& mesh, const Bounds& bounds, const Vector3d& place) {
  std::vector<Vector3d> rows;
  for (const int circle : bounds.circles)
    rows.push_back(arm_to(mesh.circles[static_cast<std::size_t>(circle)], place).normalized());
  const std::size_t n_circles = rows.size();
  for (const Vector3d& normal : bounds.normals) {
    bool is_kept = rows.size() < static_cast<std::size_t>(dim);
    Vector3d left = normal;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i < n_circles && std::abs(normal.dot(rows[i])) > too_parallel) is_kept = false;
      left -= left.dot(rows[i]) * rows[i];
    }
    if (is_kept && left.norm() > another_plane) rows.push_back(normal);
  }
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = rows[i];
  return matrix;
}

/// Where a torus touches a plane across its axis or a cylinder about it along a circle, the place
/// on that circle nearest to a vertex of both; Newton's method is slow at such a double root, and
/// the shortest way onto the torus leads off the plane.
template <int dim>
std::optional<Vector3d> on_touching_circle(const MeshData<dim>& mesh, const Bounds& bounds,
                                           const Vector3d& place) {
  constexpr double same = 1e-6;
  const auto circle_at = [&](const int index) -> const Circle& {
    return mesh.circles[static_cast<std::size_t>(index)];
  };
  for (const int index : bounds.circles) {
    const Circle& torus = circle_at(index);
    if (torus.ring_radius == 0.) continue;
    const Vector3d centre(torus.centre.data());
    const Vector3d axis(torus.axis.data());
    const double along = (place - centre).dot(axis);
    const Vector3d outwards = (place - centre - along * axis).normalized();
    const auto on_it = [&](const double off_axis, const double height) {
      return Vector3d(centre + off_axis * outwards + height * axis);
    };
    for (const Vector3d& normal : bounds.normals)
      if (std::abs(normal.dot(axis)) > 1. - same &&
          std::abs(std::abs(along) - torus.radius) < same * torus.radius)
        return on_it(torus.ring_radius, std::copysign(torus.radius, along));
    for (const int other : bounds.circles) {
      const Circle& cylinder = circle_at(other);
      const Vector3d other_axis(cylinder.axis.data());
      const double off = std::abs(std::abs(cylinder.radius - torus.ring_radius) - torus.radius);
      if (cylinder.ring_radius == 0. && std::abs(other_axis.dot(axis)) > 1. - same &&
          arm_to(cylinder, centre).norm() < same * torus.radius && off < same * torus.radius)
        return on_it(cylinder.radius, 0.);
    }
  }
  return std::nullopt;
}

/// Newton's method by the shortest steps. The planes stay as they are: a step has no part across
/// them.
template <int dim>
Vector3d moved(const MeshData<dim>& mesh, const Bounds& bounds, Vector3d place) {
  constexpr double minimum_reciprocal_condition = 1e-6;
  if (const auto touching = on_touching_circle(mesh, bounds, place)) return *touching;
  const Eigen::MatrixXd start = gradients(mesh, bounds, place);
  for (int step = 0; step < 50; ++step) {
    Eigen::MatrixXd matrix = start;
    Eigen::VectorXd off = Eigen::VectorXd::Zero(matrix.rows());
    Eigen::Index row = 0;
    double farthest = 0.;
    for (const int index : bounds.circles) {
      const Circle& circle = mesh.circles[static_cast<std::size_t>(index)];
      const Vector3d arm = arm_to(circle, place);
      matrix.row(row) = arm.normalized();
      off[row] = circle.radius - arm.norm();
      farthest = std::max(farthest, std::abs(off[row++]) / circle.radius);
    }
    const auto inverted = inverse(matrix * matrix.transpose(), minimum_reciprocal_condition);
    if (inverted && inverted->allFinite()) place += matrix.transpose() * (*inverted * off);
    if (farthest <= on_circle) return place;
  }
  throw base::InputError(fmt::format(
      "the vertex at ({:.6g}, {:.6g}, {:.6g}) belongs to two round shapes that do not meet near to "
      "it: give a smaller 'Circle tolerance', or draw them more exactly",
      place[0], place[1], place[2]));
}

}  // namespace

template <int dim>
void move_onto_circles(MeshData<dim>& mesh, const std::set<int>& circles) {
  if (circles.empty()) return;
  std::map<unsigned int, Vector3d> places;
  for (const auto& [vertex, bounds] : bounds_of(mesh, circles))
    places[vertex] = moved(mesh, bounds, place_of(mesh, vertex));
  for (const auto& [vertex, place] : places)
    for (std::size_t i = 0; i < static_cast<std::size_t>(dim); ++i)
      mesh.vertices[vertex][i] = place[static_cast<Eigen::Index>(i)];
}

template void move_onto_circles(MeshData<2>&, const std::set<int>&);
template void move_onto_circles(MeshData<3>&, const std::set<int>&);

}  // namespace geneva::mesh
