#pragma once

#include <Eigen/Core>

#include "loads/pin/pin_line.h"

namespace geneva::loads {

/// A round pin as Timoshenko's beam, held at s = 0 alone or there and at its end; one that is held
/// at its core does not bend.
class HeldBeam {
 public:
  explicit HeldBeam(const PinLine& pin);

  /// Deflection at s = a under a unit force at b [m/N].
  [[nodiscard]] double flexibility(double a, double b) const;
  /// Turn of the cross-section at s = a under a unit force at b [rad/N].
  [[nodiscard]] double turn(double a, double b) const;
  /// Moment at s = 0 of a unit force at b [m].
  [[nodiscard]] double moment(double b) const;
  /// E I [N m^2].
  [[nodiscard]] double bending_stiffness() const { return bending_; }

 private:
  [[nodiscard]] double held_once(double a, double b) const;
  [[nodiscard]] double turn_held_once(double a, double b) const;
  /// Deflection and turn of the end, were it free, under a unit force at b.
  [[nodiscard]] Eigen::Vector2d at_end(double b) const;

  double length_;
  PinHold hold_;
  double bending_;  ///< E I [N m^2]
  double shear_;    ///< kappa G A [N]
  Eigen::Matrix2d end_stiffness_;
};

}  // namespace geneva::loads
