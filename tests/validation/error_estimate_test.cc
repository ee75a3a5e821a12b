#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fem/adaptivity/force_error.h"
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

/// A displacement that presses: the force is that of a stiffer model, and the pressure would go
/// with its root. Pressed by the force that fine meshes show, the contact has the same pressure.
TEST(ErrorEstimate, HoldsUnderAPrescribedDisplacement) {
  LineContact contact;
  const mesh::MeshData<2> mesh = mesh_of(contact);
  fem::Problem<2> problem = problem_of(contact);
  ASSERT_EQ(problem.ties.size(), 1U);
  problem.supports.push_back({problem.ties[0].surface, {0., -1.5e-6}});
  problem.ties.clear();
  const fem::Solution<2> fine = solve(mesh, problem, with_accuracy(5e-4));
  contact.force = std::abs(fine.contacts.front().force[1]);
  const double excess = fem::force_excess(fine.history.back().energy_error);
  const double exact = hertz(contact).peak_pressure / std::sqrt(1. + excess);
  for (const double accuracy : {0.02, 0.005}) {
    const fem::Solution<2> solution = solve(mesh, problem, with_accuracy(accuracy));
    const double neglected = std::pow(hertz(contact).half_width / contact.radius, 2);
    const double of_force = fem::force_doubt(fine.history.back().energy_error);
    EXPECT_LE(std::abs(error_of(peak_pressure(solution), exact)),
              solution.error_estimate + neglected + of_force);
    EXPECT_LE(solution.error_estimate, accuracy);
    if (prints())
      std::printf("force %.6g N, excess %.3f %%; peak %+.4f of %.4f %%\n", contact.force,
                  100. * excess, 100. * error_of(peak_pressure(solution), exact),
                  100. * solution.error_estimate);
  }
}

}  // namespace
}  // namespace geneva::test
