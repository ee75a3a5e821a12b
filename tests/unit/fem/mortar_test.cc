#include "fem/contact/mortar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;
using dealii::Tensor;

/// Sums of a few dozen products of size 1 or less.
constexpr double round_off = 1e-13;

/// A source and a target surface, and what the pair is called in a failure.
struct Pair {
  std::string name;
  Surface<2> source;
  Surface<2> target;
};

const std::vector<double> coarse{-2., -0.9, 0.3, 1.1, 2.};
const std::vector<double> fine{-2.5, -1.7, -1.2, -0.5, 0.05, 0.6, 0.8, 1.5, 2.4};

std::vector<Pair> all_pairs() {
  const mesh::Circle pin{{0., 1.05}, 1.};
  const std::vector<double> around{-2.2, -1.9, -1.65, -1.5, -1.3, -1.};
  const mesh::Circle hole{{0., 0.2}, 1.2};
  return {
      {"straight, matching", underside(coarse, 0.1), upper_side(coarse)},
      {"straight, not matching", underside(coarse, 0.1), upper_side(fine)},
      {"straight, tilted", underside(coarse, 0.5), upper_side(fine, 0.2)},
      {"source sticks out", underside(fine, 0.1), upper_side(coarse)},
      {"circle on flat", arc(pin, around), upper_side(fine)},
      {"flat on circle", upper_side(coarse), arc(pin, around)},
      {"circle in hole", arc({{0., 0.1}, 1.}, around), arc(hole, {-0.9, -1.4, -1.7, -2.1, -2.4})},
      {"circle in hole, matching", arc({{0., 0.2}, 1.}, around),
       arc(hole, {around.rbegin(), around.rend()})},
  };
}

double sum_of_weights(const std::vector<ContactRow<2>>& rows) {
  double sum = 0.;
  for (const ContactRow<2>& row : rows) sum += row.weight;
  return sum;
}

const ContactRow<2>& row_of(const std::vector<ContactRow<2>>& rows, const unsigned int node) {
  return *std::find_if(rows.begin(), rows.end(),
                       [&](const ContactRow<2>& row) { return row.node == node; });
}

/// D 1 = M 1: what a row takes from the source node it gives to the target nodes. Together with
/// p = residual/D it makes the forces of both sides cancel.
TEST(Mortar, CouplingsOfARowAddUpToItsWeight) {
  for (const Pair& pair : all_pairs())
    for (const MortarData<2>& data : {plane_data(0.3), axisymmetric_data(-3.)}) {
      const auto rows = mortar_rows(pair.source, pair.target, data);
      ASSERT_FALSE(rows.empty()) << pair.name;
      for (const ContactRow<2>& row : rows) {
        double sum = 0.;
        for (const auto& [node, coupling] : row.coupling) sum += coupling;
        EXPECT_NEAR(sum, row.weight, round_off) << pair.name;
      }
    }
}

/// Rigid translations of both bodies together change no gap: D 1 = M 1 once more, now by rows that
/// name each node once.
TEST(Mortar, RowsNameEveryNodeOnceAndOnlyNodesThatExist) {
  for (const Pair& pair : all_pairs()) {
    std::map<unsigned int, int> seen;
    for (const ContactRow<2>& row : mortar_rows(pair.source, pair.target, plane_data())) {
      EXPECT_LT(row.node, pair.source.nodes.size()) << pair.name;
      EXPECT_EQ(++seen[row.node], 1) << pair.name;
      std::map<unsigned int, int> targets;
      for (const auto& [node, coupling] : row.coupling) {
        EXPECT_LT(node, pair.target.nodes.size()) << pair.name;
        EXPECT_EQ(++targets[node], 1) << pair.name;
      }
    }
  }
}

TEST(Mortar, MatchingStraightMeshesCoupleNodeToNode) {
  const auto rows = mortar_rows(underside(coarse, 0.), upper_side(coarse), plane_data());
  ASSERT_EQ(rows.size(), coarse.size());
  for (const ContactRow<2>& row : rows)
    for (const auto& [node, coupling] : row.coupling) {
      const bool faces_the_source = node == coarse.size() - 1 - row.node;
      EXPECT_NEAR(coupling, faces_the_source ? row.weight : 0., round_off);
    }
}

