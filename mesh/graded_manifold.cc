#include "mesh/graded_manifold.h"

#include <utility>
#include <vector>

namespace geneva::mesh {

using dealii::ArrayView;
using dealii::Point;

GradedManifold::GradedManifold(std::unique_ptr<dealii::Manifold<3>> ungraded,
                               const Grading& grading)
    : ungraded_(std::move(ungraded)), grading_(grading) {}

std::unique_ptr<dealii::Manifold<3>> GradedManifold::clone() const {
  return std::make_unique<GradedManifold>(ungraded_->clone(), grading_);
}

Point<3> GradedManifold::get_new_point(const ArrayView<const Point<3>>& points,
                                       const ArrayView<const double>& weights) const {
  std::vector<Point<3>> even_points(points.begin(), points.end());
  for (Point<3>& point : even_points) point[2] = even(grading_, point[2]);
  Point<3> point = ungraded_->get_new_point(
      ArrayView<const Point<3>>(even_points.data(), even_points.size()), weights);
  point[2] = graded(grading_, point[2]);
  return point;
}

}  // namespace geneva::mesh
