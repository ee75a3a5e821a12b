#include "loads/hertz.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

void check_elastic(const Elastic& material) {
  require_positive("Young's modulus", material.youngs_modulus, "Pa");
  if (material.poissons_ratio > -1. && material.poissons_ratio < 0.5) return;
  throw base::InputError(
      fmt::format("Poisson's ratio is {:.6g}: it must lie between -1 and 0.5; "
                  "give a ratio in this range (steel: 0.3)",
                  material.poissons_ratio));
}

double elliptic_pressure(double peak, double half_width, double distance) {
  const double ratio = distance / half_width;
  return peak * std::sqrt(std::max(0., 1. - ratio * ratio));
}

/// Slope of the shear on the axis of a point contact, d(2 tau/p0)/d(z/a), from Eq. 3.45 of
/// K. L. Johnson (1985): 2 tau/p0 = 3/(2 (1 + zeta^2)) - (1 + nu)(1 - zeta atan(1/zeta)).
double axial_shear_slope(double zeta, double poissons_ratio) {
  const double spread = 1. + zeta * zeta;
  return (1. + poissons_ratio) * (std::atan2(1., zeta) - zeta / spread) -
         3. * zeta / (spread * spread);
}

/// zeta = z/a of the maximum shear. The slope is positive at the surface and negative at zeta = 1
/// with one zero between for every nu in (-1, 0.5]; a zero of the slope is found to rounding, which
/// a search on the flat maximum itself cannot do.
double depth_of_maximum_shear(double poissons_ratio) {
  double shallow = 0.;
  double deep = 1.;
  while (deep - shallow > 1e-15) {
    const double middle = (shallow + deep) / 2.;
    (axial_shear_slope(middle, poissons_ratio) > 0. ? shallow : deep) = middle;
  }
  return (shallow + deep) / 2.;
}

}  // namespace

double contact_modulus(const Elastic& first, const Elastic& second) {
  check_elastic(first);
  check_elastic(second);
  const auto compliance = [](const Elastic& material) {
    return (1. - material.poissons_ratio * material.poissons_ratio) / material.youngs_modulus;
  };
  return 1. / (compliance(first) + compliance(second));
}

double contact_modulus_plane_stress(const Elastic& first, const Elastic& second) {
  check_elastic(first);
  check_elastic(second);
  return 1. / (1. / first.youngs_modulus + 1. / second.youngs_modulus);
}

double HertzLine::pressure(double x) const {
  return elliptic_pressure(peak_pressure, half_width, x);
}

ContactStress HertzLine::stress(double x, double z) const {
  require_not_negative("depth below the contact", 1e3 * z, "mm");
  const double difference = half_width * half_width - x * x + z * z;
  const double sum = std::hypot(difference, 2. * x * z);  // m^2 + n^2
  if (sum == 0.) return {0., 0., 0.};                     // edge of the contact
  // m n = x z: take the greater of the two from its definition, the other without cancellation
  const double greater = std::sqrt((sum + std::abs(difference)) / 2.);
  const double m = difference >= 0. ? greater : std::abs(x) * z / greater;
  const double n = difference >= 0. ? x * z / greater : std::copysign(greater, x);
  const double scale = peak_pressure / half_width;
  return {-scale * (m * (1. + (z * z + n * n) / sum) - 2. * z),
          -scale * m * (1. - (z * z + n * n) / sum), -scale * n * (m * m - z * z) / sum};
}

HertzLine hertz_line(double force_per_length, double relative_radius, double contact_modulus) {
  require_positive("force per length", force_per_length, "N/m");
  require_positive_length("relative radius", relative_radius);
  require_positive("contact modulus", contact_modulus, "Pa");
  const double half_width =
      std::sqrt(4. * force_per_length * relative_radius / (pi * contact_modulus));
  const double peak = 2. * force_per_length / (pi * half_width);
  // On the axis tau = p0 (zeta - zeta u) with zeta = z/b and u = zeta/sqrt(1 + zeta^2); its slope
  // 1 - 2 u + u^3 = (u - 1)(u^2 + u - 1) vanishes at the golden section, where zeta = sqrt(u).
  const double u = (std::sqrt(5.) - 1.) / 2.;
  return {peak, half_width, peak * std::sqrt(u) * (1. - u), half_width * std::sqrt(u)};
}

double HertzPoint::pressure(double r) const {
  return elliptic_pressure(peak_pressure, contact_radius, r);
}

DeepStress maximum_von_mises(const HertzLine& contact, const double poissons_ratio) {
  constexpr int bits = 26;
  const auto von_mises = [&](const double depth_over_b) {
    const ContactStress at = contact.stress(0., depth_over_b * contact.half_width);
    const double yy = poissons_ratio * (at.xx + at.zz);
    const double squares = (at.xx - at.zz) * (at.xx - at.zz) + (at.zz - yy) * (at.zz - yy) +
                           (yy - at.xx) * (yy - at.xx);
    return std::sqrt(squares / 2.);
  };
  const auto [depth, negative] = boost::math::tools::brent_find_minima(
      [&](const double place) { return -von_mises(place); }, 0.3, 1.5, bits);
  if (von_mises(0.) >= -negative) return {von_mises(0.), 0.};
  return {-negative, depth * contact.half_width};
}

double axial_shear(const double zeta, const double poissons_ratio) {
  return 0.75 / (1. + zeta * zeta) -
         (1. + poissons_ratio) / 2. * (1. - zeta * std::atan2(1., zeta));
}

HertzPoint hertz_point(double force, double relative_radius, double contact_modulus,
                       double poissons_ratio) {
  require_positive("force", force, "N");
  require_positive_length("relative radius", relative_radius);
  require_positive("contact modulus", contact_modulus, "Pa");
  check_elastic({contact_modulus, poissons_ratio});
  const double radius = std::cbrt(3. * force * relative_radius / (4. * contact_modulus));
  const double peak = 3. * force / (2. * pi * radius * radius);
  const double zeta = depth_of_maximum_shear(poissons_ratio);
  return {peak, radius, radius * radius / relative_radius, peak * axial_shear(zeta, poissons_ratio),
          zeta * radius};
}

}  // namespace geneva::loads
