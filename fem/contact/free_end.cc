#include "fem/contact/free_end.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/dense_algebra.h"

namespace geneva::fem {

namespace {

/// Least-squares parabola c0 + c1 x + c2 x^2 through points (x, q), x scaled to about 1 by the
/// caller.
Eigen::Vector3d fitted_parabola(const std::vector<std::pair<double, double>>& points) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd values(matrix.rows());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const auto& [x, q] = points[static_cast<std::size_t>(i)];
    matrix.row(i) << 1., x, x * x;
    values(i) = q;
  }
  return mesh::least_squares(matrix, values);
}

}  // namespace

double shift_by_last_node(const double relative_pressure) {
  constexpr double of_closing_node = 0.825;
  return std::clamp(0.5 - relative_pressure / of_closing_node, -0.5, 0.5);
}

std::optional<FreeEnd> free_end(const std::vector<ContactNode<2>>& nodes, const std::size_t edge,
                                const int inwards, const std::size_t count) {
  constexpr double beyond_last_node = 0.19;
  const auto edge_node = nodes.begin() + static_cast<std::ptrdiff_t>(edge);
  const auto node = [&](const int steps) -> const ContactNode<2>& {
    return edge_node[static_cast<std::ptrdiff_t>(inwards) * steps];
  };
  const auto distance = [&](const int steps) {
    return std::abs(node(steps).arc_length - node(0).arc_length);
  };
  const int half = static_cast<int>(count) / 2;
  if (half < 4) return std::nullopt;
  const double reach = distance(half);
  std::vector<std::pair<double, double>> points;
  for (int i = 1; i <= half; ++i)
    points.emplace_back(distance(i) / reach, node(i).pressure * node(i).pressure);
  const Eigen::Vector3d c = fitted_parabola(points);
  const double discriminant = c(1) * c(1) - 4. * c(0) * c(2);
  if (c(1) <= 0. || discriminant <= 0.) return std::nullopt;
  const double length = distance(-1);
  const double outwards = 2. * c(0) / (c(1) + std::sqrt(discriminant)) * reach;
  const double square = std::sqrt(discriminant) / reach * length;  // K^2 h
  const double shift = shift_by_last_node(node(0).pressure / std::sqrt(square));
  return FreeEnd{outwards / length, beyond_last_node - shift, shift};
}

}  // namespace geneva::fem
