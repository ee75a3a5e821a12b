// Recovered stresses, the line below a contact, its frame and the checks, on contacts whose fields
// are known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "post/analysis/checks.h"
#include "post/analysis/contact_frame.h"
#include "post/analysis/depth_line.h"
#include "post/analysis/results.h"
#include "post/analysis/sliding_surface.h"
#include "tests/support/solving.h"
#include "tests/support/structured_mesh.h"

namespace geneva::post {
namespace {

using test::equal_steps;

constexpr double pressure = 50e6;  // [Pa]

/// A block on a block of the same material under an even pressure, in plane stress: everywhere
/// sigma_y = -p, and nothing else.
class Patch : public testing::Test {
 protected:
  Patch() : solution_(test::solve(mesh(), problem())), results_(analyse(solution_)) {}

  static mesh::MeshData<2> mesh() {
    mesh::MeshData<2> mesh = test::empty_mesh();
    test::add_rectangle(mesh, "upper", equal_steps(0., 0.02, 5), equal_steps(0., 0.01, 2),
                        {"lower face", "", "top", "upper side"});
    test::add_rectangle(mesh, "lower", equal_steps(0., 0.02, 4), equal_steps(-0.01, 0., 3),
                        {"base", "", "upper face", "lower side"});
    return mesh;
  }

  static fem::Problem<2> problem() {
    fem::Problem<2> problem;
    problem.plane = fem::PlaneKind::plane_stress;
    problem.thickness = 0.1;
    for (const char* const name : {"upper", "lower"}) {
      fem::Body<2> body;
      body.name = name;
      body.material = {2e11, 0.3};
      problem.bodies.push_back(body);
    }
    problem.supports = {{"base", {std::nullopt, 0.}},
                        {"upper side", {0., std::nullopt}},
                        {"lower side", {0., std::nullopt}}};
    problem.loads = {{"top", pressure, {}}};
    problem.pairs = {{"lower face", "upper face", {}}};
    return problem;
  }