TEST(Mortar, WeightsAreTheIntegralsOfTheShapeFunctions) {
  const auto rows = mortar_rows(underside(coarse, 0.1), upper_side(fine), plane_data(0.3));
  const std::array<double, 5> lengths{0.55, 1.15, 1., 0.85, 0.45};  // half of both edges
  ASSERT_EQ(rows.size(), 5U);
  for (unsigned int i = 0; i < 5; ++i) EXPECT_NEAR(rows[i].weight, 0.3 * lengths[i], round_off);
}

TEST(Mortar, WeightsAddUpToTheCoveredAreaOfThePlaneModel) {
  const auto rows = mortar_rows(underside(fine, 0.1), upper_side(coarse), plane_data(0.3));
  EXPECT_NEAR(sum_of_weights(rows), 0.3 * 4., round_off) << "the target reaches from -2 to 2";
}

TEST(Mortar, WeightsAddUpToTheCoveredAreaOfTheAxisymmetricModel) {
  const Surface<2> source = underside({0., 0.4, 1., 1.5}, 0.1);
  const auto whole = mortar_rows(source, upper_side({0., 0.7, 2.}), axisymmetric_data());
  EXPECT_NEAR(sum_of_weights(whole), pi * 1.5 * 1.5, 10. * round_off);
  const auto part = mortar_rows(source, upper_side({0.2, 0.7, 1.2}), axisymmetric_data());
  EXPECT_NEAR(sum_of_weights(part), pi * (1.2 * 1.2 - 0.2 * 0.2), 10. * round_off);
}

TEST(Mortar, AxisymmetricWeightOfTheNodeOnTheAxisIsTheConeAboveIt) {
  const auto rows =
      mortar_rows(underside({0., 0.6}, 0.1), upper_side({0., 1.}), axisymmetric_data());
  EXPECT_NEAR(row_of(rows, 0).weight, pi * 0.36 / 3., round_off) << "a cone of height 1";
}

/// Biorthogonality: the integral of psi_j g is D_j g_j for every g that is linear along the edges.
TEST(Mortar, UniformGapIsTheSameAtEveryNode) {
  for (const auto& target : {coarse, fine})
    for (const auto& source : {coarse, fine})
      for (const double gap : {-0.02, 0., 0.1})
        for (const ContactRow<2>& row :
             mortar_rows(underside(source, gap), upper_side(target), plane_data(0.3)))
          EXPECT_NEAR(row.initial_gap, gap * row.weight, round_off);
}

TEST(Mortar, LinearGapIsThatAtTheNodeEvenWhereTheTargetEnds) {
  const double slope = 0.2;
  const double cosine = 1. / std::hypot(1., slope);
  for (const auto& target : {coarse, fine})
    for (const auto& source : {coarse, fine})
      for (const ContactRow<2>& row :
           mortar_rows(underside(source, 0.6), upper_side(target, slope), plane_data())) {
        const double gap = (0.6 - slope * source[row.node]) * cosine;
        // The dual basis of an edge that is covered by a share f has entries of size 1/f: f > 0.2.
        EXPECT_NEAR(row.initial_gap, gap * row.weight, 10. * round_off);
        EXPECT_LT((row.frame.normal - Tensor<1, 2>({-slope * cosine, cosine})).norm(),
                  10. * round_off);
      }
}

TEST(Mortar, PartlyCoveredNodesKeepTheirShareAndUncoveredOnesHaveNoRow) {
  // The target ends at 0.4 of the edge from 1 to 2: its shape functions there integrate to
  // 0.4 - 0.08 and 0.08; the node at 3 is not reached.
  const auto rows =
      mortar_rows(underside({0., 1., 2., 3.}, 0.1), upper_side({-1., 0.5, 1.4}), plane_data());
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_NEAR(row_of(rows, 0).weight, 0.5, round_off);
  EXPECT_NEAR(row_of(rows, 1).weight, 0.5 + 0.32, round_off);
  EXPECT_NEAR(row_of(rows, 2).weight, 0.08, round_off);
}

