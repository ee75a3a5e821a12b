#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/solving.h"

namespace geneva::test {
namespace {

/// What was reported on a mesh beside what is true: Hertz's pressure, whose neglect is (b/R)^2 =
/// 3e-5.
struct Report {
  double error;  ///< true, relative
  double bar;
};

/// On every mesh that reports an error.
std::vector<Report> reports_of(const LineContact& contact, const double accuracy) {
  const loads::HertzLine exact = hertz(contact);
  std::vector<Report> reports;
  fem::Progress<2> watch;
  watch.solution = [&](const fem::Solution<2>& on_mesh) {
    if (on_mesh.error_estimate < 1.)
      reports.push_back({std::abs(error_of(peak_pressure(on_mesh), exact.peak_pressure)),
                         on_mesh.error_estimate});
  };
  (void)fem::solve_contact(MPI_COMM_WORLD, mesh_of(contact), problem_of(contact),
                           with_accuracy(accuracy), watch);
  return reports;
}

/// However the nodes lie, the true error lies within the reported one, on the last mesh and on
/// those before it; and the bar is not so wide that this says nothing.
TEST(ErrorEstimate, HoldsTheTrueErrorOnEveryMesh) {
  if (prints()) std::printf("around  shift  true error %%  estimate %%\n");
  double tightest = 0.;
  for (const unsigned int cells_around : {20U, 24U, 28U})
    for (const double shift : {0., 0.13, 0.31}) {
      LineContact contact;
      contact.cells_around = cells_around;
      contact.shift = shift;
      const double neglected = std::pow(hertz(contact).half_width / contact.radius, 2);
      const std::vector<Report> reports = reports_of(contact, 0.002);
      ASSERT_FALSE(reports.empty());
      for (const auto& [error, bar] : reports) {
        if (prints())
          std::printf("%6u  %5.2f  %10.4f  %10.4f\n", cells_around, shift, 100. * error,
                      100. * bar);
        EXPECT_LE(error, bar + neglected) << cells_around << " cells around, shift " << shift;
        tightest = std::max(tightest, error / bar);
      }
    }
  EXPECT_GT(tightest, 0.2);
}

}  // namespace
}  // namespace geneva::test