  fem::Solution<2> solution_;
  Results<2> results_;
};

TEST(Invariants, OfAPlaneStateAreThoseOfItsPrincipalStresses) {
  fem::PlaneStress stress{};
  stress.in_plane[0][0] = 3.;
  stress.in_plane[1][1] = -1.;
  stress.in_plane[0][1] = 1.5;  // radius 2.5 around 1
  stress.out_of_plane = 4.;
  const auto principal = principal_stresses(stress);
  EXPECT_NEAR(principal[0], 4., 1e-15);
  EXPECT_NEAR(principal[1], 3.5, 1e-15);
  EXPECT_NEAR(principal[2], -1.5, 1e-15);
  EXPECT_NEAR(max_shear(principal), 2.75, 1e-15);
  EXPECT_NEAR(in_plane_shear(stress), 2.5, 1e-15) << "the larger stress lies out of the plane";
}

TEST(Invariants, VonMisesIsTheStressOfATensileTestAndRootThreeTimesAPureShear) {
  EXPECT_NEAR(von_mises({7., 0., 0.}), 7., 1e-15);
  EXPECT_NEAR(von_mises({2., 0., -2.}), 2. * std::sqrt(3.), 1e-15);
  EXPECT_EQ(von_mises({-5., -5., -5.}), 0.) << "even pressure";
}

TEST_F(Patch, IsFreeOfStressAlongItsSurfacesAsItIsFreeToWiden) {
  const auto stresses = surface_stresses(solution_, solution_.contacts.front());
  ASSERT_EQ(stresses.size(), solution_.contacts.front().nodes.size());
  for (const SurfaceStress& stress : stresses) {
    EXPECT_NEAR(stress.source, 0., 1e-7 * pressure);
    EXPECT_NEAR(stress.target, 0., 1e-7 * pressure);
  }
}

TEST_F(Patch, HasTheStressAlongItsSurfacesThatItsStrainAsksFor) {
  constexpr double strain = 1e-4;
  for (auto& node : solution_.contacts.front().nodes) node.strain = {strain, -strain};
  const double lateral = 0.3 * pressure;
  for (const SurfaceStress& stress : surface_stresses(solution_, solution_.contacts.front())) {
    EXPECT_NEAR(stress.source, 2e11 * strain - lateral, 1e-7 * pressure);
    EXPECT_NEAR(stress.target, -2e11 * strain - lateral, 1e-7 * pressure);
  }
  solution_.problem.plane = fem::PlaneKind::plane_strain;
  for (const SurfaceStress& stress : surface_stresses(solution_, solution_.contacts.front()))
    EXPECT_NEAR(stress.source, 2e11 / 0.91 * strain - lateral / 0.7, 1e-7 * pressure);
}

TEST_F(Patch, HasTheSameStressInAllCellsAndAtAllNodes) {
  for (const CellStress<2>& cell : results_.cells) {
    EXPECT_NEAR(cell.stress.in_plane[1][1], -pressure, 1e-6 * pressure);
    EXPECT_NEAR(cell.stress.in_plane[0][0], 0., 1e-6 * pressure);
    EXPECT_NEAR(cell.stress.in_plane[0][1], 0., 1e-6 * pressure);
    EXPECT_EQ(cell.stress.out_of_plane, 0.) << "plane stress";
  }
  for (const StressPeak<2>& peak : results_.max_von_mises)
    EXPECT_NEAR(peak.value, pressure, 1e-6 * pressure);
}

TEST_F(Patch, CellsCoverTheBodies) {
  double area = 0.;
  for (const CellStress<2>& cell : results_.cells) area += cell.measure;
  EXPECT_NEAR(dealii::Utilities::MPI::sum(area, MPI_COMM_WORLD), 2. * 0.02 * 0.01, 1e-15);
}

TEST_F(Patch, IsPressedEvenlyAlongTheDepth) {
  const PressureCentre centre{{0.01, 0.}, 0.01, dealii::Tensor<1, 2>({0., 1.})};
  fem::ContactResult<2> contact = solution_.contacts.front();
  contact.half_width = 0.002;  // four of them are less than the block is high
  const auto samples = depth_line(solution_, contact, centre, std::nullopt, results_.nodal);
  ASSERT_EQ(samples.size(), 97U);
  EXPECT_EQ(samples.front().depth, 0.);
  EXPECT_NEAR(samples.back().depth, 0.008, 1e-15);
  for (const DepthSample& sample : samples) {
    EXPECT_NEAR(sample.computed.across, -pressure, 1e-6 * pressure) << sample.depth;
    EXPECT_NEAR(sample.computed.along, 0., 1e-6 * pressure) << sample.depth;
    EXPECT_NEAR(sample.computed.shear, pressure / 2., 1e-6 * pressure) << sample.depth;
    EXPECT_FALSE(sample.closed_form);
  }
}

TEST_F(Patch, PassesAllChecks) {
  RunReport report{};
  report.accuracy = 0.005;
  const auto all = checks(solution_, results_, report);
  EXPECT_EQ(all.size(), 5U) << "no torque without a mechanism";
  for (const Check& check : all) EXPECT_TRUE(check.is_passed()) << check.name << check.value;
}

/// The names of the checks that a result does not pass.
std::vector<std::string> failed(const fem::Solution<2>& solution, const Results<2>& results,
                                const RunReport& report) {
  std::vector<std::string> names;
  for (const Check& check : checks(solution, results, report))
    if (!check.is_passed()) names.push_back(check.name);
  return names;
}

using Names = std::vector<std::string>;

TEST_F(Patch, FailsTheCheckOfWhatIsWrong) {
  RunReport report{};
  report.accuracy = 0.005;
  Results<2> unbalanced = std::move(results_);
  unbalanced.equilibrium.moment_residual = 1e-5;
  EXPECT_EQ(failed(solution_, unbalanced, report), Names{"balance of moments"});
  unbalanced.equilibrium.moment_residual = 0.;

  solution_.contacts.front().nodes.front().pressure = -1e-3 * pressure;
  EXPECT_EQ(failed(solution_, unbalanced, report), Names{"complementarity"}) << "a tension";
  solution_.contacts.front().nodes.front().pressure = pressure;

  solution_.error_estimate = 0.006;
  EXPECT_EQ(failed(solution_, unbalanced, report), Names{"convergence"});
  solution_.error_estimate = 0.;

  report.mechanism.emplace();
  report.mechanism->held_surface = "bore";
  report.mechanism->expected_bore_torque = 10.;
  report.mechanism->bore_torque = 10.1;
  EXPECT_EQ(failed(solution_, unbalanced, report), Names{"bore torque"});
}

/// Two cylinders of these radii, whose axes lie at an angle in the plane z = 0, pressed together by
/// four nodes around the origin.
struct CrossedCylinders {
  CrossedCylinders(const double first, const double second, const double angle) {
    solution.mesh.surfaces = {"", "first", "second"};
    solution.mesh.circles = {{{0., 0., first}, first, {1., 0., 0.}},
                             {{0., 0., -second}, second, {std::cos(angle), std::sin(angle), 0.}}};
    solution.problem.pairs = {{"first", "second", {}}};
    contact.source = "first";
    contact.target = "second";
    contact.source_circle = 0;
    contact.target_circle = 1;
    contact.source_is_convex = contact.target_is_convex = true;
    for (const auto& [x, y] : {std::pair(1e-4, 0.), {-1e-4, 0.}, {0., 2e-4}, {0., -2e-4}}) {
      fem::ContactNode<3> node{};
      node.position = {x, y, 0.};
      node.normal = {0., 0., 1.};
      node.pressure = 1e6;
      node.tributary = 1e-8;
      node.status = fem::NodeStatus::slip;
      contact.nodes.push_back(node);
    }
  }

