#include "loads/held_cylinder.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <vector>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// Difference of the radial and the hoop stress below the middle, at r, under the pressure
/// cos(n theta) on r = 1, as a sum of powers of r.
struct Wave {
  std::array<double, 4> factors;
  std::array<double, 4> powers;

  [[nodiscard]] double operator()(const double r) const {
    double sum = 0.;
    for (std::size_t i = 0; i < factors.size(); ++i)
      if (factors[i] != 0.) sum += factors[i] * std::pow(r, powers[i]);
    return sum;
  }
};

/// A ln r + B r^2, without displacement at the core.
Wave even_pressure(const double core, const double kappa) {
  const double b = -1. / ((kappa - 1.) * core * core + 2.);
  return {{2. * b * (kappa - 1.) * core * core, 0., 0., 0.}, {-2., 0., 0., 0.}};
}

/// B r^3 cos, C cos/r, E (r theta sin + F r ln r cos), where F makes the displacement
/// single-valued, and a translation of the whole: the pressure's resultant goes to the core.
Wave resultant(const double core, const double kappa) {
  const double f = -(kappa - 1.) / (kappa + 1.);
  const double logarithm = 0.5 * (kappa + 1. + f * (kappa - 1.)) * std::log(core);
  const double constant = 0.5 * (1. + f);
  const double square = core * core;
  Eigen::Matrix4d matrix;
  matrix << 2., -2., 2. + f, 0.,                                     // radial stress at r = 1
      2., -2., f, 0.,                                                // shear there
      (kappa - 2.) * square, 1. / square, logarithm - constant, 1.,  // displacements at the core
      (kappa + 2.) * square, 1. / square, -logarithm - constant, -1.;
  const Eigen::Vector4d c = matrix.partialPivLu().solve(Eigen::Vector4d(-1., 0., 0., 0.));
  return {{-4. * c(0), -4. * c(1), 2. * c(2), 0.}, {1., -3., -1., 0.}};
}

/// A r^n, B r^(n+2), C (core/r)^n, D r^2 (core/r)^n, times cos(n theta).
Wave wave(const unsigned int number, const double core, const double kappa) {
  const double n = number;
  constexpr double negligible = 1e-12;
  const double at_surface = std::pow(core, n);
  Eigen::Vector4d c(0., -1. / (2. * n + 2.), 0., 0.);
  c(0) = -c(1) * (n + 1.) / (n - 1.);
  if (at_surface > negligible) {
    Eigen::Matrix4d matrix;
    matrix << n * (1. - n), n + 2. - n * n, -n * (n + 1.) * at_surface,
        (2. - n - n * n) * at_surface,  // radial stress at r = 1
        n * (n - 1.), n * (n + 1.), -n * (n + 1.) * at_surface,
        -n * (n - 1.) * at_surface,  // shear there
        -n * at_surface / core, (kappa - n - 1.) * at_surface * core, n / core,
        (kappa + n - 1.) * core,  // displacements at the core
        n * at_surface / core, (kappa + n + 1.) * at_surface * core, n / core,
        -(kappa - n + 1.) * core;
    c = matrix.partialPivLu().solve(Eigen::Vector4d(-1., 0., 0., 0.));
  }
  const double a = 2. * n * (1. - n) * c(0);
  const double b = (n + 2. - n * n - (n + 2.) * (n + 1.)) * c(1);
  const double of_core = -2. * n * (n + 1.) * c(2) * at_surface;
  const double d = (2. - n - n * n - (n - 2.) * (n - 1.)) * c(3) * at_surface;
  return {{a, b, of_core, d}, {n - 2., n, -n - 2., -n}};
}

/// Shear over the peak pressure below the middle of Hertz's pressure of the half-width b on a
/// cylinder of radius 1.
class Shear {
 public:
  Shear(const double half_width, const double core, const double poissons_ratio) {
    // exp(-n z) at the depth z = b/2, the least that is looked at, is round-off then
    const auto count = static_cast<unsigned int>(60. / half_width);
    const double kappa = 3. - 4. * poissons_ratio;
    factors_.reserve(count);
    waves_.reserve(count);
    add(half_width / 4., even_pressure(core, kappa));
    for (unsigned int n = 1; n < count; ++n)
      add(std::cyl_bessel_j(1., n * half_width) / n,
          n == 1 ? resultant(core, kappa) : wave(n, core, kappa));
  }

  [[nodiscard]] double operator()(const double depth) const {
    double sum = 0.;
    for (std::size_t i = 0; i < waves_.size(); ++i) sum += factors_[i] * waves_[i](1. - depth);
    return std::abs(sum) / 2.;
  }

 private:
  void add(const double factor, const Wave& wave) {
    factors_.push_back(factor);
    waves_.push_back(wave);
  }

  std::vector<double> factors_;
  std::vector<Wave> waves_;
};

void check(const HertzLine& contact, const double radius, const double core_radius,
           const double poissons_ratio) {
  require_positive_length("the cylinder's radius", radius);
  require_positive_length("its core's radius", core_radius);
  if (!(contact.half_width < radius / 4.))
    throw base::InputError(fmt::format(
        "the contact's half-width is {:.3g} of the cylinder's radius: the shear below it is known "
        "below 0.25; give a smaller force",
        contact.half_width / radius));
  if (!(core_radius < 0.95 * radius))
    throw base::InputError(fmt::format(
        "the cylinder's core is {:.3g} of its radius: it must be smaller than 0.95 of it",
        core_radius / radius));
  if (!(poissons_ratio > -1. && poissons_ratio < 0.5))
    throw base::InputError(
        fmt::format("the cylinder's Poisson's ratio is {:.6g}: it must lie between -1 and 0.5",
                    poissons_ratio));
}

}  // namespace

DeepStress maximum_shear_in_held_cylinder(const HertzLine& contact, const double radius,
                                          const double core_radius, const double poissons_ratio) {
  check(contact, radius, core_radius, poissons_ratio);
  // Narrower contacts need many more waves, and what the size adds goes with their width.
  constexpr double least = 0.01;
  const double half_width = contact.half_width / radius;
  const double taken = std::max(half_width, least);
  const Shear shear(taken, core_radius / radius, poissons_ratio);
  constexpr int digits = 20;
  const auto [depth, negative] = boost::math::tools::brent_find_minima(
      [&](const double z) { return -shear(z); }, 0.5 * taken, 1.1 * taken, digits);
  const double in_half_plane = contact.max_shear / contact.peak_pressure;
  const double depth_in_half_plane = contact.max_shear_depth / contact.half_width;
  const double share = half_width / taken;
  return {
      contact.peak_pressure * (in_half_plane + share * (-negative - in_half_plane)),
      contact.half_width * (depth_in_half_plane + share * (depth / taken - depth_in_half_plane))};
}

}  // namespace geneva::loads
