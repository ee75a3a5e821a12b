#include "loads/drawing/linkage_drawing.h"

#include <cmath>

namespace geneva::loads {

LinkageDrawing::LinkageDrawing(const FourBar& linkage, const Assembly assembly,
                               const double wheel_direction, const FourBarGeneva& geneva)
    : linkage_(linkage),
      assembly_(assembly),
      crank_angle_(geneva.crank_angle),
      axis_{linkage_.crank_pivot[0] + geneva.centre_distance * std::cos(wheel_direction),
            linkage_.crank_pivot[1] + geneva.centre_distance * std::sin(wheel_direction)} {
  const FourBarMotion middle = motion(linkage_, assembly_, crank_angle_);
  const std::array<double, 2> pin{middle.x[0] - axis_[0], middle.y[0] - axis_[1]};
  const double distance = std::hypot(pin[0], pin[1]);
  x_axis_ = {pin[0] / distance, pin[1] / distance};
  side_ = x_axis_[0] * middle.y[1] - x_axis_[1] * middle.x[1] > 0. ? 1. : -1.;
}

Polyline LinkageDrawing::operator()(const double driver_angle) const {
  const double crank = crank_angle_ + driver_angle;
  const FourBarMotion now = motion(linkage_, assembly_, crank);
  const auto& [ax, ay] = linkage_.crank_pivot;
  const auto& [dx, dy] = linkage_.rocker_pivot;
  const double rocker = now.rocker_angle[0];
  const Place a = in_wheel_frame(ax, ay);
  const Place b =
      in_wheel_frame(ax + linkage_.crank * std::cos(crank), ay + linkage_.crank * std::sin(crank));
  const Place c = in_wheel_frame(dx + linkage_.rocker * std::cos(rocker),
                                 dy + linkage_.rocker * std::sin(rocker));
  const Place d = in_wheel_frame(dx, dy);
  const Place p = in_wheel_frame(now.x[0], now.y[0]);
  return {a, b, c, d, c, p, b};
}

Place LinkageDrawing::in_wheel_frame(const double x, const double y) const {
  const double right = x - axis_[0];
  const double up = y - axis_[1];
  return {x_axis_[0] * right + x_axis_[1] * up, side_ * (x_axis_[0] * up - x_axis_[1] * right), 0.};
}

}  // namespace geneva::loads
