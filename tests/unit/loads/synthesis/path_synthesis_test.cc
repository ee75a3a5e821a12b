#include "loads/synthesis/path_synthesis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "loads/pi.h"
#include "loads/synthesis/path_newton.h"
#include "tests/support/refusal.h"

namespace geneva::loads {
namespace {

using test::expect_refused;
using Points = std::vector<std::array<double, 2>>;

const FourBar known{{0.01, -0.02}, {0.13, 0.01}, 0.04, 0.11, 0.1, 0.09, 0.6};

std::array<double, 2> point(const FourBar& linkage, Assembly assembly, double crank_angle) {
  const FourBarMotion m = motion(linkage, assembly, crank_angle);
  return {m.x[0], m.y[0]};
}

Points curve(const FourBar& linkage, int count, double first, double last) {
  Points points;
  for (int i = 0; i < count; ++i)
    points.push_back(point(linkage, Assembly::open, first + (last - first) * i / (count - 1.)));
  return points;
}

/// Maximum difference of the nine dimensions, alpha as the length of its arc.
double difference(const FourBar& one, const FourBar& other) {
  return std::max({std::abs(one.crank_pivot[0] - other.crank_pivot[0]),
                   std::abs(one.crank_pivot[1] - other.crank_pivot[1]),
                   std::abs(one.rocker_pivot[0] - other.rocker_pivot[0]),
                   std::abs(one.rocker_pivot[1] - other.rocker_pivot[1]),
                   std::abs(one.crank - other.crank), std::abs(one.coupler - other.coupler),
                   std::abs(one.rocker - other.rocker),
                   std::abs(one.point_distance - other.point_distance),
                   other.point_distance *
                       std::abs(std::remainder(one.point_angle - other.point_angle, 2. * pi))});
}

/// The solution nearest to the linkage.
const PathSolution& nearest(const PathSynthesis& synthesis, const FourBar& linkage) {
  return *std::min_element(synthesis.solutions.begin(), synthesis.solutions.end(),
                           [&](const PathSolution& a, const PathSolution& b) {
                             return difference(a.linkage, linkage) < difference(b.linkage, linkage);
                           });
}

/// Every solution must pass every point in the assembly and at the crank angle it names.
void expect_passes(const PathSynthesis& synthesis, const Points& points, double tolerance) {
  for (const PathSolution& s : synthesis.solutions)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto p = point(s.linkage, s.assemblies[i], s.crank_angles[i]);
      EXPECT_NEAR(p[0], points[i][0], tolerance);
      EXPECT_NEAR(p[1], points[i][1], tolerance);
      EXPECT_LT(s.residual, 1e-13);
    }
}

FourBar disturbed(const FourBar& linkage, double share, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> part(-share, share);
  FourBar d = linkage;
  for (double* value : {&d.crank, &d.coupler, &d.rocker, &d.point_distance})
    *value *= 1. + part(engine);
  for (double* value :
       {&d.crank_pivot[0], &d.crank_pivot[1], &d.rocker_pivot[0], &d.rocker_pivot[1]})
    *value += part(engine) * frame_length(linkage);
  d.point_angle += part(engine);
  return d;
}

TEST(PathEquations, JacobianIsThatOfFiniteDifferences) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> value(-2., 2.);
  for (int k = 0; k < 100; ++k) {
    PathUnknowns u{Eigen::Matrix<double, 9, 1>::NullaryExpr([&] { return value(engine); }),
                   Eigen::Matrix3Xd::NullaryExpr(3, 1, [&] { return value(engine); })};
    const Eigen::Vector2d target(value(engine), value(engine));
    const PointEquations e = point_equations(u, 0, target);
    const auto column = [&](double& unknown) -> Eigen::Vector4d {
      constexpr double h = 1e-5;  // truncation 2 h^2/6, rounding 1e-16/h
      const double middle = unknown;
      unknown = middle + h;
      const Eigen::Vector4d after = point_equations(u, 0, target).residual;
      unknown = middle - h;
      const Eigen::Vector4d before = point_equations(u, 0, target).residual;
      unknown = middle;
      return (after - before) / (2. * h);
    };
    for (Eigen::Index j = 0; j < 9; ++j)
      EXPECT_LT((column(u.dimensions[j]) - e.by_dimensions.col(j)).norm(), 1e-9);
    for (Eigen::Index j = 0; j < 3; ++j)
      EXPECT_LT((column(u.angles(j, 0)) - e.by_angles.col(j)).norm(), 1e-9);
  }
}

