#include "loads/pin/held_beam.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "loads/pi.h"
#include "loads/pin/pin_beam.h"

namespace geneva::loads {

HeldBeam::HeldBeam(const PinLine& pin)
    : length_(pin.clearance.upper_end - pin.clearance.lower_end), hold_(pin.hold) {
  const double nu = pin.pin.poissons_ratio;
  const double bore = hold_ == PinHold::core ? 0. : pin.inner_radius;
  const double ratio = bore / pin.radius;
  const double area = pi * (pin.radius * pin.radius - bore * bore);
  const double shear_modulus = pin.pin.youngs_modulus / (2. * (1. + nu));
  bending_ = pin.pin.youngs_modulus * area * (pin.radius * pin.radius + bore * bore) / 4.;
  shear_ = shear_coefficient(nu, ratio) * shear_modulus * area;
  const double turned = length_ * length_ / (2. * bending_);
  end_stiffness_ << held_once(length_, length_), turned, turned, length_ / bending_;
  end_stiffness_ = end_stiffness_.inverse().eval();
}

double HeldBeam::flexibility(const double a, const double b) const {
  if (hold_ == PinHold::core) return 0.;
  const double once = held_once(a, b);
  return hold_ == PinHold::both_ends ? once - at_end(a).dot(end_stiffness_ * at_end(b)) : once;
}

double HeldBeam::turn(const double a, const double b) const {
  if (hold_ == PinHold::core) return 0.;
  if (hold_ == PinHold::one_end) return turn_held_once(a, b);
  const Eigen::Vector2d reaction = end_stiffness_ * at_end(b);  // force and moment at the end
  return turn_held_once(a, b) - reaction[0] * turn_held_once(a, length_) -
         reaction[1] * a / bending_;
}

double HeldBeam::moment(const double b) const {
  if (hold_ == PinHold::core) return 0.;
  if (hold_ == PinHold::one_end) return b;
  const Eigen::Vector2d reaction = end_stiffness_ * at_end(b);
  return b - reaction[0] * length_ - reaction[1];
}

double HeldBeam::held_once(const double a, const double b) const {
  const double near = std::min(a, b);
  const double far = std::max(a, b);
  return near * near * (3. * far - near) / (6. * bending_) + near / shear_;
}

double HeldBeam::turn_held_once(const double a, const double b) const {
  return a < b ? a * (b - a / 2.) / bending_ : b * b / (2. * bending_);
}

Eigen::Vector2d HeldBeam::at_end(const double b) const {
  return {held_once(length_, b), b * b / (2. * bending_)};
}

}  // namespace geneva::loads
