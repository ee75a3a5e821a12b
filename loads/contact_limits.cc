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

/// Of searches that are repeated: to about 1e-5.
constexpr int coarse_steps = 12;
constexpr int coarse_zooms = 4;

struct PlacedMaximum {
  double value;
  double depth;
};

/// Maximum over |x| <= 2, 0 < z <= 2: a grid, and finer ones around its best point.
PlacedMaximum maximum_below(const std::function<double(double, double)>& value,
                            const double least_depth, const int steps = 40, const int zooms = 8) {
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

/// Of a line contact with peak pressure and half-width 1, at or below a depth.
double mises_below(const double poissons_ratio, const double friction, const double depth) {
  return maximum_below(
             [&](const double x, const double z) {
               return von_mises(sliding_stress(unit_contact, friction, x, z), poissons_ratio);
             },
             depth, coarse_steps, coarse_zooms)
      .value;
}

double shear_below(const double friction, const double depth) {
  return maximum_below(
             [&](const double x, const double z) {
               return std::abs(sliding_stress(unit_contact, friction, x, z).xz);
             },
             depth, coarse_steps, coarse_zooms)
      .value;
}

/// Largest pressure up to the layer's limit with which the core is not beyond its strength.
/// @param stress_below greatest stress of a contact of pressure and width 1, by the least depth
double layered_limit(const double layer_limit, const double core, const double depth,
                     const double width_per_pressure,
                     const std::function<double(double)>& stress_below) {
  const auto is_borne = [&](const double pressure) {
    return pressure * stress_below(depth / (width_per_pressure * pressure)) <= core;
  };
  if (is_borne(layer_limit)) return layer_limit;
  double borne = 0.;
  double beyond = layer_limit;
  constexpr int halvings = 24;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (borne + beyond) / 2.;
    (is_borne(middle) ? borne : beyond) = middle;
  }
  return borne;
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

double yield_strength_by_hardness(const double hardness) {
  require_positive("hardness", hardness, "");
  constexpr double standard_gravity = 9.80665;
  constexpr double per_kgf_per_mm2 = standard_gravity * 1e6;
  constexpr double tabor = 3.;
  return hardness * per_kgf_per_mm2 / tabor;
}

ContactLimits layered_line_limits(const double poissons_ratio, const double friction,
                                  const HardenedLayer& layer, const double core,
                                  const double half_width_per_pressure) {
  const ContactLimits of_layer = line_contact_limits(poissons_ratio, friction);
  return {
      layered_limit(
          of_layer.first_yield * layer.yield_strength, core, layer.depth, half_width_per_pressure,
          [&](const double depth) { return mises_below(poissons_ratio, friction, depth); }),
      layered_limit(of_layer.shakedown * layer.yield_strength, shear_yield * core, layer.depth,
                    half_width_per_pressure,
                    [&](const double depth) { return shear_below(friction, depth); })};
}

ContactLimits layered_point_limits(const double poissons_ratio, const HardenedLayer& layer,
                                   const double core, const double radius_per_pressure) {
  const ContactLimits of_layer = point_contact_limits(poissons_ratio);
  const HertzPoint contact = hertz_point(1., 1., 1., poissons_ratio);
  const double deepest = contact.max_shear_depth / contact.contact_radius;
  const auto shear_at = [&](const double depth) {
    return axial_shear(std::max(depth, deepest), poissons_ratio);
  };
  const auto mises_at = [&](const double depth) { return 2. * shear_at(depth); };
  return {layered_limit(of_layer.first_yield * layer.yield_strength, core, layer.depth,
                        radius_per_pressure, mises_at),
          std::max(of_layer.shakedown * std::min(layer.yield_strength, core),
                   layered_limit(of_layer.shakedown * layer.yield_strength, shear_yield * core,
                                 layer.depth, radius_per_pressure, shear_at))};
}

ContactLimits point_contact_limits(const double poissons_ratio) {
  constexpr double ponter = 4.68;
  // On the axis von Mises' and Tresca's stresses are the same.
  const HertzPoint contact = hertz_point(1., 1., 1., poissons_ratio);
  return {contact.peak_pressure / (2. * contact.max_shear), ponter * shear_yield};
}

}  // namespace geneva::loads
