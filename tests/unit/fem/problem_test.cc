#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "fem/conditioning.h"
#include "fem/contact_problem.h"
#include "fem/problem/load.h"
#include "fem/problem/problem_check.h"
#include "fem/problem/scaling.h"
#include "fem/problem/source_sides.h"
#include "mesh/extrusion.h"
#include "tests/support/line_contact.h"
#include "tests/support/refusal.h"
#include "tests/support/structured_mesh.h"

namespace geneva::fem::test {
namespace {

using geneva::test::LineContact;
using loads::test::expect_refused;

const mesh::MeshData<2>& mesh() {
  static const mesh::MeshData<2> data = mesh_of(LineContact());
  return data;
}

Problem<2> problem() { return problem_of(LineContact()); }

/// Every field has another value, so that a forgotten one shows.
Problem<2> full_problem() {
  Problem<2> full = problem();
  full.thickness = 0.02;
  full.bodies[0].force.uniform = {3e4, -7e4};
  full.bodies[0].force.acceleration = {0.7, -9.81};
  full.bodies[0].force.rotation = {2e-3, 10., 300.};
  full.bodies[0].density = 7850.;
  full.supports = {{"bottom", {1e-6, std::nullopt}}, {"core", {std::nullopt, -2e-6}}};
  full.loads = {{"top", 1e6, {2e5, -3e5}}};
  full.ties = {{"core", {0.6, -0.8}, 500.}};
  return full;
}

void expect_same(const Problem<2>& a, const Problem<2>& b) {
  // Two roundings: a division and the multiplication that undoes it.
  const auto same = [](const double x, const double y) { EXPECT_NEAR(x, y, 1e-15 * std::abs(y)); };
  same(a.thickness, b.thickness);
  for (std::size_t i = 0; i < b.bodies.size(); ++i) {
    same(a.bodies[i].material.youngs_modulus, b.bodies[i].material.youngs_modulus);
    EXPECT_EQ(a.bodies[i].material.poissons_ratio, b.bodies[i].material.poissons_ratio);
    same(a.bodies[i].density, b.bodies[i].density);
    same(a.bodies[i].force.acceleration[0], b.bodies[i].force.acceleration[0]);
    same(a.bodies[i].force.acceleration[1], b.bodies[i].force.acceleration[1]);
    same(a.bodies[i].force.rotation.inertia, b.bodies[i].force.rotation.inertia);
    EXPECT_EQ(a.bodies[i].force.rotation.speed, b.bodies[i].force.rotation.speed);
    EXPECT_EQ(a.bodies[i].force.rotation.acceleration, b.bodies[i].force.rotation.acceleration);
    for (std::size_t c = 0; c < 2; ++c)
      same(a.bodies[i].force.uniform[c], b.bodies[i].force.uniform[c]);
  }
  for (std::size_t i = 0; i < b.supports.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c) {
      ASSERT_EQ(a.supports[i].displacement[c].has_value(),
                b.supports[i].displacement[c].has_value());
      if (b.supports[i].displacement[c])
        same(*a.supports[i].displacement[c], *b.supports[i].displacement[c]);
    }
  same(a.loads[0].pressure, b.loads[0].pressure);
  for (std::size_t c = 0; c < 2; ++c) {
    same(a.loads[0].traction[c], b.loads[0].traction[c]);
    EXPECT_EQ(a.ties[0].direction[c], b.ties[0].direction[c]);
  }
  same(a.ties[0].force, b.ties[0].force);
}

TEST(Load, OfNoSharesIsTheWholeLoad) {
  expect_same(at_instant(full_problem(), {}), full_problem());
}

TEST(Load, TakesItsShareOfEveryPart) {
  const std::size_t n_bodies = full_problem().bodies.size();
  const Problem<2> part =
      at_instant(full_problem(), {std::vector<double>(n_bodies, 0.5), {-1.}, {0.25}, {2., 0.}});
  Problem<2> expected = full_problem();
  expected.bodies[0].force = {{1.5e4, -3.5e4}, {0.35, -4.905}, {1e-3, 10., 300.}};
  expected.loads = {{"top", -1e6, {-2e5, 3e5}}};
  expected.ties[0].force = 125.;
  expected.supports = {{"bottom", {2e-6, std::nullopt}}, {"core", {std::nullopt, 0.}}};
  expect_same(part, expected);
}

TEST(Load, RefusesAListOfAnotherLength) {
  EXPECT_THROW(at_instant(full_problem(), {{}, {}, {1., 1.}, {}}), std::invalid_argument);
}

TEST(Scaling, UnitsAreTheMaximumExtentAndModulus) {
  Problem<2> other = problem();
  other.bodies[1].material.youngs_modulus = 3e11;
  const Scales scales = scales_of(other, mesh());
  EXPECT_DOUBLE_EQ(scales.length, 0.08) << "the block's width, 8 R";
  EXPECT_EQ(scales.stress, 3e11);
  EXPECT_DOUBLE_EQ(scales.force(), 3e11 * 0.08 * 0.08);
}

TEST(Scaling, BackAndForthChangesNothing) {
  const Scales scales{0.08, 3e11};
  expect_same(scaled(scaled(full_problem(), scales), {1. / scales.length, 1. / scales.stress}),
              full_problem());
}

TEST(Scaling, DividesByTheUnitOfEveryQuantity) {
  const Scales scales{2., 10.};
  const Problem<2> full = full_problem();
  const Problem<2> small = scaled(full, scales);
  EXPECT_DOUBLE_EQ(small.thickness, full.thickness / 2.);
  EXPECT_DOUBLE_EQ(small.bodies[0].material.youngs_modulus, 2e10);
  EXPECT_DOUBLE_EQ(small.bodies[0].force.uniform[0], 3e4 * 2. / 10.) << "force per volume";
  EXPECT_DOUBLE_EQ(small.bodies[0].density * small.bodies[0].force.acceleration[1],
                   7850. * -9.81 * 2. / 10.)
      << "force per volume";
  EXPECT_DOUBLE_EQ(small.bodies[0].force.rotation.inertia, 2e-3 / 80.) << "J alpha is a moment";
  EXPECT_DOUBLE_EQ(*small.supports[0].displacement[0], 0.5e-6);
  EXPECT_DOUBLE_EQ(small.loads[0].pressure, 1e5);
  EXPECT_DOUBLE_EQ(small.loads[0].traction[1], -3e4);
  EXPECT_DOUBLE_EQ(small.ties[0].force, 500. / 40.);
}

TEST(OrderBodies, PutsThemInTheMeshsOrder) {
  Problem<2> reversed = problem();
  std::swap(reversed.bodies[0], reversed.bodies[1]);
  order_bodies(reversed, mesh());
  EXPECT_EQ(reversed.bodies[0].name, "cylinder");
  EXPECT_EQ(reversed.bodies[1].name, "block");
}

TEST(OrderBodies, RefusesABodyWithoutMaterial) {
  Problem<2> incomplete = problem();
  incomplete.bodies.pop_back();
  expect_refused([&] { order_bodies(incomplete, mesh()); }, {"'block'", "no material"});
}

TEST(OrderBodies, RefusesAMaterialWithoutBody) {
  Problem<2> misspelt = problem();
  misspelt.bodies[0].name = "cylnder";
  expect_refused([&] { order_bodies(misspelt, mesh()); },
                 {"body 'cylnder' is not in the mesh", "'cylinder', 'block'"});
}

TEST(Check, AcceptsAGoodProblem) { EXPECT_NO_THROW(check(problem(), mesh())); }

/// Expects check() to refuse the problem after a change, with the parts in the message.
template <typename Change>
void expect_check_refuses(const Change& change, std::initializer_list<std::string> parts) {
  Problem<2> changed = problem();
  change(changed);
  expect_refused([&] { check(changed, mesh()); }, parts);
}

/// Expects an analysis to refuse the problem after a change, with the parts in the message.
template <typename Change>
void expect_analysis_refuses(const Change& change, std::initializer_list<std::string> parts) {
  Problem<2> changed = problem();
  change(changed);
  expect_refused([&] { solve_contact(MPI_COMM_WORLD, mesh(), changed, {}, {}); }, parts);
}

TEST(Conditioning, RefusesABodyThatIsFarTooStiffForAnother) {
  expect_analysis_refuses([](Problem<2>& p) { p.bodies[1].material.youngs_modulus = 20.; },
                          {"'cylinder'", "1e+10 times", "'block'", "1e+08 times", "2e+09 Pa"});
}

/// Not as a load that pulls them apart.
TEST(Conditioning, RefusesALoadThatRoundingsHide) {
  expect_analysis_refuses([](Problem<2>& p) { p.ties[0].force = 1e-20; },
                          {"load of 1e-20 N", "roundings"});
}

TEST(Conditioning, FactorisesWhatPointSmoothersCannotSmooth) {
  Problem<2> changed = problem();
  EXPECT_FALSE(is_factorised(changed));
  changed.bodies[1].material.poissons_ratio = 0.4999;
  EXPECT_TRUE(is_factorised(changed));
  changed.plane = PlaneKind::plane_stress;
  EXPECT_FALSE(is_factorised(changed)) << "thickness follows freely";
  changed.bodies[1].material.youngs_modulus /= 1000.;
  EXPECT_TRUE(is_factorised(changed));
}

TEST(Conditioning, WantsTheSofterBodyAsTheSourceInSpace) {
  const mesh::MeshData<3> slice = extruded(mesh(), {{{0., 1.}, "", ""}, {{0., 1.}, "", ""}});
  Problem<3> in_space;
  in_space.bodies = {{"cylinder", {2e11, 0.3}, {}}, {"block", {2e7, 0.3}, {}}};
  in_space.pairs = {{"cylinder", "top"}};
  expect_refused([&] { check_stiffness_ratio(in_space, slice); },
                 {"'cylinder'", "1e+04 times", "1e+03", "make 'top' the source"});
  in_space.pairs = {{"top", "cylinder"}};
  EXPECT_NO_THROW(check_stiffness_ratio(in_space, slice));
}

TEST(Check, RefusesNamesThatAreNotInTheMeshAndTellsWhatThereIs) {
  const auto known = "'core', 'cylinder', 'bottom', 'top'";
  expect_check_refuses([](Problem<2>& p) { p.supports[0].surface = "botom"; },
                       {"surface 'botom'", "not in the mesh", known});
  expect_check_refuses([](Problem<2>& p) { p.ties[0].surface = "kore"; },
                       {"surface 'kore'", known});
  expect_check_refuses(
      [](Problem<2>& p) {
        p.loads = {{"lid", 1., {0., 0.}}};
      },
      {"surface 'lid'", known});
  expect_check_refuses([](Problem<2>& p) { p.pairs[0].source = "rim"; }, {"surface 'rim'", known});
  expect_check_refuses([](Problem<2>& p) { p.pairs[0].target = "ground"; },
                       {"surface 'ground'", known});
  expect_check_refuses([](Problem<2>& p) { p.bodies[0].name = "pin"; },
                       {"body 'pin'", "'cylinder', 'block'"});
}

/// The part of the problem that a check refuses.
template <typename Change>
ProblemPart refused_part(const Change& change) {
  Problem<2> changed = problem();
  change(changed);
  try {
    check(changed, mesh());
  } catch (const ProblemError& error) {
    return error.part;
  }
  throw std::logic_error("not refused");
}

TEST(Check, TellsThePartThatItRefuses) {
  EXPECT_EQ(refused_part([](Problem<2>& p) { p.bodies[0].name = "pin"; }), ProblemPart::bodies);
  EXPECT_EQ(refused_part([](Problem<2>& p) { p.supports[0].surface = "botom"; }),
            ProblemPart::supports);
  EXPECT_EQ(refused_part([](Problem<2>& p) { p.ties[0].surface = "kore"; }), ProblemPart::loads);
  EXPECT_EQ(refused_part([](Problem<2>& p) { p.pairs[0].source = "tpo"; }), ProblemPart::pairs);
}

TEST(Check, RefusesTheSurfaceWithoutAName) {
  expect_check_refuses([](Problem<2>& p) { p.supports[0].surface = ""; }, {"surface ''"});
}

TEST(Check, WantsASupportOfABodyWithoutContact) {
  expect_check_refuses(
      [](Problem<2>& p) {
        p.pairs.clear();
        p.ties.clear();
      },
      {"body 'cylinder'", "neither a support nor a contact surface"});
}

TEST(Check, RefusesASurfaceThatTouchesItself) {
  expect_check_refuses(
      [](Problem<2>& p) {
        p.pairs[0] = {"top", "top"};
      },
      {"'top'", "cannot touch itself"});
}

TEST(Check, RefusesContactWithinABody) {
  expect_check_refuses(
      [](Problem<2>& p) {
        p.pairs[0] = {"top", "bottom"};
      },
      {"'top' and 'bottom'", "same body"});
}

TEST(Check, RefusesASurfaceThatIsTheSourceTwice) {
  expect_check_refuses(
      [](Problem<2>& p) {
        p.pairs.push_back({"cylinder", "bottom"});
      },
      {"'cylinder'", "source of two pairs", "target of one"});
}

TEST(Check, RefusesASurfaceThatIsSourceAndTarget) {
  expect_check_refuses(
      [](Problem<2>& p) {
        p.pairs.push_back({"bottom", "cylinder"});
      },
      {"'cylinder'", "source of one pair and the target of another"});
}

TEST(Check, RefusesAContactSurfaceOfTwoBodies) {
  mesh::MeshData<2> two = geneva::test::empty_mesh();
  for (const double left : {0., 2.})
    geneva::test::add_rectangle(two, left == 0. ? "a" : "b", {left, left + 1.}, {0., 1.},
                                {"", "", "lids", ""});
  geneva::test::add_rectangle(two, "c", {0., 3.}, {1., 2.}, {"under", "", "", ""});
  Problem<2> changed = problem();
  changed.bodies = {{"a", {1., 0.3}, {}}, {"b", {1., 0.3}, {}}, {"c", {1., 0.3}, {}}};
  changed.supports.clear();
  changed.ties.clear();
  changed.pairs = {{"under", "lids"}};
  expect_refused([&] { check(changed, two); }, {"'lids'", "belongs to 2 bodies"});
}

TEST(Check, RefusesABodyThatNothingHolds) {
  mesh::MeshData<2> three = mesh();
  geneva::test::add_rectangle(three, "stray", {1., 2.}, {0., 1.}, {"", "", "", ""});
  Problem<2> changed = problem();
  changed.bodies.push_back({"stray", {1., 0.3}, {}});
  expect_refused([&] { check(changed, three); }, {"'stray'", "nothing holds it"});
}

/// Expects solve_contact() to refuse a problem whose bodies can still move.
template <typename Change>
void expect_solver_refuses(const Change& change, std::initializer_list<std::string> parts) {
  Problem<2> changed = problem();
  change(changed);
  expect_refused([&] { solve_contact(MPI_COMM_WORLD, mesh(), changed, {}, {}); }, parts);
}

TEST(SolveContact, RefusesWhatCheckRefuses) {
  expect_solver_refuses(
      [](Problem<2>& p) {
        p.pairs[0] = {"top", "top"};
      },
      {"'top'", "cannot touch itself"});
}

TEST(SolveContact, RefusesABodyThatCanMoveAlongX) {
  expect_solver_refuses(
      [](Problem<2>& p) {
        p.supports = {{"bottom", {std::nullopt, 0.}}};
      },
      {"body '", "can move along x freely"});
}

TEST(SolveContact, RefusesACylinderThatCanRollAway) {
  expect_solver_refuses([](Problem<2>& p) { p.ties.clear(); }, {"body 'cylinder' can"});
}

TEST(SolveContact, RefusesSupportsThatContradictEachOther) {
  expect_solver_refuses(
      [](Problem<2>& p) {
        p.supports.push_back({"bottom", {std::nullopt, 1e-6}});
      },
      {"'bottom'", "different displacement"});
}

Problem<2> with_softer(const std::string& body) {
  Problem<2> result = problem();
  order_bodies(result, mesh());
  for (Body<2>& one : result.bodies)
    if (one.name == body) one.material.youngs_modulus /= 2.;
  return result;
}

TEST(SourceSides, TheSofterBodysSurfaceIsTheSourceWhicheverIsWrittenFirst) {
  for (const bool is_reversed : {false, true})
    for (const std::string soft : {"cylinder", "block"}) {
      Problem<2> given = with_softer(soft);
      if (is_reversed) std::swap(given.pairs[0].source, given.pairs[0].target);
      given.pairs[0].friction = {0.2, {1., 0., 0.}};
      const std::string first = given.pairs[0].source;
      take_softer_sources(given, mesh());
      EXPECT_EQ(given.pairs[0].source, soft == "block" ? "top" : "cylinder");
      EXPECT_EQ(given.pairs[0].target, soft == "block" ? "cylinder" : "top");
      EXPECT_EQ(given.pairs[0].friction.sliding[0], given.pairs[0].source == first ? 1. : -1.)
          << "the source's velocity against the target";
    }
}

TEST(SourceSides, BetweenEquallyStiffBodiesTheFirstIsTheSource) {
  Problem<2> given = problem();
  order_bodies(given, mesh());
  std::swap(given.pairs[0].source, given.pairs[0].target);
  take_softer_sources(given, mesh());
  EXPECT_EQ(given.pairs[0].source, "top");
}

TEST(SourceSides, PoissonsRatioIsMeanByComplianceAndLessInPlaneStress) {
  Problem<2> given = problem();
  order_bodies(given, mesh());
  // Compliances in the ratio 1 to 3 in plane strain, 1 to 4 in plane stress.
  given.bodies[0].material = {100., 0.};
  given.bodies[1].material = {25., 0.5};
  const auto ratio = [&] { return mean_poissons_ratio(mesh(), given, given.pairs[0]); };
  EXPECT_NEAR(ratio(), 0.75 * 0.5, 1e-15);
  std::swap(given.pairs[0].source, given.pairs[0].target);
  EXPECT_NEAR(ratio(), 0.75 * 0.5, 1e-15);
  given.plane = PlaneKind::plane_stress;
  EXPECT_NEAR(ratio(), 0.8 * (0.5 / 1.5), 1e-15);
}

TEST(SourceSides, ASurfaceInTwoPairsStaysTheirTarget) {
  Problem<2> given = with_softer("block");
  given.pairs = {{"cylinder", "top"}, {"core", "top"}};
  take_softer_sources(given, mesh());
  for (const ContactPair& pair : given.pairs) EXPECT_EQ(pair.target, "top");
}

TEST(SourceSides, ComplianceIsThatOfPlaneStrainOrPlaneStress) {
  Problem<2> given = problem();
  order_bodies(given, mesh());
  EXPECT_NEAR(compliance(mesh(), given, "top"), 0.91 / 2e11, 1e-26);
  given.plane = PlaneKind::plane_stress;
  EXPECT_NEAR(compliance(mesh(), given, "top"), 1. / 2e11, 1e-26);
}

}  // namespace
}  // namespace geneva::fem::test
