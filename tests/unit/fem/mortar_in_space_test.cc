#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fem/contact/mortar.h"
#include "fem/contact/surface_in_space.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;
using dealii::Tensor;

constexpr double pi = 3.14159265358979323846;
/// Sums of a hundred products of size 1 or less.
constexpr double round_off = 1e-12;

/// A surface through a grid of points, place(i, j), whose faces are counter-clockwise from i to j.
template <typename Place>
Surface<3> grid_surface(const unsigned int rows, const unsigned int columns, const Place& place,
                        const std::vector<mesh::Circle>& circles = {}) {
  Boundary<3> boundary;
  boundary.circles = circles;
  for (unsigned int i = 0; i < rows; ++i)
    for (unsigned int j = 0; j < columns; ++j) {
      const unsigned int dof = 3 * static_cast<unsigned int>(boundary.nodes.size());
      boundary.nodes.push_back({place(i, j), {dof, dof + 1, dof + 2}, 0});
    }
  for (unsigned int i = 0; i + 1 < rows; ++i)
    for (unsigned int j = 0; j + 1 < columns; ++j)
      boundary.faces.push_back(
          {{i * columns + j, (i + 1) * columns + j, (i + 1) * columns + j + 1, i * columns + j + 1},
           1,
           circles.empty() ? -1 : 0});
  return make_surface(boundary, 1);
}

/// The upper side of a body at y = 0, n x m faces over 2 a by 2 b, turned about y by an angle.
Surface<3> plate(const unsigned int n, const unsigned int m, const double a, const double b,
                 const double angle = 0.) {
  return grid_surface(n + 1, m + 1, [=](const unsigned int i, const unsigned int j) {
    const double z = -a + 2. * a * i / n;
    const double x = -b + 2. * b * j / m;
    return Point<3>(std::cos(angle) * x + std::sin(angle) * z, 0.,
                    std::cos(angle) * z - std::sin(angle) * x);
  });
}

/// The underside of a body at the height y, n x m faces over 2 a by 2 b.
Surface<3> underside(const unsigned int n, const unsigned int m, const double a, const double b,
                     const double y) {
  return grid_surface(n + 1, m + 1, [=](const unsigned int i, const unsigned int j) {
    return Point<3>(-a + 2. * a * i / n, y, -b + 2. * b * j / m);
  });
}

/// The lowest part of a pin along z of radius 1 at the height y, between -0.3 and 0.3 rad.
Surface<3> pin(const double y, const unsigned int around, const unsigned int along) {
  return grid_surface(around + 1, along + 1,
                      [=](const unsigned int i, const unsigned int j) {
                        const double angle = -pi / 2. - 0.3 + 0.6 * i / around;
                        return Point<3>(std::cos(angle), y + 1. + std::sin(angle),
                                        -0.5 + 1. * j / along);
                      },
                      {{{0., y + 1.}, 1.}});
}

MortarData<3> data(const double source_share = 0.5) {
  return {[](const Point<3>&) { return 1.; }, source_share};
}

struct Pair {
  std::string name;
  Surface<3> source;
  Surface<3> target;
};

std::vector<Pair> all_pairs() {
  return {{"matching", underside(3, 2, 1., 1., 0.1), plate(2, 3, 1., 1.)},
          {"not matching", underside(3, 4, 1., 1., 0.1), plate(5, 7, 1.2, 1.3)},
          {"turned", underside(4, 3, 1., 1., 0.1), plate(6, 5, 2., 2., 0.4)},
          {"source sticks out", underside(4, 3, 1., 1., 0.1), plate(3, 2, 0.6, 0.7, 0.3)},
          {"pin on plate", pin(0.01, 6, 3), plate(5, 7, 1., 1., 0.2)},
          {"plate on pin", plate(5, 7, 1., 1., 0.2), pin(0.01, 6, 3)}};
}

TEST(SurfaceInSpace, NormalsPointOutOfTheBody) {
  const Surface<3> flat = plate(2, 2, 1., 1., 0.3);
  for (const SurfaceNode<3>& node : flat.nodes)
    EXPECT_NEAR((node.normal - Tensor<1, 3>({0., 1., 0.})).norm(), 0., 1e-15);
  const Surface<3> round = pin(0., 4, 2);
  for (const SurfaceNode<3>& node : round.nodes)
    EXPECT_NEAR((node.normal - Tensor<1, 3>({node.position[0], node.position[1] - 1., 0.})).norm(),
                0., 1e-15);
  EXPECT_NEAR(plate(2, 2, 1., 1.).length, std::sqrt(8.), 1e-14);
}

