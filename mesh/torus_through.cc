#include "mesh/torus_through.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/dense_algebra.h"

namespace geneva::mesh {

namespace {

using Eigen::Vector3d;

Vector3d vector_at(const Place& place) { return {place[0], place[1], place[2]}; }

/// A torus about the origin of its own.
struct Torus {
  Vector3d centre;
  Vector3d axis;
  double ring_radius;
  double radius;
};

/// A line through a point.
struct Axis {
  Vector3d point;
  Vector3d direction;
};

/// Places and directions from a point, in units of a length.
struct Scale {
  Vector3d origin;
  double length;

  [[nodiscard]] Vector3d operator()(const Place& place) const {
    return (vector_at(place) - origin) / length;
  }
};

Scale scale_of(const std::vector<Place>& points) {
  Scale scale{Vector3d::Zero(), 0.};
  for (const Place& point : points)
    scale.origin += vector_at(point) / static_cast<double>(points.size());
  for (const Place& point : points)
    scale.length = std::max(scale.length, (vector_at(point) - scale.origin).norm());
  return scale;
}

/// The lines that the lines of the normals come nearest to, the nearest first.
std::vector<Axis> axes_that_normals_meet(const std::vector<SurfaceNormal>& normals,
                                         const Scale& scale) {
  constexpr double no_axis = 1e-3;
  constexpr Eigen::Index most = 3;
  Eigen::Matrix<double, 6, 6> gram = Eigen::Matrix<double, 6, 6>::Zero();
  for (const SurfaceNormal& normal : normals) {
    const Vector3d n = vector_at(normal.direction).normalized();
    Eigen::Matrix<double, 6, 1> row;
    row << n, scale(normal.at).cross(n);
    gram += row * row.transpose();
  }
  const Eigen::MatrixXd lines = symmetric_eigenpairs(gram).vectors;
  std::vector<Axis> axes;
  for (Eigen::Index i = 0; i < most; ++i) {
    const Vector3d moment = lines.col(i).head<3>();
    const Vector3d direction = lines.col(i).tail<3>();
    const double length = direction.norm();
    if (length > no_axis)
      axes.push_back({direction.cross(moment) / (length * length), direction / length});
  }
  return axes;
}

/// From an axis, by the circle through the points' distances from it and places along it.
std::optional<Torus> start(const std::vector<Vector3d>& points, const Axis& axis) {
  Eigen::MatrixX3d matrix(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd squares(matrix.rows());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Vector3d arm = points[static_cast<std::size_t>(i)] - axis.point;
    const double along = arm.dot(axis.direction);
    const double off = (arm - along * axis.direction).norm();
    matrix.row(i) << 2. * off, 2. * along, 1.;
    squares[i] = off * off + along * along;
  }
  const Vector3d circle = least_squares(matrix, squares);
  const double square = circle[2] + circle[0] * circle[0] + circle[1] * circle[1];
  if (!(square > 0. && circle[0] > 0.)) return std::nullopt;
  return Torus{axis.point + circle[1] * axis.direction, axis.direction, circle[0],
               std::sqrt(square)};
}

/// Distances of the points from the torus, and what they change by with its centre (3), the turns
/// of its axis (2), and its radii (2).
void linearise(const std::vector<Vector3d>& points, const Torus& torus,
               const Eigen::Matrix<double, 3, 2>& turns, Eigen::VectorXd& distances,
               Eigen::MatrixXd& jacobian) {
  for (Eigen::Index i = 0; i < distances.size(); ++i) {
    const Vector3d arm = points[static_cast<std::size_t>(i)] - torus.centre;
    const Vector3d off_axis = arm - arm.dot(torus.axis) * torus.axis;
    const Vector3d outwards =
        off_axis.norm() > 0. ? Vector3d(off_axis.normalized()) : Vector3d(turns.col(0));
    const Vector3d middle = torus.ring_radius * outwards;  // of the tube
    const double distance = (arm - middle).norm();
    const Vector3d normal = (arm - middle) / distance;
    distances[i] = distance - torus.radius;
    jacobian.row(i) << -normal.transpose(),
        -(torus.axis.cross(turns.col(0))).dot(middle.cross(normal)),
        -(torus.axis.cross(turns.col(1))).dot(middle.cross(normal)), -normal.dot(outwards), -1.;
  }
}

Torus nearest(const std::vector<Vector3d>& points, Torus torus) {
  constexpr int most_steps = 30;
  constexpr double settled = 1e-15;
  Eigen::VectorXd distances(static_cast<Eigen::Index>(points.size()));
  Eigen::MatrixXd jacobian(distances.size(), 7);
  for (int step = 0; step < most_steps; ++step) {
    Eigen::Matrix<double, 3, 2> turns;
    turns.col(0) = torus.axis.unitOrthogonal();
    turns.col(1) = torus.axis.cross(turns.col(0));
    linearise(points, torus, turns, distances, jacobian);
    const Eigen::VectorXd change = least_squares(jacobian, -distances);
    torus.centre += change.head<3>();
    torus.axis = (torus.axis + turns * change.segment<2>(3)).normalized();
    torus.ring_radius += change[5];
    torus.radius += change[6];
    if (change.norm() <= settled) break;
  }
  return torus;
}

/// Numbers of different angles of the points around the axis and around the tube.
struct DifferentAngles {
  std::size_t around_axis;
  std::size_t around_tube;
};

DifferentAngles different_angles(const std::vector<Vector3d>& points, const Torus& torus) {
  const Vector3d first = torus.axis.unitOrthogonal();
  const Vector3d second = torus.axis.cross(first);
  std::vector<double> around_axis;
  std::vector<double> around_tube;
  for (const Vector3d& point : points) {
    const Vector3d arm = point - torus.centre;
    const double x = arm.dot(first);
    const double y = arm.dot(second);
    around_axis.push_back(std::atan2(y, x));
    around_tube.push_back(std::atan2(arm.dot(torus.axis), std::hypot(x, y) - torus.ring_radius));
  }
  const auto different = [](std::vector<double>& angles) {
    constexpr double share = 1e-4;  // of their range
    constexpr double turn = 2. * 3.14159265358979323846;
    std::sort(angles.begin(), angles.end());
    const double apart = share * (angles.back() - angles.front());
    std::size_t number = 1;
    for (std::size_t i = 1; i < angles.size(); ++i)
      if (angles[i] - angles[i - 1] > apart) ++number;
    if (number > 1 && angles.front() + turn - angles.back() <= apart) --number;
    return number;
  };
  return {different(around_axis), different(around_tube)};
}

/// Through three rings of nodes there is always a torus.
bool is_determined(const std::vector<Vector3d>& points, const Torus& torus) {
  constexpr std::size_t fewest_around_axis = 3;
  constexpr std::size_t fewest_around_tube = 5;
  const DifferentAngles angles = different_angles(points, torus);
  return angles.around_axis >= fewest_around_axis && angles.around_tube >= fewest_around_tube;
}

/// Whether the points lie on it to a share of their own extent, which is 1, and of the tube.
bool has_all(const std::vector<Vector3d>& points, const Torus& torus) {
  const double rounding = std::min(1e-8, 1e-7 * torus.radius);
  return std::all_of(points.begin(), points.end(), [&](const Vector3d& point) {
    const Vector3d arm = point - torus.centre;
    const double along = arm.dot(torus.axis);
    const double off_middle = (arm - along * torus.axis).norm() - torus.ring_radius;
    return std::abs(std::hypot(along, off_middle) - torus.radius) <= rounding;
  });
}

/// A tube that is much wider than the points are apart is no tube to them.
bool is_possible(const Torus& torus) {
  constexpr double widest = 1e5;
  return torus.radius > 0. && torus.ring_radius > 0. && torus.radius < widest &&
         torus.ring_radius < widest;
}

Circle circle_of(const Torus& torus, const Scale& scale) {
  Eigen::Index leading = 0;
  torus.axis.cwiseAbs().maxCoeff(&leading);
  const Vector3d axis = torus.axis[leading] < 0. ? Vector3d(-torus.axis) : torus.axis;
  const Vector3d centre = scale.origin + scale.length * torus.centre;
  return {{centre[0], centre[1], centre[2]},
          scale.length * torus.radius,
          {axis[0], axis[1], axis[2]},
          scale.length * torus.ring_radius};
}

}  // namespace

std::optional<Circle> torus_through(const std::vector<Place>& points,
                                    const std::vector<SurfaceNormal>& normals) {
  constexpr std::size_t fewest_normals = 6;
  if (normals.size() < fewest_normals) return std::nullopt;
  const Scale scale = scale_of(points);
  std::vector<Vector3d> scaled;
  for (const Place& point : points) scaled.push_back(scale(point));
  for (const Axis& axis : axes_that_normals_meet(normals, scale)) {
    const std::optional<Torus> rough = start(scaled, axis);
    if (!rough) continue;
    const Torus torus = nearest(scaled, *rough);
    if (is_possible(torus) && has_all(scaled, torus) && is_determined(scaled, torus))
      return circle_of(torus, scale);
  }
  return std::nullopt;
}

}  // namespace geneva::mesh
