#include "post/analysis/figures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace geneva;
using fem::Refined;
using post::Figure;
using post::Figures;

/// A mesh: what it refined, the cells' size measure, and the figures of the only contact on it.
struct Mesh {
  Refined refined;
  double size_measure;
  Figures figures;
};

/// Nodes in contact under a pressure, by the distance from the middle over the half-width 1e-3.
template <typename Pressure>
std::vector<fem::ContactNode<2>> nodes_with(const Pressure& pressure) {
  std::vector<fem::ContactNode<2>> nodes;
  for (int i = 0; i <= 100; ++i) {
    fem::ContactNode<2> node{};
    node.arc_length = 2e-5 * i;
    node.pressure = pressure(i / 50. - 1.);
    node.tributary = 1.;
    nodes.push_back(node);
  }
  return nodes;
}

/// A plane run with a hundred nodes across the contact, so that little is left to where they stand.
struct FewMeshes {
  explicit FewMeshes(const std::vector<Mesh>& meshes) {
    for (const Mesh& mesh : meshes) {
      fem::LevelRecord record{};
      record.refined = mesh.refined;
      record.halvings = mesh.refined == Refined::zone ? 1 : 0;
      record.grading = 0.2;
      record.nodes_across = 100;
      record.size_measure = mesh.size_measure;
      solution.history.push_back(record);
      figures.push_back({{mesh.figures}, {}});
    }
    fem::ContactResult<2> contact{};
    contact.half_width = 1e-3;
    contact.active_nodes = 100;
    contact.intervals = {{0., 2e-3, false}};
    contact.nodes = nodes_with([](const double x) { return std::sqrt(1. - x * x); });
    solution.contacts = {contact};
    solution.has_free_ends = true;
  }

  [[nodiscard]] double error(const Figure figure) const {
    return post::figure_errors(solution, figures).contacts.at(0).at(figure);
  }

  fem::Solution<2> solution;
  std::vector<post::RunFigures> figures;
};

std::vector<Mesh> zone_meshes(const Figure figure, const std::vector<double>& values) {
  std::vector<Mesh> meshes;
  for (const double value : values)
    meshes.push_back({meshes.empty() ? Refined::nothing : Refined::zone, 1., {{figure, value}}});
  return meshes;
}

TEST(FigureErrors, AreNoneOfAForceThatTheLoadsDecide) {
  EXPECT_LT(FewMeshes(zone_meshes(Figure::force, {5., 5., 5., 5.})).error(Figure::force), 1e-6);
}

TEST(FigureErrors, CoverWhatHalvedCellsLeaveAtSecondOrder) {
  // The change of 0.0075 to the last mesh leaves a third of it.
  const double error = FewMeshes(zone_meshes(Figure::bore_torque, {1.16, 1.04, 1.01, 1.0025}))
                           .error(Figure::bore_torque);
  EXPECT_GE(error, 0.0025 / 1.0025 * (1. - 1e-9));
  EXPECT_LT(error, 0.0026);
}

TEST(FigureErrors, CoverWhatTheCellsAroundLeave) {
  // A size measure of a quarter changes the half-width by 3 %, so that 1 % is left.
  std::vector<Mesh> meshes = zone_meshes(Figure::half_width, {0.98, 0.98, 0.98});
  meshes.push_back({Refined::surroundings, 0.25, {{Figure::half_width, 1.01}}});
  const double error = FewMeshes(meshes).error(Figure::half_width);
  EXPECT_GE(error, 0.0099);
  EXPECT_LT(error, 0.02);
}

TEST(FigureErrors, AreLargeUntilTheCellsAroundWereRefined) {
  const std::vector<double> settled{0.98, 0.98, 0.98};
  EXPECT_GT(FewMeshes(zone_meshes(Figure::half_width, settled)).error(Figure::half_width), 0.01);
  FewMeshes without_ends(zone_meshes(Figure::half_width, settled));
  without_ends.solution.has_free_ends = false;
  EXPECT_LT(without_ends.error(Figure::half_width), 0.01);
}

TEST(FigureErrors, OfAHalfWidthAreThoseOfANodeWhereThePressureIsNotHertzs) {
  FewMeshes punch(zone_meshes(Figure::half_width, {0.98, 0.98, 0.98}));
  const double of_hertz = punch.error(Figure::half_width);
  punch.solution.contacts[0].nodes = nodes_with([](const double) { return 1.; });
  EXPECT_NEAR(punch.error(Figure::half_width) - of_hertz, 0.02, 1e-9);
}

TEST(FigureErrors, AreNotKnownOnOneMesh) {
  EXPECT_GE(FewMeshes(zone_meshes(Figure::max_shear, {1.})).error(Figure::max_shear), 1.);
}

TEST(FigureErrors, OfDepthsAreGreaterOnCoarseCells) {
  FewMeshes coarse(zone_meshes(Figure::max_shear_depth, {0.8, 0.8, 0.8}));
  const double on_fine_cells = coarse.error(Figure::max_shear_depth);
  coarse.solution.contacts[0].active_nodes = 10;
  EXPECT_GT(coarse.error(Figure::max_shear_depth), on_fine_cells + 0.005);
}

TEST(FigureErrors, AreGivenForEveryFigureOfEveryContact) {
  FewMeshes run(zone_meshes(Figure::half_width, {1.1, 1.02, 1.01}));
  run.solution.contacts.push_back(run.solution.contacts[0]);
  for (post::RunFigures& mesh : run.figures) {
    mesh.contacts.push_back({{Figure::force, 3.}, {Figure::max_shear, 2.}});
    mesh.mechanism = {{Figure::bore_torque, -4.}};
  }
  const post::RunFigures errors = post::figure_errors(run.solution, run.figures);
  ASSERT_EQ(errors.contacts.size(), 2U);
  EXPECT_EQ(errors.contacts[0].size(), 1U);
  EXPECT_EQ(errors.contacts[1].size(), 2U);
  EXPECT_LT(errors.mechanism.at(Figure::bore_torque), 1e-6);
}

TEST(FigureErrors, OfAPinsBendingGrowWithTheCellsAroundAndHoldAllOfTheirLastChange) {
  FewMeshes run(std::vector<Mesh>{{Refined::nothing, 1., {}}, {Refined::surroundings, 1., {}}});
  run.solution.history[0].grading = 0.4;
  for (const double deflection : {1.04, 1.}) {
    post::Figures& bending = run.figures[deflection > 1. ? 0 : 1].mechanism;
    bending = {{Figure::tip_deflection, deflection}, {Figure::root_stress, 1.}};
  }
  const Figures errors = post::figure_errors(run.solution, run.figures).mechanism;
  // The ratio of size to distance was halved, and so was an error of stiffness at least; one of
  // second order would leave a third of the change.
  const double left = 0.04 / 3.;
  EXPECT_GE(errors.at(Figure::tip_deflection), 0.25 * 0.2 + left);
  EXPECT_LT(errors.at(Figure::tip_deflection), errors.at(Figure::root_stress) + 0.02 + 2. * left);
  EXPECT_GE(errors.at(Figure::root_stress), 0.15 * 0.2);
}

}  // namespace