  fem::Solution<3> solution;
  fem::ContactResult<3> contact{};
};

/// Johnson, Contact Mechanics, Eq. 4.3: A + B = (k1 + k2)/2 and
/// B - A = sqrt(k1^2 + k2^2 + 2 k1 k2 cos 2w)/2 for cylinders of curvatures k1, k2 at an angle w.
TEST(ContactFrame, OfCrossedCylindersHasTheirPrincipalCurvatures) {
  for (const double angle : {0., 0.3, 1., 1.5707963267948966, 2.5}) {
    const double k1 = 1. / 0.02;
    const double k2 = 1. / 0.05;
    const CrossedCylinders crossed(0.02, 0.05, angle);
    const ContactFrame frame = contact_frame(crossed.solution, crossed.contact);
    const double difference = std::sqrt(k1 * k1 + k2 * k2 + 2. * k1 * k2 * std::cos(2. * angle));
    EXPECT_NEAR(frame.curvature_across, (k1 + k2 + difference) / 2., 1e-9) << angle;
    EXPECT_NEAR(frame.curvature_along, (k1 + k2 - difference) / 2., 1e-9) << angle;
    EXPECT_NEAR(frame.across * frame.along, 0., 1e-15);
    EXPECT_NEAR(frame.normal[2], 1., 1e-15);
  }
}

TEST(ContactFrame, CountsFromTheCentreOfPressure) {
  CrossedCylinders crossed(0.02, 0.05, 0.);
  for (fem::ContactNode<3>& node : crossed.contact.nodes) node.position[0] += 0.003;
  const ContactFrame frame = contact_frame(crossed.solution, crossed.contact);
  EXPECT_NEAR(frame.centre[0], 0.003, 1e-15);
  EXPECT_NEAR(std::abs(frame.along[0]), 1., 1e-12) << "along the common axis";
  EXPECT_NEAR(frame.mean_square_along, 1e-8 / 2., 1e-18);
  EXPECT_NEAR(frame.mean_square_across, 4e-8 / 2., 1e-18);
  EXPECT_EQ(frame.parts(), 1.);
}

TEST(ContactFrame, IsEmptyWithoutAForce) {
  CrossedCylinders crossed(0.02, 0.05, 0.);
  for (fem::ContactNode<3>& node : crossed.contact.nodes) node.pressure = 0.;
  EXPECT_EQ(contact_frame(crossed.solution, crossed.contact).normal.norm(), 0.);
}

}  // namespace
}  // namespace geneva::post
