#include "mesh/round_shapes.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/dense_algebra.h"
#include "mesh/torus_through.h"

namespace geneva::mesh {

namespace {

using Eigen::Vector3d;

/// Points of a round shape agree with it to this fraction of its radius.
constexpr double exactly = 1e-8;
/// A nearly round shape is this many times as far off a straight line or plane.
constexpr double times_rounder = 10.;
/// Fewer points could lie on a shape by chance.
constexpr std::size_t fewest_on_circle = 5;
constexpr std::size_t fewest_on_surface = 10;
/// Points within this fraction of their extent off a plane lie in it.
constexpr double flatness = 1e-9;

Vector3d vector_of(const Place& place) { return {place[0], place[1], place[2]}; }
Place place_of(const Vector3d& vector) { return {vector[0], vector[1], vector[2]}; }

/// The circle through three points; nothing if they lie in a line.
std::optional<Circle> circle_of(const Place& a, const Place& b, const Place& c) {
  const double bx = b[0] - a[0];
  const double by = b[1] - a[1];
  const double cx = c[0] - a[0];
  const double cy = c[1] - a[1];
  const double cross = 2. * (bx * cy - by * cx);
  const double lengths = std::max(std::hypot(bx, by), std::hypot(cx, cy));
  if (!(std::abs(cross) > exactly * lengths * lengths)) return std::nullopt;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double x = (cy * b2 - by * c2) / cross;
  const double y = (bx * c2 - cx * b2) / cross;
  return Circle{{a[0] + x, a[1] + y}, std::hypot(x, y)};
}

/// Maximum distance of a point from a shape.
double farthest_off(const Circle& circle, const std::vector<Place>& points) {
  double farthest = 0.;
  for (const Place& point : points) {
    const auto [x, y, z] = radial(circle, point);
    farthest = std::max(farthest, std::abs(std::hypot(x, y, z) - circle.radius));
  }
  return farthest;
}

/// The points from their mean, one in each row.
Eigen::MatrixX3d centred(const std::vector<Place>& points, Vector3d& mean) {
  Eigen::MatrixX3d rows(static_cast<Eigen::Index>(points.size()), 3);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    rows.row(i) = vector_of(points[static_cast<std::size_t>(i)]);
  mean = rows.colwise().mean();
  rows.rowwise() -= mean.transpose();
  return rows;
}

/// Direction in which vectors have the minimum components.
Vector3d minimum_direction(const Eigen::MatrixX3d& rows) {
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  for (const auto& row : rows.rowwise()) gram += row.transpose() * row;
  return symmetric_eigenpairs(gram).vectors.col(0);
}

/// |x|^2 = 2 c x + (R^2 - c^2), linear in c and the last term.
Circle fitted_sphere(const Eigen::MatrixX3d& rows, const Vector3d& mean) {
  Eigen::MatrixX4d matrix(rows.rows(), 4);
  matrix << 2. * rows, Eigen::VectorXd::Ones(rows.rows());
  const Eigen::Vector4d solution = least_squares(matrix, rows.rowwise().squaredNorm());
  const Vector3d centre = solution.head<3>();
  return {place_of(mean + centre),
          std::sqrt(std::max(0., solution[3] + centre.squaredNorm())),
          {0., 0., 0.}};
}

/// Two unit vectors normal to a unit vector and to each other.
Eigen::Matrix<double, 3, 2> across(const Vector3d& axis) {
  Eigen::Matrix<double, 3, 2> pair;
  pair.col(0) = axis.unitOrthogonal();
  pair.col(1) = axis.cross(pair.col(0));
  return pair;
}

/// Gauss and Newton's method for the distances from the axis, from a circle through the points'
/// projections.
Circle fitted_cylinder(const Eigen::MatrixX3d& rows, const Vector3d& mean, Vector3d axis) {
  Eigen::Matrix<double, 3, 2> pair = across(axis);
  Eigen::MatrixX3d matrix(rows.rows(), 3);
  const Eigen::MatrixX2d plane = rows * pair;
  matrix << 2. * plane, Eigen::VectorXd::Ones(rows.rows());
  const Vector3d start = least_squares(matrix, plane.rowwise().squaredNorm());
  Vector3d centre = pair * start.head<2>();
  double radius = std::sqrt(std::max(0., start[2] + start.head<2>().squaredNorm()));
  for (int step = 0; step < 50; ++step) {
    pair = across(axis);
    Eigen::Matrix<double, Eigen::Dynamic, 5> jacobian(rows.rows(), 5);
    Eigen::VectorXd residual(rows.rows());
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const Vector3d arm = rows.row(i).transpose() - centre;
      const double along = arm.dot(axis);
      const Vector3d outwards = arm - along * axis;
      const double distance = outwards.norm();
      residual[i] = distance - radius;
      jacobian.row(i) << -(pair.transpose() * outwards).transpose() / distance,
          -along * (pair.transpose() * outwards).transpose() / distance, -1.;
    }
    const Eigen::Matrix<double, 5, 1> change = least_squares(jacobian, -residual);
    centre += pair * change.head<2>();
    axis = (axis + pair * change.segment<2>(2)).normalized();
    radius += change[4];
    if (change.head<2>().norm() + std::abs(change[4]) <= 1e-15 * radius) break;
  }
  Eigen::Index leading = 0;
  axis.cwiseAbs().maxCoeff(&leading);
  if (axis[leading] < 0.) axis = -axis;
  centre += mean;
  return {place_of(centre - centre.dot(axis) * axis), radius, place_of(axis)};
}

/// The direction normal to all normals of a cylinder.
Vector3d axis_across(const std::vector<SurfaceNormal>& normals) {
  Eigen::MatrixX3d directions(static_cast<Eigen::Index>(normals.size()), 3);
  for (Eigen::Index i = 0; i < directions.rows(); ++i)
    directions.row(i) = vector_of(normals[static_cast<std::size_t>(i)].direction);
  return minimum_direction(directions);
}

/// Gauss and Newton's method for the distances from a circle, from the one linear in its squares.
std::optional<Circle> fitted_circle(const Eigen::MatrixX2d& rows, const Vector3d& mean) {
  Eigen::MatrixX3d matrix(rows.rows(), 3);
  matrix << 2. * rows, Eigen::VectorXd::Ones(rows.rows());
  const Vector3d start = least_squares(matrix, rows.rowwise().squaredNorm());
  Eigen::Vector2d centre = start.head<2>();
  double radius = std::sqrt(std::max(0., start[2] + centre.squaredNorm()));
  for (int step = 0; step < 50; ++step) {
    const Eigen::MatrixX2d arms = rows.rowwise() - centre.transpose();
    const Eigen::VectorXd distances = arms.rowwise().norm();
    if (!(distances.minCoeff() > 0.)) return std::nullopt;
    matrix << -(arms.array().colwise() / distances.array()).matrix(),
        -Eigen::VectorXd::Ones(rows.rows());
    const Vector3d change = least_squares(matrix, (radius - distances.array()).matrix());
    centre += change.head<2>();
    radius += change[2];
    if (change.norm() <= 1e-15 * radius) break;
  }
  return Circle{{mean[0] + centre[0], mean[1] + centre[1]}, radius};
}

/// The shape if the points are near enough to it.
/// @param off_flat their maximum distance from a line or plane
std::optional<Circle> if_round(const Circle& circle, const std::vector<Place>& points,
                               const double tolerance, const double off_flat) {
  const double off = farthest_off(circle, points);
  const bool is_round = off <= tolerance * circle.radius && times_rounder * off <= off_flat;
  return is_round ? std::optional(circle) : std::nullopt;
}

}  // namespace