/// The target ends, along its normals, at 0.05 of the edge from 1 to 2, or at 0.02: the node at 2
/// is covered by 0.0025 of its faces, or by 0.0004.
TEST(Mortar, NodesBesideASliverHaveItsGapAndOnesWithoutEvenThatHaveNoRow) {
  const double slope = 0.2;
  const double cosine = 1. / std::hypot(1., slope);
  const auto rows =
      mortar_rows(underside({0., 1., 2.}, 0.6), upper_side({-1., 0.5, 1.125}, slope), plane_data());
  ASSERT_EQ(rows.size(), 3U);
  const ContactRow<2>& far = row_of(rows, 2);
  EXPECT_LT(far.initial_gap, far.weight * (0.6 - slope * 1.) * cosine);
  EXPECT_GT(far.initial_gap, far.weight * (0.6 - slope * 1.05) * cosine)
      << "at the node itself it would be half of that";
  const auto fewer = mortar_rows(underside({0., 1., 2.}, 0.6),
                                 upper_side({-1., 0.5, 1.0962}, slope), plane_data());
  EXPECT_EQ(fewer.size(), 2U);
}

/// A rotation of both bodies together, seen from flat surfaces in touch: M reproduces linear
/// displacements. n . (omega x d) vanishes for a distance d along the normal too.
TEST(Mortar, RotationOfBothBodiesTogetherOpensNoFlatGap) {
  const Point<2> centre(0.7, -3.);
  const auto rotated = [&](const Point<2>& point) {
    return Tensor<1, 2>({-(point[1] - centre[1]), point[0] - centre[0]});
  };
  for (const double gap : {0., 0.1}) {
    const Surface<2> source = underside(coarse, gap);
    const Surface<2> target = upper_side(fine);
    for (const ContactRow<2>& row : mortar_rows(source, target, plane_data())) {
      Tensor<1, 2> change = row.weight * rotated(source.nodes[row.node].position);
      for (const auto& [node, coupling] : row.coupling)
        change -= coupling * rotated(target.nodes[node].position);
      EXPECT_NEAR(row.frame.normal * change, 0., 10. * round_off);
      EXPECT_NEAR(row.frame.tangents[0] * change, gap * row.weight, 10. * round_off)
          << "the source is farther from the centre";
    }
  }
}

/// Without slip and without a gap: what rotates together, however curved.
TEST(Mortar, RotationOfMatchingSurfacesTogetherMovesNoNodeAgainstTheTarget) {
  const std::vector<double> angles{-2., -1.7, -1.5, -1.1, -0.8};
  const Surface<2> pin = arc({{0., 0.}, 1.}, angles);
  const Surface<2> hole = arc({{0., 0.}, 1.}, {angles.rbegin(), angles.rend()});
  const auto rotated = [&](const Point<2>& point) {
    return Tensor<1, 2>({-point[1] + 0.3, point[0] - 0.8});
  };
  for (const ContactRow<2>& row : mortar_rows(pin, hole, plane_data())) {
    Tensor<1, 2> change = row.weight * rotated(pin.nodes[row.node].position);
    for (const auto& [node, coupling] : row.coupling)
      change -= coupling * rotated(hole.nodes[node].position);
    EXPECT_LT(change.norm(), round_off);
  }
}

TEST(ContactFrame, IsOrthonormalAndRightHanded) {
  for (const double angle : {-2., 0., 0.4, 1.5, 3.}) {
    const Tensor<1, 2> normal({std::cos(angle), std::sin(angle)});
    const ContactFrame<2> frame = frame_along(normal);
    EXPECT_EQ(frame.normal, normal);
    EXPECT_NEAR(cross(frame.normal, frame.tangents[0]), 1., round_off);
    for (const double height : {-0.9, 0., 0.5}) {
      const double radius = std::sqrt(1. - height * height);
      const Tensor<1, 3> in_space({radius * normal[0], radius * normal[1], height});
      const auto [n, tangents] = frame_along(in_space);
      EXPECT_NEAR(tangents[0].norm(), 1., round_off);
      EXPECT_NEAR(n * tangents[0], 0., round_off);
      EXPECT_LT((dealii::cross_product_3d(n, tangents[0]) - tangents[1]).norm(), round_off);
    }
  }
}

