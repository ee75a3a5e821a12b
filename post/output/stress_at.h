#pragma once

#include <array>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <utility>
#include <vector>

#include "post/output/nodal_fields.h"

namespace geneva::post {

/// Stress between the nodes of a field.
class StressAt {
 public:
  using Place = std::array<double, 3>;

  /// @param fields must outlive it
  explicit StressAt(const NodalFields& fields);

  /// Stress [Pa] in the cell of a body that has the place, or is nearest to it.
  [[nodiscard]] std::array<double, 6> operator()(const Place& place, unsigned int body) const;

 private:
  using Point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Point>;
  using BoxOfCell = std::pair<Box, std::size_t>;
  using Tree = boost::geometry::index::rtree<BoxOfCell, boost::geometry::index::quadratic<16>>;

  [[nodiscard]] Box box_of(std::size_t cell) const;
  [[nodiscard]] Place place_at(std::size_t cell, const std::vector<double>& weights) const;
  [[nodiscard]] double distance_to(std::size_t cell, const std::vector<double>& weights,
                                   const Place& place) const;
  /// Weights of the corners at the place's reference coordinates (Newton's method, with the
  /// Jacobian by differences), kept within the cell.
  [[nodiscard]] std::vector<double> clamped_weights(std::size_t cell, const Place& place) const;

  const NodalFields& fields_;
  Tree tree_;
};

}  // namespace geneva::post