TEST(SurfaceInSpace, BulgeIsTheSquareAcrossTheAxisOverTheRadius) {
  const Surface<3> round = pin(0., 4, 2);
  EXPECT_NEAR(bulge(round, round.faces[0], Tensor<1, 3>({0.3, 0.4, 7.})), 0.25, 1e-15);
  const Surface<3> flat = plate(2, 2, 1., 1.);
  EXPECT_EQ(bulge(flat, flat.faces[0], Tensor<1, 3>({0.3, 0.4, 7.})), 0.);
}

TEST(SurfaceInSpace, CountsStepsFromMarkedNodes) {
  const Surface<3> flat = plate(3, 4, 1., 1.);
  std::vector<bool> marked(flat.nodes.size(), false);
  const auto at = [&](const double z, const double x) {
    const auto found = std::find_if(flat.nodes.begin(), flat.nodes.end(), [&](const auto& node) {
      return std::hypot(node.position[0] - x, node.position[2] - z) < 1e-9;
    });
    return static_cast<std::size_t>(found - flat.nodes.begin());
  };
  marked[at(-1., -1.)] = true;
  const auto steps = steps_from(flat, marked);
  EXPECT_EQ(steps[at(-1., -1.)], 0U);
  EXPECT_EQ(steps[at(1., 1.)], 4U) << "diagonals of faces count as one step";
  EXPECT_EQ(steps[at(1., -0.5)], 3U);
  marked.assign(marked.size(), false);
  EXPECT_EQ(steps_from(flat, marked).front(), flat.nodes.size());
}

TEST(MortarInSpace, CouplingsOfARowAddUpToItsWeight) {
  for (const Pair& pair : all_pairs()) {
    const auto rows = mortar_rows(pair.source, pair.target, data());
    EXPECT_FALSE(rows.empty()) << pair.name;
    for (const ContactRow<3>& row : rows) {
      double sum = 0.;
      for (const auto& [node, coupling] : row.coupling) sum += coupling;
      EXPECT_NEAR(sum, row.weight, round_off) << pair.name;
    }
  }
}

TEST(MortarInSpace, WeightsAddUpToTheCoveredArea) {
  const double expected[] = {4., 4., 4., 4. * 0.6 * 0.7};
  const auto pairs = all_pairs();
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    double sum = 0.;
    for (const auto& row : mortar_rows(pairs[i].source, pairs[i].target, data())) sum += row.weight;
    EXPECT_NEAR(sum, expected[i], round_off) << pairs[i].name;
  }
}

TEST(MortarInSpace, MatchingFacesCoupleNodeToNode) {
  const auto pairs = all_pairs();
  for (const ContactRow<3>& row : mortar_rows(pairs[0].source, pairs[0].target, data())) {
    const Point<3>& here = pairs[0].source.nodes[row.node].position;
    ASSERT_EQ(row.coupling.size(), 1U);
    const auto& [node, coupling] = row.coupling.front();
    const Point<3>& there = pairs[0].target.nodes[node].position;
    EXPECT_NEAR(std::hypot(here[0] - there[0], here[2] - there[2]), 0., 1e-9);
    EXPECT_NEAR(coupling, row.weight, round_off);
  }
}

TEST(MortarInSpace, SurfacesWithTheSameLayersCoupleNodesOfTheSameLayer) {
  const Surface<3> source = underside(7, 5, 1., 1., 0.1);
  const Surface<3> target = plate(5, 4, 1., 1.);
  for (const ContactRow<3>& row : mortar_rows(source, target, data())) {
    const bool is_at_end = std::abs(source.nodes[row.node].position[0]) > 1. - 1e-9;
    EXPECT_EQ(row.coupling.size() < 2, is_at_end);
    for (const auto& coupling : row.coupling)
      EXPECT_NEAR(target.nodes[coupling.first].position[2], source.nodes[row.node].position[2],
                  1e-9);
  }
}

TEST(MortarInSpace, OverlapsLieOnBothFacesHoweverWideTheGap) {
  const Surface<3> source = pin(0.5, 3, 2);
  const Surface<3> target = plate(9, 14, 1., 1., 0.2);
  for (const SurfaceFace<3>& face : source.faces)
    for (const OverlapPoint<3>& point : overlap_points(source, face, FaceSearch<3>(target), data()))
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_GT(point.source_shapes[i], -round_off);
        EXPECT_GT(point.target_shapes[i], -round_off);
      }
}

