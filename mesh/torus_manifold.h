#pragma once

#include <deal.II/grid/manifold.h>

#include <array>
#include <memory>

namespace geneva::mesh {

/// A torus: new points lie at the means of the others' angles around its axis and around its tube,
/// and of their distances from the tube's middle.
class TorusManifold : public dealii::Manifold<3> {
 public:
  /// @param axis unit vector
  /// @param ring_radius of the tube's middle, > 0
  TorusManifold(const dealii::Tensor<1, 3>& axis, const dealii::Point<3>& centre,
                double ring_radius);

  std::unique_ptr<dealii::Manifold<3>> clone() const override;

  dealii::Point<3> get_new_point(const dealii::ArrayView<const dealii::Point<3>>& points,
                                 const dealii::ArrayView<const double>& weights) const override;

 private:
  /// Angles around axis and tube, and distance from the tube's middle.
  [[nodiscard]] std::array<double, 3> pulled_back(const dealii::Point<3>& point) const;

  dealii::Tensor<1, 3> axis_;
  dealii::Point<3> centre_;
  double ring_radius_;
  dealii::Tensor<1, 3> first_, second_;  ///< across the axis
};

}  // namespace geneva::mesh
