#include "mesh/torus_manifold.h"

#include <cmath>

namespace geneva::mesh {

using dealii::ArrayView;
using dealii::Point;
using dealii::Tensor;

TorusManifold::TorusManifold(const Tensor<1, 3>& axis, const Point<3>& centre,
                             const double ring_radius)
    : axis_(axis), centre_(centre), ring_radius_(ring_radius) {
  const Tensor<1, 3> beside =
      std::abs(axis[0]) < 0.9 ? Tensor<1, 3>({1., 0., 0.}) : Tensor<1, 3>({0., 1., 0.});
  first_ = cross_product_3d(axis_, beside);
  first_ /= first_.norm();
  second_ = cross_product_3d(axis_, first_);
}

std::unique_ptr<dealii::Manifold<3>> TorusManifold::clone() const {
  return std::make_unique<TorusManifold>(axis_, centre_, ring_radius_);
}

std::array<double, 3> TorusManifold::pulled_back(const Point<3>& point) const {
  const Tensor<1, 3> arm = point - centre_;
  const double x = arm * first_;
  const double y = arm * second_;
  const double off_middle = std::hypot(x, y) - ring_radius_;
  const double along = arm * axis_;
  return {std::atan2(y, x), std::atan2(along, off_middle), std::hypot(along, off_middle)};
}

Point<3> TorusManifold::get_new_point(const ArrayView<const Point<3>>& points,
                                      const ArrayView<const double>& weights) const {
  constexpr double turn = 2. * 3.14159265358979323846;
  const std::array<double, 3> start = pulled_back(points[0]);
  std::array<double, 3> mean = start;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const std::array<double, 3> other = pulled_back(points[i]);
    for (std::size_t k = 0; k < 2; ++k)  // the shorter way around
      mean[k] += weights[i] * std::remainder(other[k] - start[k], turn);
    mean[2] += weights[i] * (other[2] - start[2]);
  }
  const auto [around_axis, around_tube, radius] = mean;
  const double off_axis = ring_radius_ + radius * std::cos(around_tube);
  return centre_ + off_axis * (std::cos(around_axis) * first_ + std::sin(around_axis) * second_) +
         radius * std::sin(around_tube) * axis_;
}

}  // namespace geneva::mesh
