#include "loads/motion/cubic_spline.h"

#include <Eigen/Sparse>
#include <Eigen/SparseLU>
#include <algorithm>
#include <utility>

#include "base/errors.h"

namespace geneva::loads {

namespace {

double slope(const std::vector<double>& x, const std::vector<double>& y, const std::size_t i) {
  return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
}

/// Second derivatives m from the continuity of the first: h0 m0 + 2 (h0 + h1) m1 + h1 m2 =
/// 6 (s1 - s0), and the not-a-knot conditions at both ends.
std::vector<double> curvatures(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = x.size();
  if (n == 2) return {0., 0.};
  if (n == 3) {
    const double curvature = 2. * (slope(x, y, 1) - slope(x, y, 0)) / (x[2] - x[0]);
    return {curvature, curvature, curvature};
  }
  const auto size = static_cast<Eigen::Index>(n);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  for (Eigen::Index i = 1; i + 1 < size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double before = x[k] - x[k - 1];
    const double after = x[k + 1] - x[k];
    entries.emplace_back(i, i - 1, before);
    entries.emplace_back(i, i, 2. * (before + after));
    entries.emplace_back(i, i + 1, after);
    right(i) = 6. * (slope(x, y, k) - slope(x, y, k - 1));
  }
  const auto not_a_knot = [&](const Eigen::Index row, const Eigen::Index first) {
    const auto k = static_cast<std::size_t>(first);
    const double before = x[k + 1] - x[k];
    const double after = x[k + 2] - x[k + 1];
    entries.emplace_back(row, first, after);
    entries.emplace_back(row, first + 1, -(before + after));
    entries.emplace_back(row, first + 2, before);
  };
  not_a_knot(0, 0);
  not_a_knot(size - 1, size - 3);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
  const Eigen::VectorXd solution = factors.solve(right);
  return {solution.data(), solution.data() + size};
}

}  // namespace

CubicSpline::CubicSpline(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)) {
  const bool increases = std::adjacent_find(x_.begin(), x_.end(), [](double a, double b) {
                           return !(a < b);
                         }) == x_.end();
  if (x_.size() < 2 || x_.size() != y_.size() || !increases)
    throw base::InputError("a spline needs two or more points with increasing abscissas");
  curvature_ = curvatures(x_, y_);
}

Jet CubicSpline::operator()(const double x) const {
  const auto next = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto i = static_cast<std::size_t>(next - x_.begin()) - 1;
  const double width = x_[i + 1] - x_[i];
  const Jet t = variable(x) - x_[i];
  const double third = (curvature_[i + 1] - curvature_[i]) / width;
  const double first = slope(x_, y_, i) - width * (2. * curvature_[i] + curvature_[i + 1]) / 6.;
  return y_[i] + t * (first + t * (curvature_[i] / 2. + third / 6. * t));
}

}  // namespace geneva::loads
