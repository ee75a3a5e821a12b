#pragma once

#include <vector>

#include "loads/motion/jet.h"

namespace geneva::loads {

/// Cubic spline through points (x, y) with continuous second derivative; the third derivative is
/// the same on the first two and on the last two intervals ("not-a-knot": C. de Boor, A Practical
/// Guide to Splines, chapter IV), so that a table of a cubic gives that cubic. Three points give a
/// parabola, two a line.
class CubicSpline {
 public:
  /// @param x increasing; two or more
  /// @throws base::InputError unless x increases and both have the same length of two or more
  CubicSpline(std::vector<double> x, std::vector<double> y);

  /// Value and derivatives at a place between the first and the last x; beyond, the last cubic goes
  /// on.
  [[nodiscard]] Jet operator()(double x) const;
  [[nodiscard]] const std::vector<double>& x() const { return x_; }
  [[nodiscard]] const std::vector<double>& y() const { return y_; }

 private:
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> curvature_;  ///< second derivatives at x
};

}  // namespace geneva::loads
