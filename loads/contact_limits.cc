#include "loads/contact_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

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

/// Least value of a convex function between two places.
double convex_minimum(const std::function<double(double)>& value, double from, double to) {
  constexpr int steps = 32;
  constexpr double golden = 0.6180339887498949;
  double left = to - golden * (to - from);
  double right = from + golden * (to - from);
  double at_left = value(left);
  double at_right = value(right);
  for (int i = 0; i < steps; ++i) {
    if (at_left < at_right) {
      to = right;
      right = left;
      at_right = at_left;
      left = to - golden * (to - from);
      at_left = value(left);
    } else {
      from = left;
      left = right;
      at_left = at_right;
      right = from + golden * (to - from);
      at_right = value(right);
    }
  }
  return std::min(at_left, at_right);
}

/// Greatest von Mises stress of the surface while a line contact of peak pressure 1 passes, with
/// the residual stresses along x and y that make it least (Melan's theorem).
double surface_mises_shaken_down(const double poissons_ratio, const double friction) {
  constexpr int samples = 100;              // over a half-width
  std::vector<std::array<double, 3>> path;  // xx, zz, xz
  for (int i = -3 * samples; i <= 3 * samples; ++i) {
    const ContactStress stress =
        sliding_stress(unit_contact, friction, static_cast<double>(i) / samples, 0.);
    path.push_back({stress.xx, stress.zz, stress.xz});
  }
  const auto worst = [&](const double residual_x, const double residual_y) {
    double square = 0.;
    for (const auto& [xx, zz, xz] : path) {
      const double x = xx + residual_x;
      const double y = poissons_ratio * (xx + zz) + residual_y;
      const double differences = (x - y) * (x - y) + (y - zz) * (y - zz) + (zz - x) * (zz - x);
      square = std::max(square, differences / 2. + 3. * xz * xz);
    }
    return std::sqrt(square);
  };
  constexpr double most = 3.;
  return convex_minimum(
      [&](const double x) {
        return convex_minimum([&](const double y) { return worst(x, y); }, -most, most);
      },
      -most, most);
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
  // At the surface the shear is mu p everywhere: other stresses decide there.
  constexpr double below_surface = 0.05;
  const double shear =
      maximum_below([&](const double x, const double z) { return std::abs(stress(x, z).xz); },
                    below_surface)
          .value;
  return {1. / mises,
          std::min(shear_yield / shear, 1. / surface_mises_shaken_down(poissons_ratio, friction))};
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

PrincipalStress axial_stress(const double axis_ratio, const double depth,
                             const double poissons_ratio) {
  const double a = 1. / axis_ratio;
  const double e = std::sqrt(1. - axis_ratio * axis_ratio);
  const double root = std::sqrt((1. + depth * depth) / (a * a + depth * depth));
  const double zeta = depth / a;
  const double angle = std::atan2(a, depth);
  const double first = std::ellint_1(e, angle);
  const double second = std::ellint_2(e, angle);
  const double along = zeta * (first - second);
  const double across = zeta * (a * a * second - first);
  const double factor = 2. / (e * e * a);
  return {
      factor * (-(1. - root) / 2. + along + poissons_ratio * (1. - a * a * root + across)),
      factor * (0.5 + 0.5 / root - root * a * a + across + poissons_ratio * (-1. + root + along)),
      -factor / 2. * (1. - root * root) / root};
}

ContactLimits ellipse_contact_limits(const double axis_ratio, const double poissons_ratio) {
  constexpr double nearly_a_circle = 0.999;
  constexpr double nearly_a_line = 1e-3;
  if (!(axis_ratio > 0. && axis_ratio <= 1.))
    throw base::InputError("ratio of an ellipse's axes: from 0 to 1, 0 excluded");
  if (axis_ratio > nearly_a_circle) return point_contact_limits(poissons_ratio);
  const ContactLimits line = line_contact_limits(poissons_ratio, 0.);
  if (axis_ratio < nearly_a_line) return line;
  const auto mises = [&](const double depth) {
    const auto [x, y, z] = axial_stress(axis_ratio, depth, poissons_ratio);
    return std::sqrt(((x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x)) / 2.);
  };
  constexpr int steps = 400;  // down to twice the half-width
  double greatest = 0.;
  for (int i = 0; i <= steps; ++i) greatest = std::max(greatest, mises(2. * i / steps));
  return {1. / greatest, line.shakedown};
}

ContactLimits point_contact_limits(const double poissons_ratio) {
  constexpr double ponter = 4.68;
  // On the axis von Mises' and Tresca's stresses are the same.
  const HertzPoint contact = hertz_point(1., 1., 1., poissons_ratio);
  return {contact.peak_pressure / (2. * contact.max_shear), ponter * shear_yield};
}

}  // namespace geneva::loads
