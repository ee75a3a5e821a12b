#include "loads/pin/slab_kernel.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace geneva::loads::test {
namespace {

TEST(SlabKernel, IsItsTableAtTheTablesRatios) {
  for (std::size_t ratio = 0; ratio < n_slab_ratios; ++ratio) {
    const SlabKernel kernel(slab_ratios[ratio]);
    EXPECT_NEAR(kernel.entry(0, 2), slab_even[ratio][0][1], 1e-12);
    EXPECT_NEAR(kernel.entry(1, 1), slab_odd[ratio][0][0], 1e-12);
    EXPECT_NEAR(kernel.entry(9, 5), slab_odd[ratio][4][2], 1e-12);
  }
}

TEST(SlabKernel, IsSymmetricByBothPlacesAndByTheMiddlePlane) {
  const SlabKernel kernel(0.25);
  const auto at = [](const double zeta) { return SlabKernel::polynomials(zeta); };
  EXPECT_NEAR(kernel.value(at(0.3), at(-0.8)), kernel.value(at(-0.8), at(0.3)), 1e-14);
  EXPECT_NEAR(kernel.value(at(0.3), at(-0.8)), kernel.value(at(-0.3), at(0.8)), 1e-14);
}

/// Smooth between the ratios: the middle of three neighbours by a parabola.
TEST(SlabKernel, IsInterpolatedSmoothly) {
  const auto entry = [](const double ratio) { return SlabKernel(ratio).entry(1, 1); };
  const double parabola = (3. * entry(0.2) + 6. * entry(0.3) - entry(0.4)) / 8.;
  EXPECT_NEAR(entry(0.25), parabola, 2e-3 * parabola);
  EXPECT_GT(entry(0.5), entry(0.48));
}

TEST(SlabKernel, PolynomialsAreLegendres) {
  const auto at = SlabKernel::polynomials(0.4);
  EXPECT_NEAR(at[2], (3. * 0.16 - 1.) / 2., 1e-15);
  EXPECT_NEAR(at[3], (5. * 0.064 - 3. * 0.4) / 2., 1e-15);
  for (const double value : SlabKernel::polynomials(1.)) EXPECT_NEAR(value, 1., 1e-14);
}

TEST(SlabKernel, KnowsPoissonsRatiosFromZeroOn) {
  EXPECT_THROW(SlabKernel(-0.1), base::InputError);
  EXPECT_THROW(SlabKernel(0.6), base::InputError);
}

TEST(ImageFactor, GrowsWithPoissonsRatio) {
  EXPECT_NEAR(image_factor(0.3), 1.39, 1e-12);
  EXPECT_NEAR(image_factor(0.), 1.21, 1e-12);
}

}  // namespace
}  // namespace geneva::loads::test
