#include "loads/pin/cylinder_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/errors.h"
#include "loads/pi.h"

namespace geneva::loads {

namespace {

/// Places of the table: z = sinh(u)/4, u even.
constexpr double place_step = 0.1;
constexpr double place_scale = 0.25;

double place(const std::size_t i) {
  return place_scale * std::sinh(place_step * static_cast<double>(i));
}

/// Lagrange's polynomials of Chebyshev's points of the second kind on 0 .. 0.5 (Berrut and
/// Trefethen 2004, Barycentric Lagrange interpolation).
std::array<double, n_kernel_ratios> shares_at(const double ratio) {
  std::array<double, n_kernel_ratios> shares{};
  double sum = 0.;
  for (std::size_t i = 0; i < n_kernel_ratios; ++i) {
    const double node = 0.25 * (1. - std::cos(pi * static_cast<double>(i) / (n_kernel_ratios - 1)));
    if (std::abs(ratio - node) < 1e-14) {
      shares = {};
      shares[i] = 1.;
      return shares;
    }
    const bool is_end = i == 0 || i + 1 == n_kernel_ratios;
    shares[i] = (i % 2 == 0 ? 1. : -1.) * (is_end ? 0.5 : 1.) / (ratio - node);
    sum += shares[i];
  }
  for (double& share : shares) share /= sum;
  return shares;
}

}  // namespace

CylinderKernel::CylinderKernel(const double poissons_ratio) : poissons_ratio_(poissons_ratio) {
  if (!(poissons_ratio >= 0. && poissons_ratio <= 0.5))
    throw base::InputError(
        fmt::format("the pin's Poisson's ratio is {:.4g}, from 0 to 0.5 is known", poissons_ratio));
  const auto shares = shares_at(poissons_ratio);
  for (std::size_t ratio = 0; ratio < n_kernel_ratios; ++ratio)
    for (std::size_t i = 0; i < n_kernel_places; ++i) {
      const auto& [value, slope] = cylinder_kernel_table[ratio * n_kernel_places + i];
      values_[i] += shares[ratio] * value;
      slopes_[i] += shares[ratio] * slope;
    }
}

double CylinderKernel::shear_factor() const {
  const double nu = poissons_ratio_;
  return (7. - 8. * nu * nu) / (6. * (1. + nu) * (1. + nu));
}

/// Beyond the table V grows as -(1 - nu^2)/pi ln z, half of a half-space's.
double CylinderKernel::integral(const double z) const {
  const double nu = poissons_ratio_;
  const double end = place(n_kernel_places - 1);
  const double size = std::min(std::abs(z), end);
  if (size == 0.) return 0.;
  const auto i = std::min<std::size_t>(
      static_cast<std::size_t>(std::asinh(size / place_scale) / place_step), n_kernel_places - 2);
  const double width = place(i + 1) - place(i);
  const double x = (size - place(i)) / width;
  const double rise = values_[i + 1] - values_[i];
  const double lower = width * slopes_[i];
  const double upper = width * slopes_[i + 1];
  const double smooth =
      values_[i] +
      x * (lower + x * (3. * rise - 2. * lower - upper + x * (lower + upper - 2. * rise)));
  const double curvature = (1. - 2. * nu) * (1. - 2. * nu) * (1. + nu) / 4.;
  double value = smooth - curvature / pi * size * std::log(size / std::hypot(1., size));
  if (size < std::abs(z)) value -= (1. - nu * nu) / pi * std::log(std::abs(z) / end);
  return z < 0. ? -value : value;
}

}  // namespace geneva::loads
