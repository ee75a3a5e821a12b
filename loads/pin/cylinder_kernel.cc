#include "loads/pin/cylinder_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/pin/core_held_kernel_table.h"
#include "loads/pin/cylinder_kernel_table.h"
#include "loads/pin/hollow_kernel_table.h"

namespace geneva::loads {

namespace {

/// Places of the tables: z = sinh(i step)/4.
constexpr double place_scale = 0.25;

double place(const std::size_t i, const double step) {
  return place_scale * std::sinh(step * static_cast<double>(i));
}

/// Lagrange's polynomials of Chebyshev's points of the second kind on -1 .. 1, in ascending order
/// (Berrut and Trefethen 2004, Barycentric Lagrange interpolation).
std::vector<double> shares_at(const double x, const std::size_t n_nodes) {
  std::vector<double> shares(n_nodes, 0.);
  double sum = 0.;
  for (std::size_t i = 0; i < n_nodes; ++i) {
    const double node = -std::cos(pi * static_cast<double>(i) / static_cast<double>(n_nodes - 1));
    if (std::abs(x - node) < 1e-13) {
      std::fill(shares.begin(), shares.end(), 0.);
      shares[i] = 1.;
      return shares;
    }
    const bool is_end = i == 0 || i + 1 == n_nodes;
    shares[i] = (i % 2 == 0 ? 1. : -1.) * (is_end ? 0.5 : 1.) / (x - node);
    sum += shares[i];
  }
  for (double& share : shares) share /= sum;
  return shares;
}

/// A table by inner radius, Poisson's ratio and place, and where the inner radius is in it.
struct KernelTable {
  const double (*entries)[2];
  std::size_t n_radii;
  std::size_t n_ratios;
  std::size_t n_places;
  double place_step;
  double x;  ///< of the inner radius, from -1 to 1
};

void require_range(const char* const name, const double value, const double least,
                   const double greatest) {
  if (value >= least && value <= greatest) return;
  throw base::InputError(
      fmt::format("the {} is {:.4g} of the pin's: from {:.2g} to {:.2g} is known", name, value,
                  least, greatest));
}

KernelTable table_of(const PinInside inside, const double inner_radius) {
  constexpr double greatest_bore = 0.7;
  constexpr double least_core = 0.1;
  switch (inside) {
    case PinInside::hollow:
      require_range("radius of the bore", inner_radius, 0., greatest_bore);
      return {hollow_kernel_table,
              n_hollow_radii,
              n_hollow_ratios,
              n_hollow_places,
              0.2,
              2. * std::log1p(-inner_radius) / std::log1p(-greatest_bore) - 1.};
    case PinInside::held_core:
      require_range("radius of the core", inner_radius, least_core, 1. - least_core);
      return {core_held_kernel_table,
              n_core_held_radii,
              n_core_held_ratios,
              n_core_held_places,
              0.2,
              std::log(inner_radius / (1. - inner_radius)) / std::log(1. / least_core - 1.)};
    case PinInside::solid:
      break;
  }
  return {cylinder_kernel_table, 1, n_kernel_ratios, n_kernel_places, 0.1, 0.};
}

}  // namespace

CylinderKernel::CylinderKernel(const double poissons_ratio, const PinInside inside,
                               const double inner_radius)
    : poissons_ratio_(poissons_ratio),
      inner_radius_(inside == PinInside::hollow ? inner_radius : 0.) {
  if (!(poissons_ratio >= 0. && poissons_ratio <= 0.5))
    throw base::InputError(
        fmt::format("the pin's Poisson's ratio is {:.4g}, from 0 to 0.5 is known", poissons_ratio));
  const KernelTable table = table_of(inside, inner_radius);
  const std::vector<double> of_radius =
      table.n_radii == 1 ? std::vector<double>{1.} : shares_at(table.x, table.n_radii);
  const std::vector<double> of_ratio = shares_at(4. * poissons_ratio - 1., table.n_ratios);
  place_step_ = table.place_step;
  for (std::size_t i = 0; i < table.n_places; ++i) places_.push_back(place(i, place_step_));
  values_.assign(table.n_places, 0.);
  slopes_.assign(table.n_places, 0.);
  for (std::size_t radius = 0; radius < table.n_radii; ++radius)
    for (std::size_t ratio = 0; ratio < table.n_ratios; ++ratio)
      for (std::size_t i = 0; i < table.n_places; ++i) {
        const auto& [value, slope] =
            table.entries[(radius * table.n_ratios + ratio) * table.n_places + i];
        values_[i] += of_radius[radius] * of_ratio[ratio] * value;
        slopes_[i] += of_radius[radius] * of_ratio[ratio] * slope;
      }
}

/// Of a tube by the expansion of its compliance for long waves.
double CylinderKernel::shear_factor() const {
  const double nu = poissons_ratio_;
  const double m = inner_radius_ * inner_radius_;
  const double of_tube =
      (34. + 36. * nu + 4. * nu * nu) * m + (7. + 12. * nu + 4. * nu * nu) * m * m;
  const double around = (1. + nu) * (1. + m);
  return (7. - 8. * nu * nu + of_tube) / (6. * around * around);
}

/// Beyond the table V grows as -(1 - nu^2)/pi ln z, half of a half-space's.
double CylinderKernel::integral(const double z) const {
  const double nu = poissons_ratio_;
  const double end = places_.back();
  const double size = std::min(std::abs(z), end);
  if (size == 0.) return 0.;
  const auto i = std::min(static_cast<std::size_t>(std::asinh(size / place_scale) / place_step_),
                          values_.size() - 2);
  const double width = places_[i + 1] - places_[i];
  const double x = (size - places_[i]) / width;
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
