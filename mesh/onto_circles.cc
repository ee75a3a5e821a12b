#include "mesh/onto_circles.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
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

/// How far a place is from a shape, and the shape's normal there.
struct Distance {
  double off;
  Vector3d normal;
};

Distance distance_from(const Circle& circle, const Vector3d& place) {
  const Vector3d arm = arm_to(circle, place);
  return {arm.norm() - circle.radius, arm.normalized()};
}

/// All shapes that a vertex is to lie on: its circles first, then planes through where it was.
struct Shapes {
  std::vector<Circle> circles;
  std::vector<Vector3d> normals;
  Vector3d on_planes;

  [[nodiscard]] std::vector<Distance> operator()(const Vector3d& place) const {
    std::vector<Distance> distances;
    for (const Circle& circle : circles) distances.push_back(distance_from(circle, place));
    for (const Vector3d& normal : normals)
      distances.push_back({normal.dot(place - on_planes), normal});
    return distances;
  }

  /// Pairs that may touch along a curve, which a vertex between two others misses: two circles, or
  /// a torus and a plane. The line along which a plane touches a cylinder is straight.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> that_may_touch(
      const Vector3d& place) const {
    constexpr double nearly_parallel = 0.8;
    const std::vector<Distance> distances = (*this)(place);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < circles.size(); ++i)
      for (std::size_t k = i + 1; k < distances.size(); ++k)
        if ((k < circles.size() || circles[i].ring_radius > 0.) &&
            std::abs(distances[i].normal.dot(distances[k].normal)) > nearly_parallel)
          pairs.emplace_back(i, k);
    return pairs;
  }
};

/// The place next to a vertex where shapes touch: their distances and the cross products of the
/// normals of those that touch are 0 (Levenberg and Marquardt's method). Distances alone have a
/// double root there, and the shortest way onto one shape leads off the other.
/// @return nothing if none do
std::optional<Vector3d> where_they_touch(const Shapes& shapes, const Vector3d& start) {
  constexpr double touching = 1e-10;  // of the minimum radius
  constexpr double damping = 1e-9;
  constexpr double difference = 1e-6;
  constexpr int most_steps = 60;
  const auto pairs = shapes.that_may_touch(start);
  if (pairs.empty()) return std::nullopt;
  double radius = std::numeric_limits<double>::max();
  for (const Circle& circle : shapes.circles) radius = std::min(radius, circle.radius);
  const auto residual = [&](const Vector3d& place) {
    const std::vector<Distance> distances = shapes(place);
    Eigen::VectorXd all(static_cast<Eigen::Index>(distances.size() + 3 * pairs.size()));
    Eigen::Index row = 0;
    for (const Distance& distance : distances) all[row++] = distance.off / radius;
    for (const auto& [one, other] : pairs) {
      all.segment<3>(row) = distances[one].normal.cross(distances[other].normal);
      row += 3;
    }
    return all;
  };
  Vector3d place = start;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::VectorXd off = residual(place);
    if (off.norm() <= touching) return place;
    Eigen::MatrixX3d jacobian(off.size(), 3);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Vector3d change = difference * radius * Vector3d::Unit(i);
      jacobian.col(i) = (residual(place + change) - residual(place - change)) / (2. * difference);
    }
    Eigen::Matrix3d matrix = jacobian.transpose() * jacobian;
    matrix.diagonal().array() += damping * matrix.trace();
    const auto inverted = inverse(matrix, 0.);
    if (!inverted) return std::nullopt;
    place -= radius * (*inverted * (jacobian.transpose() * off));
    if (!place.allFinite() || (place - start).norm() > radius) return std::nullopt;
  }
  return std::nullopt;
}

template <int dim>
Shapes shapes_of(const MeshData<dim>& mesh, const Bounds& bounds, const Vector3d& place) {
  Shapes shapes{{}, {}, place};
  for (const int circle : bounds.circles)
    shapes.circles.push_back(mesh.circles[static_cast<std::size_t>(circle)]);
  for (const Vector3d& normal : bounds.normals)
    if (std::none_of(shapes.normals.begin(), shapes.normals.end(), [&](const Vector3d& other) {
          return normal.cross(other).norm() < another_plane;
        }))
      shapes.normals.push_back(normal);
  return shapes;
}

/// Newton's method by the shortest steps. The planes stay as they are: a step has no part across
/// them.
/// @return nothing if the circles do not meet near to the place
template <int dim>
std::optional<Vector3d> moved(const MeshData<dim>& mesh, const Bounds& bounds, Vector3d place) {
  constexpr double minimum_reciprocal_condition = 1e-6;
  if (dim == 3)
    if (const auto touching = where_they_touch(shapes_of(mesh, bounds, place), place))
      return *touching;
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
  return std::nullopt;
}

}  // namespace

template <int dim>
bool flatten_tori(MeshData<dim>& mesh, const std::set<int>& circles) {
  const auto is_torus = [&](const int circle) {
    return circles.count(circle) > 0 &&
           mesh.circles[static_cast<std::size_t>(circle)].ring_radius > 0.;
  };
  bool were_any = false;
  for (Face<dim>& face : mesh.faces) {
    if (face.circle < 0 || !is_torus(face.circle)) continue;
    face.circle = -1;
    were_any = true;
  }
  return were_any;
}

template <int dim>
void move_onto_circles(MeshData<dim>& mesh, const std::set<int>& circles) {
  if (circles.empty()) return;
  std::map<unsigned int, Vector3d> places;
  for (const auto& [vertex, bounds] : bounds_of(mesh, circles)) {
    const Vector3d before = place_of(mesh, vertex);
    const auto place = moved(mesh, bounds, before);
    if (!place && flatten_tori(mesh, bounds.circles)) return move_onto_circles(mesh, circles);
    if (!place)
      throw base::InputError(fmt::format(
          "the vertex at ({:.6g}, {:.6g}, {:.6g}) belongs to two round shapes that do not meet "
          "near to it: give a smaller 'Circle tolerance', or draw them more exactly",
          before[0], before[1], before[2]));
    places[vertex] = *place;
  }
  for (const auto& [vertex, place] : places)
    for (std::size_t i = 0; i < static_cast<std::size_t>(dim); ++i)
      mesh.vertices[vertex][i] = place[static_cast<Eigen::Index>(i)];
}

template bool flatten_tori(MeshData<2>&, const std::set<int>&);
template bool flatten_tori(MeshData<3>&, const std::set<int>&);
template void move_onto_circles(MeshData<2>&, const std::set<int>&);
template void move_onto_circles(MeshData<3>&, const std::set<int>&);

}  // namespace geneva::mesh