TEST(PathEquations, NormalFormCognatesAndExchangeStillPassThePoints) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for (int k = 0; k < 100; ++k) {
    // a linkage closed at one position by construction: D follows from the angles
    PathUnknowns u{{}, Eigen::Matrix3Xd::NullaryExpr(3, 1, [&] { return angle(engine); })};
    u.dimensions << Eigen::Matrix<double, 9, 1>::NullaryExpr([&] { return angle(engine); });
    Eigen::Matrix2Xd target = Eigen::Matrix2Xd::Zero(2, 1);
    const Eigen::Vector4d open = path_residual(u, target);
    u.dimensions.segment<2>(2) += open.head<2>();
    target.col(0) = open.tail<2>();
    PathUnknowns member = u;
    for (int form = 0; form < 6; ++form) {
      EXPECT_LT(path_residual(normalised(member), target).norm(), 1e-12);
      member = form % 2 == 0 ? with_rocker_as_crank(member) : cognate(member);
      EXPECT_GE(member.dimensions.segment<4>(4).minCoeff(), 0.);
    }
    // the six forms close: three exchanges and three cognates lead back
    EXPECT_LT((member.dimensions - normalised(u).dimensions).norm(), 1e-10);
  }
}

TEST(PathSynthesis, RecoversAKnownLinkageFromNinePointsOfItsCurve) {
  const Points points = curve(known, 9, 0.2, 4.4);
  const PathSynthesis synthesis = synthesise_path({points, {}});
  ASSERT_FALSE(synthesis.solutions.empty());
  expect_passes(synthesis, points, 1e-10);
  const PathSolution& found = nearest(synthesis, known);
  EXPECT_LT(difference(found.linkage, known), 1e-8 * 0.1);
  EXPECT_FALSE(found.needs_reassembly);
  EXPECT_FALSE(found.out_of_order);
  EXPECT_EQ(synthesis.starts, 3000);
}

TEST(PathSynthesis, FindsAllThreeCognatesInBothForms) {
  const PathSynthesis synthesis = synthesise_path({curve(known, 9, 0.2, 4.4), {}, 0, 1, {known}});
  EXPECT_EQ(synthesis.solutions.size(), 6U);
}

TEST(PathSynthesis, RecoversAKnownLinkageFromADisturbedGuess) {
  const Points points = curve(known, 9, 0.2, 4.4);
  int recovered = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PathSynthesis s = synthesise_path({points, {}, 0, 1, {disturbed(known, 0.05, seed)}});
    if (!s.solutions.empty() && difference(nearest(s, known).linkage, known) < 1e-9) ++recovered;
  }
  EXPECT_GE(recovered, 5);  // nine points of 20 random linkages: 147 of 400 such guesses
}

TEST(PathSynthesis, IsReproducible) {
  const PathTask task{curve(known, 9, 0.2, 4.4), {}, 300, 5, {}};
  const PathSynthesis one = synthesise_path(task);
  const PathSynthesis two = synthesise_path(task);
  ASSERT_EQ(one.solutions.size(), two.solutions.size());
  EXPECT_EQ(one.minimum_residual, two.minimum_residual);
  for (std::size_t i = 0; i < one.solutions.size(); ++i)
    EXPECT_EQ(difference(one.solutions[i].linkage, two.solutions[i].linkage), 0.);
}

TEST(PathSynthesis, IsTheSameInAnyUnitOfLength) {
  Points points = curve(known, 9, 0.2, 4.4);
  const PathSynthesis metres = synthesise_path({points, {}, 300});
  for (auto& p : points) p = {1024. * p[0], 1024. * p[1]};  // a power of two: no rounding
  const PathSynthesis larger = synthesise_path({points, {}, 300});
  ASSERT_EQ(metres.solutions.size(), larger.solutions.size());
  EXPECT_EQ(1024. * metres.minimum_residual, larger.minimum_residual);
}

TEST(PathSynthesis, FivePointsWithFourGivenDimensions) {
  const Points points = curve(known, 5, 0.2, 3.);
  const PathSynthesis synthesis = synthesise_path({points,
                                                   {{PathDimension::crank_pivot_x, 0.01},
                                                    {PathDimension::crank_pivot_y, -0.02},
                                                    {PathDimension::rocker_pivot_x, 0.13},
                                                    {PathDimension::rocker_pivot_y, 0.01}},
                                                   10000});
  ASSERT_FALSE(synthesis.solutions.empty());
  expect_passes(synthesis, points, 1e-10);
  EXPECT_LT(difference(nearest(synthesis, known).linkage, known), 1e-8 * 0.1);
  for (const PathSolution& s : synthesis.solutions) {
    EXPECT_NEAR(s.linkage.crank_pivot[0], 0.01, 1e-16);
    EXPECT_NEAR(s.linkage.rocker_pivot[0], 0.13, 1e-16);
  }
}

TEST(PathSynthesis, SevenPointsWithGivenLengthAndAngle) {
  const Points points = curve(known, 7, 0.2, 4.);
  const PathSynthesis synthesis = synthesise_path(
      {points, {{PathDimension::crank, 0.04}, {PathDimension::point_angle, 0.6}}, 2000});
  ASSERT_FALSE(synthesis.solutions.empty());
  expect_passes(synthesis, points, 1e-10);
  for (const PathSolution& s : synthesis.solutions) {
    EXPECT_NEAR(s.linkage.crank, 0.04, 1e-16);
    EXPECT_NEAR(std::remainder(s.linkage.point_angle - 0.6, 2. * pi), 0., 1e-15);
  }
}

