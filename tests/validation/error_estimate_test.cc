#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/solving.h"

namespace geneva::test {
namespace {

/// The estimate that comes with a result is to be of use as an error bar: not smaller than half the
/// true error on any mesh that has one, however the nodes lie. Hertz neglects (b/R)^2 = 3e-5.
TEST(ErrorEstimate, IsNotSmallerThanHalfTheTrueError) {
  if (prints()) std::printf("around  shift  nodes  true error %%  estimate %%\n");
  for (const unsigned int cells_around : {20U, 24U, 28U})
    for (const double shift : {0., 0.13, 0.31}) {
      LineContact contact;
      contact.cells_around = cells_around;
      contact.shift = shift;
      const loads::HertzLine exact = hertz(contact);
      const double finite_size = std::pow(exact.half_width / contact.radius, 2);
      const fem::Solution<2> solution = solve(contact, with_accuracy(0.002));
      for (const fem::LevelRecord& level : solution.history) {
        if (level.error_estimate >= 1.) continue;
        const double error = std::abs(error_of(level.peak_pressure, exact.peak_pressure));
        if (prints())
          std::printf("%6u  %5.2f  %5u  %12.4f  %10.4f\n", cells_around, shift, level.active_nodes,
                      100. * error, 100. * level.error_estimate);
        EXPECT_GE(level.error_estimate, 0.5 * error - finite_size)
            << cells_around << " cells around, shift " << shift << ", " << level.active_nodes
            << " nodes";
      }
    }
}

}  // namespace
}  // namespace geneva::test
