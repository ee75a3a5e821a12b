#pragma once

#include <Eigen/Core>

namespace geneva::loads {

/// The share of an even line load up to a distance that bends the surface across it, of all of the
/// load on that side: the integral of D from 0 to s,
/// D(s) = (2/pi) int sqrt(1 - t^2) [1/sqrt(t^2 + s^2) - 1/sqrt((1 - t)^2 + s^2)] dt, t from -1 to
/// 1, by which a half-space's surface sinks more below the middle of a load that is an ellipse
/// across than at its end. Distances over the half-width; odd in s, 1 at infinity.
double bending_share(double distance);

/// Half-widths of line contacts side by side, which cannot follow loads that change within them:
/// the gap x^2/(2 R) closes at the half-width b where the surfaces bend across by b^2/(2 R), so
/// that b^2 = 4 R q/(pi E*) with the load q weighted by D of the distance over b.
class BendingWidths {
 public:
  /// @param places, widths of the sections [m]
  /// @param square_per_load 4 R/(pi E*) [m^3/N]
  BendingWidths(Eigen::VectorXd places, Eigen::VectorXd widths, double square_per_load);

  /// One step of the fixed point for b.
  /// @param loads line loads >= 0, some > 0 [N/m]
  void follow(const Eigen::VectorXd& loads);

  [[nodiscard]] const Eigen::VectorXd& half_widths() const { return half_widths_; }

 private:
  Eigen::VectorXd places_;
  Eigen::VectorXd widths_;
  double square_per_load_;
  Eigen::VectorXd half_widths_;  ///< [m]; empty before the first step
};

}  // namespace geneva::loads
