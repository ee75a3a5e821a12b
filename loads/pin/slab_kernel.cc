#include "loads/pin/slab_kernel.h"

#include <fmt/format.h>

#include <cstddef>

#include "base/errors.h"

namespace geneva::loads {

namespace {

/// Lagrange's polynomials of the tabulated ratios at another.
std::array<double, n_slab_ratios> weights(const double ratio) {
  std::array<double, n_slab_ratios> result{};
  for (std::size_t i = 0; i < n_slab_ratios; ++i) {
    result[i] = 1.;
    for (std::size_t j = 0; j < n_slab_ratios; ++j)
      if (j != i) result[i] *= (ratio - slab_ratios[j]) / (slab_ratios[i] - slab_ratios[j]);
  }
  return result;
}

SlabMatrix interpolated(const std::array<SlabMatrix, n_slab_ratios>& table,
                        const std::array<double, n_slab_ratios>& shares) {
  SlabMatrix result{};
  for (std::size_t ratio = 0; ratio < n_slab_ratios; ++ratio)
    for (std::size_t i = 0; i < result.size(); ++i)
      for (std::size_t j = 0; j < result.size(); ++j)
        result[i][j] += shares[ratio] * table[ratio][i][j];
  return result;
}

}  // namespace

SlabKernel::SlabKernel(const double poissons_ratio) {
  if (!(poissons_ratio >= 0. && poissons_ratio <= 0.5))
    throw base::InputError(fmt::format(
        "Poisson's ratio of the wheel is {:.6g}: from 0 to 0.5 is wanted", poissons_ratio));
  const auto shares = weights(poissons_ratio);
  even_ = interpolated(slab_even, shares);
  odd_ = interpolated(slab_odd, shares);
}

SlabKernel::Polynomials SlabKernel::polynomials(const double zeta) {
  Polynomials result{1., zeta};
  for (std::size_t n = 2; n < result.size(); ++n) {
    const auto order = static_cast<double>(n);
    result[n] = ((2. * order - 1.) * zeta * result[n - 1] - (order - 1.) * result[n - 2]) / order;
  }
  return result;
}

double SlabKernel::value(const Polynomials& here, const Polynomials& there) const {
  double sum = 0.;
  for (std::size_t i = 0; i < even_.size(); ++i)
    for (std::size_t j = 0; j < even_.size(); ++j)
      sum += even_[i][j] * here[2 * i] * there[2 * j] +
             odd_[i][j] * here[2 * i + 1] * there[2 * j + 1];
  return sum;
}

double image_factor(const double poissons_ratio) {
  return 1.29 - (0.08 - poissons_ratio / 2.) / (1. - poissons_ratio);
}

}  // namespace geneva::loads
