#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"
#include "loads/hertz.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// Ratio of the relative curvatures R'/R'' that belongs to an ellipse with k^2 = b^2/a^2:
/// ((1/k^2) E(e) - K(e))/(K(e) - E(e)) (Johnson 1985, Eq. 4.28a), with e^2 = 1 - k^2.
double curvature_ratio(const double square) {
  const double e = std::sqrt(1. - square);
  const double K = std::comp_ellint_1(e);
  const double E = std::comp_ellint_2(e);
  return (E / square - K) / (K - E);
}

/// (b/a)^2 for a ratio of relative radii above 1, by bisection on its logarithm.
double axes_square(const double ratio) {
  double lower = std::log(1e-16);
  double upper = 0.;
  while (upper - lower > 1e-14) {
    const double middle = (lower + upper) / 2.;
    (curvature_ratio(std::exp(middle)) > ratio ? lower : upper) = middle;
  }
  return std::exp((lower + upper) / 2.);
}

}  // namespace

HertzEllipse hertz_ellipse(const double force, const double larger_radius,
                           const double smaller_radius, const double contact_modulus) {
  require_positive("contact force", force, "N");
  require_positive_length("larger relative radius", larger_radius);
  require_positive_length("smaller relative radius", smaller_radius);
  require_positive("contact modulus", contact_modulus, "Pa");
  const double ratio = larger_radius / smaller_radius;
  if (ratio < 1.)
    throw base::InputError(fmt::format(
        "the larger relative radius {:.6g} mm is below the smaller one {:.6g} mm: exchange them",
        1e3 * larger_radius, 1e3 * smaller_radius));
  // K - E vanishes for circles, which have their own closed form.
  if (ratio < 1. + 1e-9) {
    const HertzPoint point = hertz_point(force, larger_radius, contact_modulus, 0.);
    return {point.peak_pressure, point.contact_radius, point.contact_radius, point.approach};
  }
  const double square = axes_square(ratio);
  const double e_square = 1. - square;
  const double e = std::sqrt(e_square);
  const double K = std::comp_ellint_1(e);
  const double E = std::comp_ellint_2(e);
  // 1/(2 R') = p0 b (K - E)/(E* e^2 a^2) with p0 = 3 F/(2 pi a b) (Johnson 1985, Eq. 4.26)
  const double a =
      std::cbrt(3. * force * larger_radius * (K - E) / (pi * contact_modulus * e_square));
  const double b = a * std::sqrt(square);
  const double peak = 3. * force / (2. * pi * a * b);
  return {peak, a, b, peak * b * K / contact_modulus};
}

}  // namespace geneva::loads
