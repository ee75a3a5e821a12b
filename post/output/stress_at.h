#pragma once

#include <array>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "post/output/nodal_fields.h"

namespace geneva::post {

/// Stress between the nodes of a field; quickest at places one near the other.
class StressAt {
 public:
  using Place = std::array<double, 3>;

  /// @param fields with a cell or more; must outlive it
  explicit StressAt(const NodalFields& fields);

  /// Stress [Pa] in the cell of a body that has the place, or is nearest to it.
  [[nodiscard]] std::array<double, 6> operator()(const Place& place, unsigned int body) const;

 private:
  using Point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Point>;
  using BoxOfCell = std::pair<Box, std::size_t>;
  using Tree = boost::geometry::index::rtree<BoxOfCell, boost::geometry::index::quadratic<16>>;

  using Weights = std::array<double, 8>;  ///< of a cell's corners, of which there may be four

  static Weights weights_at(const Place& reference, std::size_t corners);
  [[nodiscard]] Box box_of(std::size_t cell) const;
  [[nodiscard]] Place place_at(std::size_t cell, const Weights& weights) const;
  [[nodiscard]] double distance_to(std::size_t cell, const Weights& weights,
                                   const Place& place) const;
  /// Weights of the corners at the place's reference coordinates (Newton's method, in space with
  /// the Jacobian by differences), kept within the cell.
  [[nodiscard]] Weights clamped_weights(std::size_t cell, const Place& place) const;
  [[nodiscard]] Weights clamped_in_plane(std::size_t cell, const Place& place) const;
  [[nodiscard]] Weights clamped_in_space(std::size_t cell, const Place& place) const;

  /// Nothing if the place is not in the cell, or the cell is another body's.
  [[nodiscard]] std::optional<Weights> weights_within(std::size_t cell, const Place& place,
                                                      unsigned int body) const;
  /// Of places that rounding or a turn has put outside of all cells.
  [[nodiscard]] std::array<double, 6> stress_in_nearest(const Place& place,
                                                        unsigned int body) const;

  [[nodiscard]] std::array<double, 6> stress_in(std::size_t cell, const Weights& weights) const;
  /// Distance from a cell up to which a place is within it [m].
  [[nodiscard]] double inside(std::size_t cell) const;

  const NodalFields& fields_;
  std::vector<Box> boxes_;  ///< by cell
  Tree tree_;
  mutable std::size_t last_ = 0;  ///< cell of the last place, which may have the next one, too
};

}  // namespace geneva::post