TEST(PathSynthesis, FindsNoLinkageForNinePointsOnAStraightLine) {
  // a coupler curve is of sixth degree: a straight line that is no part of it meets it six times
  Points points;
  for (int i = 0; i < 9; ++i) points.push_back({0.01 * i, 0.005 * i});
  const PathSynthesis synthesis = synthesise_path({points, {}, 1000});
  EXPECT_TRUE(synthesis.solutions.empty());
  EXPECT_EQ(synthesis.starts, 1000);
  EXPECT_GT(synthesis.minimum_residual, 1e-9);
  EXPECT_LT(synthesis.minimum_residual, 0.1);
}

TEST(PathSynthesis, SaysThatPermutedPointsAreOutOfOrder) {
  Points points = curve(known, 9, 0.2, 4.4);
  std::swap(points[2], points[6]);
  const PathSynthesis synthesis = synthesise_path({points, {}, 0, 1, {known}});
  ASSERT_FALSE(synthesis.solutions.empty());
  const PathSolution& found = nearest(synthesis, known);
  EXPECT_LT(difference(found.linkage, known), 1e-9);
  EXPECT_TRUE(found.out_of_order);
  EXPECT_FALSE(found.needs_reassembly);
}

TEST(PathSynthesis, AcceptsTheOrderInEitherSenseOfRotation) {
  Points points = curve(known, 9, 0.2, 4.4);
  std::reverse(points.begin(), points.end());
  const PathSynthesis synthesis = synthesise_path({points, {}, 0, 1, {known}});
  ASSERT_FALSE(synthesis.solutions.empty());
  EXPECT_FALSE(nearest(synthesis, known).out_of_order);
}

TEST(PathSynthesis, SaysThatPointsOfBothAssembliesNeedReassembly) {
  Points points = curve(known, 9, 0.2, 4.4);
  for (const int i : {3, 4, 5})
    points[static_cast<std::size_t>(i)] = point(known, Assembly::crossed, 0.2 + 0.525 * i);
  const PathSynthesis synthesis = synthesise_path({points, {}, 0, 1, {known}});
  ASSERT_FALSE(synthesis.solutions.empty());
  const PathSolution& found = nearest(synthesis, known);
  EXPECT_LT(difference(found.linkage, known), 1e-9);
  EXPECT_TRUE(found.needs_reassembly);
  EXPECT_EQ(found.assemblies[4], Assembly::crossed);
}

TEST(PathSynthesis, SaysThatPointsInTwoRangesOfTheCrankNeedReassembly) {
  const FourBar rocker{{0., 0.}, {0.1, 0.}, 0.09, 0.03, 0.08, 0.05, 0.4};
  const auto ranges = crank_ranges(rocker);
  ASSERT_EQ(ranges.size(), 2U);
  Points points;
  for (int i = 0; i < 9; ++i) {
    const auto& [first, last] = ranges[i < 5 ? 0 : 1];
    points.push_back(point(rocker, Assembly::open, first + (last - first) * (0.1 + 0.09 * i)));
  }
  const PathSynthesis synthesis = synthesise_path({points, {}, 0, 1, {rocker}});
  ASSERT_FALSE(synthesis.solutions.empty());
  const PathSolution& found = nearest(synthesis, rocker);
  EXPECT_LT(difference(found.linkage, rocker), 1e-9);
  EXPECT_TRUE(found.needs_reassembly);
}

TEST(PathSynthesis, RefusesAWrongNumberOfPoints) {
  expect_refused([] { synthesise_path({{{0., 0.}}, {}}); }, {"number of points is 1", "2 to 9"});
  expect_refused([] { synthesise_path({Points(10), {}}); }, {"number of points is 10", "2 to 9"});
}

TEST(PathSynthesis, RefusesPointsThatCoincide) {
  Points points = curve(known, 9, 0.2, 4.4);
  points[7] = points[1];
  expect_refused([&] { synthesise_path({points, {}}); }, {"points 2 and 8", "must differ"});
}

TEST(PathSynthesis, RefusesAWrongNumberOfGivenDimensionsAndNamesTheRightOne) {
  const Points points = curve(known, 7, 0.2, 4.);
  expect_refused(
      [&] {
        synthesise_path({points, {{PathDimension::crank, 0.04}}});
      },
      {"1 dimensions are given with 7 points", "exactly 2 of X_A", "give 1 more"});
  expect_refused(
      [&] {
        synthesise_path({points, {{PathDimension::crank, 0.04}, {PathDimension::crank, 0.05}}});
      },
      {"AB is given twice"});
  expect_refused(
      [&] {
        synthesise_path({points, {{PathDimension::crank, 0.04}, {PathDimension::rocker, -0.1}}});
      },
      {"CD is -100 mm", "positive"});
}

TEST(PathSynthesis, RefusesANegativeNumberOfStarts) {
  expect_refused(
      [] {
        synthesise_path({curve(known, 9, 0.2, 4.4), {}, -1});
      },
      {"number of starts is -1"});
}

}  // namespace
}  // namespace geneva::loads