TEST(Mortar, PushingTheSourceIntoTheTargetClosesTheGap) {
  const auto rows = mortar_rows(underside(coarse, 0.1), upper_side(fine), plane_data());
  for (const ContactRow<2>& row : rows) {
    EXPECT_GT(row.initial_gap, 0.);
    EXPECT_LT(-row.frame.normal[1], 0.) << "the rate of the gap along (0, -1)";
  }
}

/// The gap of a parabola, with the bubble that straight edges miss, is linear along an edge and so
/// its nodal value comes out at the nodes, whatever the target's mesh if only the source bends.
///
/// On an arc of radius R with chords h at an angle theta from the bottom the bubble is not quite
/// the parabola's: h^2/8 (1 - cos theta)/R is left, and h^4/128/R^3; the dual basis function's mean
/// absolute value is 5/3.
TEST(Mortar, GapOfACylinderOnAFlatIsThatOfItsNodes) {
  const double radius = 1.;
  const double height = 0.001;
  std::vector<double> angles;
  for (int i = -3; i <= 3; ++i) angles.push_back(-pi / 2. + 0.1 * i);
  const Surface<2> cylinder = arc({{0., radius + height}, radius}, angles);
  const double h = 2. * radius * std::sin(0.05);
  std::vector<double> below;
  for (const double angle : angles) below.push_back(radius * std::cos(angle));
  const struct {
    Surface<2> flat;
    double source_share;
  } cases[] = {{upper_side(fine), 1.}, {upper_side(below), 0.}, {upper_side(below), 0.4}};
  for (const auto& [flat, source_share] : cases)
    for (const ContactRow<2>& row : mortar_rows(cylinder, flat, plane_data(1., source_share))) {
      const double at_node = cylinder.nodes[row.node].position[1];
      const double theta = 0.1 * std::abs(static_cast<int>(row.node) - 3) + 0.1;
      // A target edge is shorter than the chord above it by cos(theta): its bubble is smaller.
      const double missed = h * h / 8. * ((1. - std::cos(theta)) + std::pow(std::sin(theta), 2));
      const double tolerance = 5. / 3. * (missed + std::pow(h, 4) / 128.);
      EXPECT_NEAR(row.initial_gap / row.weight, at_node, tolerance);
    }
}

TEST(Mortar, PressesAlongTheNormalOfTheSourceIfAsked) {
  std::vector<double> angles;
  for (int i = -3; i <= 3; ++i) angles.push_back(-pi / 2. + 0.1 * i);
  const Surface<2> cylinder = arc({{0., 1.001}, 1.}, angles);
  MortarData<2> data = plane_data();
  const auto along_target = mortar_rows(upper_side(fine), cylinder, data);
  data.along_source_normal = true;
  const auto along_source = mortar_rows(upper_side(fine), cylinder, data);
  ASSERT_EQ(along_source.size(), along_target.size());
  ASSERT_GT(along_source.size(), 1U);
  for (std::size_t i = 0; i < along_source.size(); ++i) {
    EXPECT_LT((along_source[i].frame.normal - Tensor<1, 2>({0., -1.})).norm(), round_off);
    EXPECT_EQ(along_source[i].initial_gap, along_target[i].initial_gap);
    EXPECT_EQ(along_source[i].coupling, along_target[i].coupling);
  }
}

TEST(Mortar, GapOfAPinInAConcentricHoleIsTheClearanceAtItsNodes) {
  // Both edges are chords of the same angle, so the relative curvature's bubble is left: the dual
  // basis averages xi (1 - xi) to 1/6, and the pin's share of it is counted.
  std::vector<double> angles;
  for (int i = 0; i <= 8; ++i) angles.push_back(-2. + 0.1 * i);
  const double clearance = 0.01;
  const double pin_radius = 1.;
  const double hole_radius = pin_radius + clearance;
  const Surface<2> pin = arc({{0., 0.}, pin_radius}, angles);
  const Surface<2> hole = arc({{0., 0.}, hole_radius}, {angles.rbegin(), angles.rend()});
  const double h = 2. * std::sin(0.05);
  const double bubble = (1. / pin_radius - 1. / hole_radius) * h * h / 12.;
  for (const ContactRow<2>& row : mortar_rows(pin, hole, plane_data(1., 1.)))
    EXPECT_NEAR(row.initial_gap / row.weight, clearance + bubble, round_off);
}

}  // namespace
}  // namespace geneva::fem::test
