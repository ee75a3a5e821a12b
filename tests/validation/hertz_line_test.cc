#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/solving.h"
#include "tests/support/structured_mesh.h"

/// A cylinder on a block beside Hertz's line contact: K. L. Johnson, Contact Mechanics, 1985,
/// Eq. 4.43 (half-width), 4.44 (pressure), 4.45 (peak) and 4.49 (stresses, after McEwen).
///
/// Tolerances: the cases ask for a peak pressure within 0.5 % (the default accuracy), which bounds
/// the peak. Hertz takes both bodies for half-planes: with R/b = 186 that neglects (b/R)^2 = 3e-5
/// of the pressure. The half-width follows from the force, p0 b = 2 F/(pi t), and from where
/// between two nodes the contact ends: a fifth of one of the 20 and more edges to either side is 2
/// %.
namespace geneva::test {
namespace {

constexpr double peak_tolerance = 0.005;
constexpr double width_tolerance = 0.02;

TEST(JohnsonContactMechanics, Eq443And445CylinderOnBlock) {
  const LineContact contact;
  const fem::Solution<2> solution = solve(contact);
  EXPECT_EQ(solution.stop.outcome, fem::Outcome::converged);
  EXPECT_LE(solution.error_estimate, 0.005);
  EXPECT_NEAR(error_of(peak_pressure(solution), hertz(contact).peak_pressure), 0., peak_tolerance);
  EXPECT_NEAR(error_of(solution.contacts[0].half_width, hertz(contact).half_width), 0.,
              width_tolerance);
  EXPECT_EQ(solution.contacts[0].max_penetration, 0.);
}

/// Maximum number of iterations of an active-set step on the last mesh.
unsigned int most_iterations(const fem::Solution<2>& solution) {
  const auto& iterations = solution.history.back().linear_iterations;
  return *std::max_element(iterations.begin(), iterations.end());
}

/// Bilinear cells without more would lock: 17 % too high at nu = 0.499. Point smoothers would take
/// hundreds of iterations.
TEST(JohnsonContactMechanics, Eq443And445NearlyIncompressibleCylinderOnBlock) {
  for (const double nu : {0.499, 0.4999}) {
    LineContact contact;
    contact.cylinder.poissons_ratio = nu;
    contact.block.poissons_ratio = nu;
    const fem::Solution<2> solution = solve(contact);
    EXPECT_EQ(solution.stop.outcome, fem::Outcome::converged);
    EXPECT_NEAR(error_of(peak_pressure(solution), hertz(contact).peak_pressure), 0.,
                peak_tolerance);
    EXPECT_LE(most_iterations(solution), 3U);
  }
}

/// Forces that give the same contact on the same bodies: the softer one's stiffness decides.
/// Multigrid alone does not converge from a ratio of 1e5 on.
TEST(JohnsonContactMechanics, Eq445StiffCylinderOnSoftBlock) {
  for (const double ratio : {1e3, 1e6, 1e8})
    for (const bool block_is_source : {false, true}) {
      LineContact contact;
      contact.block.youngs_modulus /= ratio;
      contact.force *= 2. / ratio;
      contact.block_is_source = block_is_source;
      const fem::Solution<2> solution = solve(contact);
      EXPECT_EQ(solution.stop.outcome, fem::Outcome::converged) << ratio;
      EXPECT_NEAR(error_of(peak_pressure(solution), hertz(contact).peak_pressure), 0.,
                  peak_tolerance)
          << ratio;
      EXPECT_LE(most_iterations(solution), 3U) << ratio;
    }
}

TEST(JohnsonContactMechanics, ClosedFormOfTheSolutionIsThatOfItsInput) {
  const LineContact contact;
  const fem::Solution<2> solution = solve(contact);
  const post::Results<2> results = post::analyse(solution);
  ASSERT_TRUE(results.contacts[0].hertz.has_value());
  const post::ClosedForm& form = *results.contacts[0].hertz;
  // The force comes from the solution, which carries it to the solver's 1e-10.
  EXPECT_NEAR(error_of(form.peak_pressure(), hertz(contact).peak_pressure), 0., 1e-9);
  EXPECT_NEAR(error_of(form.half_width(), hertz(contact).half_width), 0., 1e-9);
  EXPECT_LT(results.equilibrium.force_residual, 1e-9);
  EXPECT_LT(results.equilibrium.moment_residual, 1e-9);
  const double force = std::abs(solution.contacts[0].force[1]);
  EXPECT_LT(std::abs(solution.contact_couple), 1e-9 * force * solution.scales.length)
      << "either body feels the pressure at the same place";
}

TEST(JohnsonContactMechanics, Eq443And445CylinderInConcaveGroove) {
  // 1/R = 1/R1 - 1/(1.5 R1): a cylinder of three times the radius on a flat.
  const LineContact contact;
  mesh::MeshData<2> mesh = empty_mesh();
  const double R = contact.radius;
  const double pi = std::acos(-1.);
  add_ring(mesh, "cylinder",
           {{0., R},
            equal_steps(0.25 * R, R, 3),
            equal_steps(0., 2. * pi, 30),
            "core",
            "cylinder",
            "",
            ""});
  add_ring(mesh, "block",
           {{0., 1.5 * R},
            {1.5 * R, 2. * R, 3. * R, 5. * R},
            equal_steps(0.1, 0.1 + 2. * pi, 36),
            "top",
            "bottom",
            "",
            ""});
  const auto exact = loads::hertz_line(contact.force / contact.thickness, 3. * R,
                                       loads::contact_modulus({2e11, 0.3}, {2e11, 0.3}));
  for (const bool block_is_source : {false, true}) {
    LineContact either = contact;
    either.block_is_source = block_is_source;
    const fem::Solution<2> solution = solve(mesh, problem_of(either));
    EXPECT_NEAR(error_of(peak_pressure(solution), exact.peak_pressure), 0., peak_tolerance);
    EXPECT_NEAR(error_of(solution.contacts[0].half_width, exact.half_width), 0., width_tolerance);
    const auto form = post::closed_form(solution, solution.contacts[0]);
    ASSERT_TRUE(form.has_value());
    EXPECT_NEAR(error_of(form->peak_pressure(), exact.peak_pressure), 0., 1e-9);
  }
}

/// In the middles of the cells the stress is as accurate as the pressure is asked to be; as a
/// field, with what lies between the nodes, it is half as much again off. The cylinder is no
/// half-plane: a disc under opposite forces carries F/(pi R t) = p0 b/(2 R) across the load beside
/// the half-plane's field (Timoshenko and Goodier, Theory of Elasticity, section 41), and a ring on
/// a core about twice that: b/R = 0.54 %.
TEST(McEwen, Eq449StressFieldBelowTheContact) {
  const LineContact contact;
  const post::Results<2> results = post::analyse(solve(contact));
  ASSERT_TRUE(results.contacts[0].difference.has_value());
  const double finite_size = hertz(contact).half_width / contact.radius;
  EXPECT_LT(results.contacts[0].difference->target_body, 0.0075) << "block";
  EXPECT_LT(results.contacts[0].difference->source_body, 0.0075 + finite_size) << "cylinder";
}

/// 0.300 p0 at 0.786 b. A stress of b/R p0 across the load adds half of it to the maximum shear,
/// which is 1.7 b/R of 0.3 p0. The depth of a flat maximum is the square root as uncertain as its
/// value: the shear falls by 0.3 (dz/z)^2, and 0.05 % of the value is 4 % of the depth.
TEST(McEwen, Eq449MaximumShearAndItsDepth) {
  const LineContact contact;
  const post::Results<2> results = post::analyse(solve(contact));
  const double finite_size = hertz(contact).half_width / contact.radius;
  const auto& analysis = results.contacts[0];
  EXPECT_NEAR(error_of(analysis.max_shear.value, hertz(contact).max_shear), 0.,
              0.005 + 1.7 * finite_size);
  EXPECT_NEAR(error_of(analysis.max_shear_depth, hertz(contact).max_shear_depth), 0., 0.04);
}

/// Meshes of which no node faces another, the target 0.7 and 1.4 times as coarse as the source.
/// A pressure that ripples with the meshes shows here: away from the ends of the contact, where one
/// edge holds the whole fall of the pressure, it is to stay within 1 % of p0 (twice the accuracy
/// asked for by default; 0.2 % is asked for here).
TEST(JohnsonContactMechanics, Eq444PressureOnMeshesThatDoNotMatch) {
  if (prints()) std::printf("target/source  peak error %%  deviation %% of p0\n");
  for (const double ratio : {0.7, 1.4}) {
    LineContact contact;
    contact.turn = 0.17;
    contact.shift = 0.31;
    contact.block_cell = ratio * 2. * std::acos(-1.) / contact.cells_around;
    const fem::Solution<2> solution = solve(contact, with_accuracy(0.002));
    const double error = error_of(peak_pressure(solution), hertz(contact).peak_pressure);
    const double deviation = pressure_deviation(solution, hertz(contact), 0.9);
    if (prints()) std::printf("%13.1f  %12.3f  %17.3f\n", ratio, 100. * error, 100. * deviation);
    EXPECT_NEAR(error, 0., peak_tolerance);
    EXPECT_LT(deviation, 0.01);
  }
}

/// "No hanging node in the contact zone": neighbouring nodes in contact are equally far apart on
/// any pair of meshes, since the pressure would ripple where the distance doubles.
TEST(Refinement, IsEvenThroughoutTheContact) {
  for (const double block_cell : {0.18, 0.26, 0.37, 0.5, 0.75})
    for (const bool block_is_source : {false, true}) {
      LineContact contact;
      contact.block_cell = block_cell;
      contact.block_is_source = block_is_source;
      const fem::Solution<2> solution = solve(contact);
      // Chords of equal angle are equal; the block's grid is even.
      EXPECT_NEAR(unevenness(solution.contacts[0]), 1., 0.01)
          << "cells of the block " << block_cell << " R, source: " << solution.contacts[0].source;
    }
}

TEST(JohnsonContactMechanics, Eq445SourceAndTargetMayBeSwapped) {
  LineContact contact;
  contact.turn = 0.17;
  contact.shift = 0.31;
  contact.block_cell = 0.3;
  const fem::Settings settings = with_accuracy(0.001);
  const fem::Solution<2> first = solve(contact, settings);
  contact.block_is_source = true;
  const fem::Solution<2> second = solve(contact, settings);
  EXPECT_LE(std::abs(error_of(peak_pressure(second), peak_pressure(first))),
            first.error_estimate + second.error_estimate)
      << "which are 0.1 % at most";
}

TEST(JohnsonContactMechanics, Eq445FourTimesTheForceGivesTwiceThePressure) {
  LineContact contact;
  const double first = peak_pressure(solve(contact));
  contact.force *= 4.;
  const double second = peak_pressure(solve(contact));
  EXPECT_NEAR(error_of(second, 2. * first), 0., peak_tolerance);
}

TEST(JohnsonContactMechanics, Eq445PlaneStressHasItsOwnModulus) {
  LineContact contact;
  contact.plane = fem::PlaneKind::plane_stress;
  const fem::Solution<2> solution = solve(contact);
  EXPECT_NEAR(error_of(peak_pressure(solution), hertz(contact).peak_pressure), 0., peak_tolerance);
  EXPECT_NEAR(error_of(solution.contacts[0].half_width, hertz(contact).half_width), 0.,
              width_tolerance);
  LineContact strain;
  EXPECT_NEAR(hertz(strain).peak_pressure / hertz(contact).peak_pressure, 1. / std::sqrt(1. - 0.09),
              1e-12)
      << "the two differ by more than the tolerance";
}

TEST(JohnsonContactMechanics, Eq445DissimilarMaterials) {
  for (const bool block_is_source : {false, true}) {
    LineContact contact;
    contact.cylinder = {2.1e11, 0.3};
    contact.block = {7e10, 0.33};
    contact.block_is_source = block_is_source;
    const fem::Solution<2> solution = solve(contact);
    // Without friction the mismatch of the materials does not enter but through E*.
    EXPECT_NEAR(error_of(peak_pressure(solution), hertz(contact).peak_pressure), 0.,
                peak_tolerance);
    EXPECT_NEAR(error_of(solution.contacts[0].half_width, hertz(contact).half_width), 0.,
                width_tolerance);
  }
}

/// Symmetries that hold on any mesh, converged or not: the solver stops at 1e-10 of the load.
TEST(Symmetry, AMirroredProblemHasTheSamePressure) {
  LineContact contact;
  contact.turn = 0.17;
  contact.shift = 0.31;
  contact.block_cell = 0.3;
  const fem::Solution<2> plain = solve(contact);
  const fem::Solution<2> mirror = solve(mirrored(mesh_of(contact)), problem_of(contact));
  EXPECT_NEAR(error_of(peak_pressure(mirror), peak_pressure(plain)), 0., 1e-8);
  EXPECT_NEAR(error_of(mirror.contacts[0].half_width, plain.contacts[0].half_width), 0., 1e-8);
  EXPECT_EQ(mirror.contacts[0].active_nodes, plain.contacts[0].active_nodes);
  EXPECT_EQ(mirror.history.back().dofs, plain.history.back().dofs);
}

/// The same problem with its numbers in another unit system.
struct UnitSystem {
  const char* name;
  double length;  ///< its unit [m]
  double force;   ///< its unit [N]
};

TEST(Symmetry, UnitsDoNotMatter) {
  const LineContact contact;
  fem::Settings settings;
  settings.linear_tolerance = 1e-12;  // inputs that differ in their last bits stop elsewhere
  const fem::Solution<2> metres = solve(contact, settings);
  for (const UnitSystem& unit : {UnitSystem{"millimetres, newtons", 1e-3, 1.},
                                 UnitSystem{"inches, pounds-force", 0.0254, 4.4482216152605}}) {
    const double stress = unit.force / (unit.length * unit.length);
    fem::Problem<2> problem = problem_of(contact);
    problem.thickness /= unit.length;
    for (fem::Body<2>& body : problem.bodies) body.material.youngs_modulus /= stress;
    problem.ties[0].force /= unit.force;
    const fem::Solution<2> solution =
        solve(enlarged(mesh_of(contact), 1. / unit.length), problem, settings);
    EXPECT_NEAR(error_of(peak_pressure(solution) * stress, peak_pressure(metres)), 0., 1e-10)
        << unit.name;
    EXPECT_NEAR(
        error_of(solution.contacts[0].half_width * unit.length, metres.contacts[0].half_width), 0.,
        1e-10)
        << unit.name;
    ASSERT_EQ(solution.history.size(), metres.history.size()) << unit.name;
    for (std::size_t i = 0; i < metres.history.size(); ++i) {
      EXPECT_EQ(solution.history[i].dofs, metres.history[i].dofs) << unit.name;
      EXPECT_EQ(solution.history[i].active_nodes, metres.history[i].active_nodes) << unit.name;
      EXPECT_EQ(solution.history[i].linear_iterations.size(),
                metres.history[i].linear_iterations.size())
          << unit.name << ": active-set steps";
    }
  }
}

}  // namespace
}  // namespace geneva::test