TEST(FaceSearch, FindsTheNeighbourhoodOfTheOppositeFaceWhereSurfacesSlant) {
  constexpr unsigned int n = 20;
  const auto slanting = [](const double height, const bool is_upper_side) {
    return grid_surface(n + 1, n + 1, [=](const unsigned int i, const unsigned int j) {
      const double along = is_upper_side ? j : i;
      const double across = is_upper_side ? i : j;
      return Point<3>(along - height, along + height, across);
    });
  };
  const Surface<3> source = slanting(2., false);
  const Surface<3> target = slanting(0., true);
  const FaceSearch<3> search(target);
  for (const SurfaceFace<3>& face : source.faces) {
    const Point<3> opposite = face_middle(source, face) - Tensor<1, 3>({-2., 2., 0.});
    const auto found = search.near(source, face);
    EXPECT_LE(found.size(), 9U) << "of 40 to 60 whose boxes meet";
    EXPECT_EQ(std::count_if(found.begin(), found.end(),
                            [&](const unsigned int index) {
                              return opposite.distance(face_middle(target, target.faces[index])) <
                                     1e-9;
                            }),
              1);
  }
}

TEST(MortarInSpace, UniformAndLinearGapsAreThoseOfTheNodes) {
  const Surface<3> level = underside(4, 3, 1., 1., 0.1);
  for (const auto& target : {plate(5, 7, 1.2, 1.3), plate(3, 2, 0.6, 0.7, 0.3)})
    for (const ContactRow<3>& row : mortar_rows(level, target, data()))
      EXPECT_NEAR(row.initial_gap / row.weight, 0.1, round_off);
  Surface<3> tilted = level;
  for (SurfaceNode<3>& node : tilted.nodes)
    node.position[1] += 0.02 * node.position[0] - 0.03 * node.position[2];
  for (const ContactRow<3>& row : mortar_rows(tilted, plate(6, 5, 2., 2., 0.4), data()))
    EXPECT_NEAR(row.initial_gap / row.weight, tilted.nodes[row.node].position[1], round_off);
}

TEST(MortarInSpace, ClearanceIsAddedToTheGapWhereItIs) {
  MortarData<3> with_slope = data();
  with_slope.clearance = [](const double z) { return 0.01 + 0.2 * z; };
  const Surface<3> level = underside(4, 3, 1., 1., 0.1);
  for (const ContactRow<3>& row : mortar_rows(level, plate(5, 7, 1.2, 1.3), with_slope))
    EXPECT_NEAR(row.initial_gap / row.weight, 0.11 + 0.2 * level.nodes[row.node].position[2],
                round_off);
}

/// M reproduces linear displacements of flat surfaces: turning both bodies together, or shearing
/// both in the same way, opens no gap.
TEST(MortarInSpace, RigidMotionOfBothBodiesOpensNoFlatGap) {
  const Point<3> centre(0.7, -3., 0.2);
  for (const Pair& pair : all_pairs()) {
    if (pair.name.find("pin") != std::string::npos) continue;
    for (const ContactRow<3>& row : mortar_rows(pair.source, pair.target, data()))
      for (unsigned int axis = 0; axis < 3; ++axis) {
        Tensor<1, 3> omega;
        omega[axis] = 1.;
        const auto turned = [&](const Point<3>& point) {
          return dealii::cross_product_3d(omega, point - centre);
        };
        Tensor<1, 3> change = row.weight * turned(pair.source.nodes[row.node].position);
        for (const auto& [node, coupling] : row.coupling)
          change -= coupling * turned(pair.target.nodes[node].position);
        EXPECT_NEAR(row.frame.normal * change, 0., 10. * round_off) << pair.name;
      }
  }
}

TEST(MortarInSpace, GapOfAPinOnAPlateIsThatOfItsNodes) {
  // As in the plane: the bubble is taken as that of a parabola, h^2/8 (1 - cos theta) and h^4/128
  // are left, times 5/3 for the dual basis around the pin and once more along it.
  const Surface<3> source = pin(0.001, 6, 3);
  const double h = 2. * std::sin(0.05);
  for (const ContactRow<3>& row : mortar_rows(source, plate(5, 7, 1., 1., 0.2), data(1.))) {
    const Point<3>& node = source.nodes[row.node].position;
    const double theta = std::asin(std::abs(node[0])) + 0.1;
    const double tolerance =
        25. / 9. * (h * h / 8. * (1. - std::cos(theta)) + std::pow(h, 4) / 128.);
    EXPECT_NEAR(row.initial_gap / row.weight, node[1], tolerance);
  }
}

}  // namespace
}  // namespace geneva::fem::test
