#pragma once

#include <deal.II/grid/manifold.h>

#include <memory>

#include "mesh/grading.h"

namespace geneva::mesh {

/// A surface or body whose refined layers along z are graded: new points are those of another
/// manifold between the places that the points have where the layers are even.
class GradedManifold : public dealii::Manifold<3> {
 public:
  /// @param ungraded with its axis along z, or flat
  /// @param grading in the unit of the triangulation
  GradedManifold(std::unique_ptr<dealii::Manifold<3>> ungraded, const Grading& grading);

  std::unique_ptr<dealii::Manifold<3>> clone() const override;

  dealii::Point<3> get_new_point(const dealii::ArrayView<const dealii::Point<3>>& points,
                                 const dealii::ArrayView<const double>& weights) const override;

 private:
  std::unique_ptr<dealii::Manifold<3>> ungraded_;
  Grading grading_;
};

}  // namespace geneva::mesh
