#pragma once

#include <array>

#include "loads/drawing/mechanism_drawing.h"
#include "loads/motion/four_bar_geneva.h"

namespace geneva::loads {

/// The linkage of a four-bar Geneva in the frame of the wheel, where the pin stands on the x axis
/// midway and moves towards y there.
class LinkageDrawing {
 public:
  /// @param wheel_direction of the wheel's axis from the crank's, from the x axis of the linkage
  /// [rad]
  LinkageDrawing(const FourBar& linkage, Assembly assembly, double wheel_direction,
                 const FourBarGeneva& geneva);

  /// Crank pivot, crank pin, coupler's end, rocker pivot, coupler's end, coupler point, crank pin.
  /// @param driver_angle [rad] from the middle of the engagement
  [[nodiscard]] Polyline operator()(double driver_angle) const;

 private:
  [[nodiscard]] Place in_wheel_frame(double x, double y) const;

  FourBar linkage_;
  Assembly assembly_;
  double crank_angle_;  ///< midway through the engagement [rad]
  std::array<double, 2> axis_;
  std::array<double, 2> x_axis_{};
  double side_ = 1.;
};

}  // namespace geneva::loads
