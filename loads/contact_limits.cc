#include "loads/contact_limits.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/errors.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

constexpr HertzLine unit_contact{1., 1., 0., 0.};

/// k over Y by von Mises.
const double shear_yield = 1. / std::sqrt(3.);

struct PlacedMaximum {
  double value;
  double depth;
};

/// Maximum over |x| <= 2, 0 < z <= 2: a grid, and finer ones around its best point.
PlacedMaximum maximum_below(const std::function<double(double, double)>& value,
                            const double least_depth) {
  constexpr int steps = 40;
  constexpr int zooms = 8;
  double x = 0., z = 1., reach_x = 2., reach_z = 1.;
  double best = 0.;
  for (int zoom = 0; zoom < zooms; ++zoom) {
    const double middle_x = x;
    const double middle_z = z;
    for (int i = -steps; i <= steps; ++i)
      for (int j = -steps; j <= steps; ++j) {
        const double at_x = middle_x + reach_x * i / steps;
        const double at_z = std::max(least_depth, middle_z + reach_z * j / steps);
        const double here = value(at_x, at_z);
        if (here <= best) continue;
        best = here;
        x = at_x;
        z = at_z;
      }
    reach_x *= 0.1;
    reach_z *= 0.1;
  }
  return {best, z};
}

double von_mises(const ContactStress& stress, const double poissons_ratio) {
  const double yy = poissons_ratio * (stress.xx + stress.zz);
  const auto square = [](const double difference) { return difference * difference; };
  return std::sqrt(
      (square(stress.xx - stress.zz) + square(stress.zz - yy) + square(yy - stress.xx)) / 2. +
      3. * square(stress.xz));
}

}  // namespace

ContactStress sliding_stress(const HertzLine& contact, const double friction, const double x,
                             const double z) {
  const ContactStress normal = contact.stress(x, z);
  const double b = contact.half_width;
  const double difference = b * b - x * x + z * z;
  const double sum = std::hypot(difference, 2. * x * z);
  if (sum == 0.)  // edge of the contact
    return {-2. * friction * contact.peak_pressure * std::copysign(1., x), 0., 0.};
  const double m = std::sqrt(std::max(0., (sum + difference) / 2.));
  const double n = std::copysign(std::sqrt(std::max(0., (sum - difference) / 2.)), x);
  const double traction = friction * contact.peak_pressure / b;
  return {normal.xx + traction * (n * (2. - (z * z - m * m) / sum) - 2. * x),
          normal.zz + friction * normal.xz, normal.xz + friction * normal.xx};
}

DeepStress maximum_sliding_shear(const HertzLine& contact, const double friction) {
  if (friction == 0.) return {contact.max_shear, contact.max_shear_depth};
  const PlacedMaximum maximum = maximum_below(
      [&](const double x, const double z) {
        const ContactStress stress = sliding_stress(unit_contact, friction, x, z);
        return std::hypot((stress.xx - stress.zz) / 2., stress.xz);
      },
      0.);
  return {maximum.value * contact.peak_pressure, maximum.depth * contact.half_width};
}

ContactLimits line_contact_limits(const double poissons_ratio, const double friction) {
  require_not_negative("coefficient of friction", friction, "");
  if (friction > 1.) throw base::InputError("coefficient of friction: at most 1 is known here");
  const auto stress = [&](const double x, const double z) {
    return sliding_stress(unit_contact, friction, x, z);
  };
  const double mises =
      maximum_below(
          [&](const double x, const double z) { return von_mises(stress(x, z), poissons_ratio); },
          0.)
          .value;
  // At the surface the shear is mu p everywhere.
  constexpr double below_surface = 0.05;
  const double shear =
      maximum_below([&](const double x, const double z) { return std::abs(stress(x, z).xz); },
                    below_surface)
          .value;
  return {1. / mises, shear_yield / std::max(shear, friction)};
}

ContactLimits point_contact_limits(const double poissons_ratio) {
  constexpr double ponter = 4.68;
  // On the axis von Mises' and Tresca's stresses are the same.
  const HertzPoint contact = hertz_point(1., 1., 1., poissons_ratio);
  return {contact.peak_pressure / (2. * contact.max_shear), ponter * shear_yield};
}

}  // namespace geneva::loads
