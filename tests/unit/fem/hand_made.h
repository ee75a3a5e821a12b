#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "fem/contact/mortar.h"
#include "fem/contact/surface.h"

namespace geneva::fem::test {

inline const double pi = std::acos(-1.);

/// An open boundary curve through the points, in the order that is counter-clockwise around the
/// body: the body is to the left. Dofs of node i are 2 i and 2 i + 1, starting from first_dof.
inline Boundary<2> curve(const std::vector<dealii::Point<2>>& points, const int circle = -1,
                         const unsigned int first_dof = 0) {
  Boundary<2> boundary;
  for (unsigned int i = 0; i < points.size(); ++i)
    boundary.nodes.push_back({points[i], {first_dof + 2 * i, first_dof + 2 * i + 1}, 0});
  for (unsigned int i = 0; i + 1 < points.size(); ++i)
    boundary.faces.push_back({{i, i + 1}, 1, circle});
  return boundary;
}

inline Surface<2> straight_surface(const std::vector<dealii::Point<2>>& points,
                                   const unsigned int first_dof = 0) {
  return make_surface(curve(points, -1, first_dof), 1, points.front());
}

/// The underside of a body at the height given, with nodes at the given x (increasing).
inline Surface<2> underside(const std::vector<double>& x, const double height) {
  std::vector<dealii::Point<2>> points;
  for (const double at : x) points.emplace_back(at, height);
  return straight_surface(points, 1000);
}

/// The upper side of a body along y = slope x, with nodes at the given x (increasing).
inline Surface<2> upper_side(const std::vector<double>& x, const double slope = 0.) {
  std::vector<dealii::Point<2>> points;
  for (auto at = x.rbegin(); at != x.rend(); ++at) points.emplace_back(*at, slope * *at);
  return straight_surface(points);
}

/// An arc through nodes at the given angles: increasing around a body inside the circle, decreasing
/// around a hole.
inline Surface<2> arc(const mesh::Circle& circle, const std::vector<double>& angles) {
  std::vector<dealii::Point<2>> points;
  for (const double angle : angles)
    points.emplace_back(circle.centre[0] + circle.radius * std::cos(angle),
                        circle.centre[1] + circle.radius * std::sin(angle));
  Boundary<2> boundary = curve(points, 0, 1000);
  boundary.circles = {circle};
  return make_surface(boundary, 1, points.front());
}

/// A whole circle with n equal edges, around a body inside it.
inline Surface<2> full_circle(const mesh::Circle& circle, const unsigned int n) {
  Boundary<2> boundary;
  boundary.circles = {circle};
  for (unsigned int i = 0; i < n; ++i) {
    const double angle = 2. * pi * i / n;
    boundary.nodes.push_back({dealii::Point<2>(circle.centre[0] + circle.radius * std::cos(angle),
                                               circle.centre[1] + circle.radius * std::sin(angle)),
                              {2 * i, 2 * i + 1},
                              0});
    boundary.faces.push_back({{i, (i + 1) % n}, 1, 0});
  }
  return make_surface(boundary, 1, boundary.nodes.front().position);
}

/// A measure of 1 everywhere and bodies of the same compliance, unless said otherwise.
inline MortarData<2> plane_data(const double thickness = 1., const double source_share = 0.5) {
  return {[thickness](const dealii::Point<2>&) { return thickness; }, source_share};
}

inline MortarData<2> axisymmetric_data(const double axis = 0.) {
  return {[axis](const dealii::Point<2>& point) { return 2. * pi * (point[0] - axis); }, 0.5};
}

}  // namespace geneva::fem::test
