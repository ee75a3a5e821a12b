#include "loads/pin/bending_width.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "loads/pi.h"

namespace geneva::loads {

namespace {

/// With t = cos theta, in the middles of even parts, which miss the logarithms at t = 0 and 1, over
/// what these parts make of 1, the integral to infinity.
double integrated_share(const double distance) {
  constexpr int parts = 600;
  double sum = 0.;
  double whole = 0.;
  for (int i = 0; i < parts; ++i) {
    const double theta = pi * (i + 0.5) / parts;
    const double t = std::cos(theta);
    const double weight = std::pow(std::sin(theta), 2);
    sum += weight * (std::asinh(distance / std::abs(t)) - std::asinh(distance / (1. - t)));
    whole += weight * std::log((1. - t) / std::abs(t));
  }
  return sum / whole;
}

constexpr double table_step = 0.03;  // of asinh(s)
constexpr std::size_t table_size = 256;

const std::array<double, table_size>& table() {
  static const std::array<double, table_size> entries = [] {
    std::array<double, table_size> made{};
    for (std::size_t i = 0; i < table_size; ++i)
      made[i] = integrated_share(std::sinh(table_step * static_cast<double>(i)));
    return made;
  }();
  return entries;
}

}  // namespace

double bending_share(const double distance) {
  const double place = std::asinh(std::abs(distance)) / table_step;
  if (place >= table_size - 1) return std::copysign(1., distance);
  const auto before = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(before);
  return std::copysign((1. - share) * table()[before] + share * table()[before + 1], distance);
}

BendingWidths::BendingWidths(Eigen::VectorXd places, Eigen::VectorXd widths,
                             const double square_per_load)
    : places_(std::move(places)), widths_(std::move(widths)), square_per_load_(square_per_load) {}

void BendingWidths::follow(const Eigen::VectorXd& loads) {
  constexpr double relaxation = 0.6;
  constexpr double least_load = 1e-6;  // of the greatest: no width is 0
  const double least = least_load * loads.maxCoeff();
  if (half_widths_.size() == 0)
    half_widths_ = (square_per_load_ * loads.cwiseMax(loads.mean())).cwiseSqrt();
  for (Eigen::Index i = 0; i < half_widths_.size(); ++i) {
    const double b = half_widths_[i];
    double load = 0.;
    for (Eigen::Index j = 0; j < loads.size(); ++j) {
      if (loads[j] <= 0.) continue;
      const double distance = places_[j] - places_[i];
      load += 0.5 * loads[j] *
              (bending_share((distance + widths_[j] / 2.) / b) -
               bending_share((distance - widths_[j] / 2.) / b));
    }
    const double wanted = std::sqrt(square_per_load_ * std::max(load, least));
    half_widths_[i] += relaxation * (wanted - b);
  }
}

}  // namespace geneva::loads