std::optional<Circle> circle_through(const std::vector<Place>& points) {
  if (points.size() < fewest_on_circle) return std::nullopt;
  const auto off = [](const Place& a, const Place& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  };
  // three points far from each other make the result least sensitive to rounding
  const Place& a = points.front();
  const Place& b = *std::max_element(points.begin(), points.end(),
                                     [&](auto& p, auto& q) { return off(p, a) < off(q, a); });
  const Place& c = *std::max_element(points.begin(), points.end(), [&](auto& p, auto& q) {
    return std::min(off(p, a), off(p, b)) < std::min(off(q, a), off(q, b));
  });
  const std::optional<Circle> circle = circle_of(a, b, c);
  return circle && all_on(*circle, points, exactly) ? circle : std::nullopt;
}

std::optional<Circle> round_surface_through(const std::vector<Place>& points,
                                            const std::vector<SurfaceNormal>& normals,
                                            const MayBe may_be) {
  if (points.size() < fewest_on_surface) return std::nullopt;
  Vector3d mean;
  const Eigen::MatrixX3d rows = centred(points, mean);
  const Vector3d off_plane = minimum_direction(rows);
  if ((rows * off_plane).norm() <= flatness * rows.norm()) return std::nullopt;
  const Circle sphere = fitted_sphere(rows, mean);
  if (may_be == MayBe::any_shape && all_on(sphere, points, exactly)) return sphere;
  const Circle cylinder = fitted_cylinder(rows, mean, axis_across(normals));
  if (all_on(cylinder, points, exactly)) return cylinder;
  return torus_through(points, normals);
}

bool all_on(const Circle& circle, const std::vector<Place>& points, const double tolerance) {
  return farthest_off(circle, points) <= tolerance * circle.radius;
}

std::optional<Circle> circle_near(const std::vector<Place>& points, const double tolerance) {
  if (points.size() < fewest_on_circle) return std::nullopt;
  Vector3d mean;
  const Eigen::MatrixX3d rows = centred(points, mean);
  const Eigen::MatrixX2d plane = rows.leftCols<2>();
  const Eigen::MatrixXd directions = symmetric_eigenpairs(plane.transpose() * plane).vectors;
  const double off_line = (plane * directions.col(0)).cwiseAbs().maxCoeff();
  const std::optional<Circle> circle = fitted_circle(plane, mean);
  return circle ? if_round(*circle, points, tolerance, off_line) : std::nullopt;
}

std::optional<Circle> round_surface_near(const std::vector<Place>& points,
                                         const std::vector<SurfaceNormal>& normals,
                                         const double tolerance, const MayBe may_be) {
  if (points.size() < fewest_on_surface) return std::nullopt;
  Vector3d mean;
  const Eigen::MatrixX3d rows = centred(points, mean);
  const double off_plane = (rows * minimum_direction(rows)).cwiseAbs().maxCoeff();
  if (off_plane <= flatness * rows.norm()) return std::nullopt;
  const Circle sphere = fitted_sphere(rows, mean);
  const Circle cylinder = fitted_cylinder(rows, mean, axis_across(normals));
  const bool is_cylinder =
      may_be == MayBe::no_sphere || farthest_off(cylinder, points) <= farthest_off(sphere, points);
  return if_round(is_cylinder ? cylinder : sphere, points, tolerance, off_plane);
}

}  // namespace geneva::mesh
