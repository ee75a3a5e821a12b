#pragma once

#include <array>
#include <optional>
#include <vector>

#include "post/output/cycle_fields.h"
#include "post/output/cycle_output.h"

namespace geneva::post {

/// Which nodes belong to bodies that move with the pin.
/// @param turning those bodies, by index
std::vector<bool> nodes_that_turn(const NodalFields& fields, const std::vector<bool>& turning);

/// A contact as it passes a place.
struct Pass {
  double pressure;  ///< peak [Pa]
  double when;      ///< see CycleFields
};

/// A round pin between the walls of a slot, of a mechanism in the plane, as the nodes of an instant
/// have them.
class SlotPassing {
 public:
  using Place = std::array<double, 3>;

  /// Nodes are on a wall or round the pin up to this, over the pin's radius, which is known as well
  /// as its nodes reach to its top and bottom: every 2.5 degrees, 2.4e-4 of the radius.
  static constexpr double near = 5e-4;

  /// @param turning bodies that move with the pin, by index
  /// @param curve of the cycle, in the order of the motion
  SlotPassing(const CycleFields& own, const std::vector<bool>& turning,
              const std::vector<CycleCurvePoint>& curve);

  [[nodiscard]] double pin_radius() const { return pin_radius_; }

  /// Below the wall, or the round pin's surface; negative outside of the body [m].
  /// @param turns whether the place is in a body that moves with the pin
  [[nodiscard]] double depth(const Place& place, bool turns) const;

  /// The place moved away from the pin's axis, or to it, onto the circle.
  [[nodiscard]] Place on_pin(const Place& place) const;

  /// The contact of greatest pressure that passes a place of the wheel, when the pin stands beside
  /// it, or of the pin, when it faces the wall that carries; none if none does.
  [[nodiscard]] std::optional<Pass> greatest(const Place& place, bool turns) const;

 private:
  /// From one point of the curve to the next, on one wall.
  struct Way {
    CycleCurvePoint from;
    CycleCurvePoint to;
    std::array<double, 2> facing;  ///< angles of the pin's own place that faces the wall [rad]
  };

  [[nodiscard]] std::optional<double> share_of(const Way& way, const Place& place, bool turns,
                                               double angle) const;

  double pin_distance_;
  double axis_y_;
  double pin_radius_;
  double half_width_;
  std::vector<Way> ways_;
};

}  // namespace geneva::post
