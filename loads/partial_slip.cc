#include "loads/partial_slip.h"

#include <algorithm>
#include <cmath>

#include "loads/require.h"

namespace geneva::loads {

namespace {

double ellipse(const double distance, const double radius) {
  return std::sqrt(std::max(0., radius * radius - distance * distance));
}

}  // namespace

PartialSlip::PartialSlip(const Shape shape, const double bound) : shape_(shape), bound_(bound) {
  require_positive("mu P", bound, "N");
}

void PartialSlip::move_to(const double force) {
  const double to = std::clamp(force / bound_, -1., 1.);
  const auto last = [&](const std::size_t back) { return turns_[turns_.size() - back]; };
  if (to == turns_.back()) return;
  if (turns_.size() > 1 && (to > last(1)) == (last(1) > last(2))) turns_.pop_back();
  turns_.push_back(to);
  // a branch that goes beyond the one before the last closes a loop
  while (turns_.size() > 3 && std::abs(last(1) - last(2)) >= std::abs(last(2) - last(3)))
    turns_.erase(turns_.end() - 3, turns_.end() - 1);
  if (turns_.size() == 3 && std::abs(to) >= std::abs(turns_[1])) turns_ = {0., to};
}

double PartialSlip::stick_radius() const {
  if (turns_.size() < 2) return 1.;
  const double change = std::abs(turns_.back() - turns_[turns_.size() - 2]);
  return radius_of(turns_.size() == 2 ? change : change / 2.);
}

double PartialSlip::sticking_share() const {
  const double radius = stick_radius();
  return shape_ == Shape::line ? radius : radius * radius;
}

double PartialSlip::traction(const double distance) const {
  double sum = 0.;
  for (std::size_t i = 1; i < turns_.size(); ++i) {
    const double change = turns_[i] - turns_[i - 1];
    sum += i == 1 ? first_loading(change, distance) : 2. * first_loading(change / 2., distance);
  }
  return sum;
}

double PartialSlip::radius_of(const double share) const {
  const double left = std::max(0., 1. - share);
  return shape_ == Shape::line ? std::sqrt(left) : std::cbrt(left);
}

double PartialSlip::first_loading(const double share, const double distance) const {
  const double radius = radius_of(std::abs(share));
  return std::copysign(ellipse(distance, 1.) - ellipse(distance, radius), share);
}

}  // namespace geneva::loads
