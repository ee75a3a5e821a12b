#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/round_shapes.h"
#include "mesh/torus_manifold.h"

namespace geneva::mesh::test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr Place axis{2. / 3., 1. / 3., 2. / 3.};
constexpr Place first{1. / 3., 2. / 3., -2. / 3.};
constexpr Place second{-2. / 3., 2. / 3., 1. / 3.};

/// Of a torus about (1, 2, 3): at these angles around its axis and around its tube.
Place on_torus(const double ring, const double tube, const double around, const double on_tube) {
  Place place{1., 2., 3.};
  for (std::size_t c = 0; c < 3; ++c)
    place[c] += (ring + tube * std::cos(on_tube)) *
                    (std::cos(around) * first[c] + std::sin(around) * second[c]) +
                tube * std::sin(on_tube) * axis[c];
  return place;
}

Place normal_at(const double around, const double on_tube) {
  Place normal{};
  for (std::size_t c = 0; c < 3; ++c)
    normal[c] = std::cos(on_tube) * (std::cos(around) * first[c] + std::sin(around) * second[c]) +
                std::sin(on_tube) * axis[c];
  return normal;
}

struct Patch {
  std::vector<Place> points;
  std::vector<SurfaceNormal> normals;
};

/// Around the axis from 0 to an angle, around the tube from one angle to another.
Patch patch(const double ring, const double tube, const double around, const double begin,
            const double end, const double off = 0.) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-off, off);
  Patch result;
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 5; ++k) {
      const double at = around * i / 5.;
      const double on_tube = begin + (end - begin) * k / 4.;
      const double radius = tube + noise(random);
      result.points.push_back(on_torus(ring, radius, at, on_tube));
      result.normals.push_back({result.points.back(), normal_at(at, on_tube)});
    }
  return result;
}

TEST(Torus, IsFoundInPartsOfIt) {
  // Fillets of a shaft, a whole bead, a barrel that bulges little, and tubes that meet their axis.
  for (const auto& [ring, tube, around, begin, end] :
       {std::array{18., 3., pi, pi / 2., pi}, std::array{18., 3., 0.3, pi, 3. * pi / 2.},
        std::array{5., 1., 1.9 * pi, 0., 1.9 * pi}, std::array{2., 900., 1., -0.01, 0.01},
        std::array{1., 3., 1., -0.5, 0.5}}) {
    const Patch part = patch(ring, tube, around, begin, end);
    const auto shape = round_surface_through(part.points, part.normals);
    ASSERT_TRUE(shape) << ring << " " << tube;
    EXPECT_NEAR(shape->ring_radius, ring, 1e-7 * (ring + tube));
    EXPECT_NEAR(shape->radius, tube, 1e-7 * (ring + tube));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(shape->axis[c], axis[c], 1e-7);
      EXPECT_NEAR(shape->centre[c], 1. + static_cast<double>(c), 1e-7 * (ring + tube));
    }
  }
}

TEST(Torus, IsNotFoundInPointsBesideIt) {
  const Patch part = patch(18., 3., pi, pi / 2., pi, 1e-4);
  EXPECT_FALSE(round_surface_through(part.points, part.normals));
}

/// A surface of revolution with rings of nodes at these distances from its axis and along it.
Patch revolved(const std::vector<std::array<double, 2>>& rings) {
  Patch result;
  for (int i = 0; i < 8; ++i)
    for (const auto& [off_axis, along] : rings) {
      const Place on_axis = on_torus(0., along, 0., pi / 2.);
      const Place outwards = normal_at(0.3 * i, 0.);
      Place point{};
      for (std::size_t c = 0; c < 3; ++c) point[c] = on_axis[c] + off_axis * outwards[c];
      result.points.push_back(point);
      result.normals.push_back({point, normal_at(0.3 * i, pi / 4.)});
    }
  return result;
}

TEST(Torus, IsNotFoundInAConeNorInThreeRingsOfNodesOfAnyShape) {
  for (const auto& rings : {std::vector<std::array<double, 2>>{
                                {3., 0.}, {2.7, 0.3}, {2.4, 0.6}, {2.1, 0.9}, {1.8, 1.2}},
                            {{3., 0.}, {2.7, 0.1}, {2., 1.}}}) {
    const Patch part = revolved(rings);
    EXPECT_FALSE(round_surface_through(part.points, part.normals));
  }
}

TEST(Torus, IsNotFoundInARingWithACornerOnEitherSideOfItsMiddle) {
  for (const double noise : {-1e-13, 0., 1e-13}) {
    const Patch part = revolved({{6., 0.}, {5., 1.}, {4., noise}, {5., -1.}});
    EXPECT_FALSE(round_surface_through(part.points, part.normals));
  }
}

TEST(Torus, HasTheCurvaturesOfTubeAndRing) {
  const Circle torus{{1., 2., 3.}, 3., axis, 18.};
  for (const double on_tube : {0., 1., pi / 2., 2., pi}) {
    const Place point = on_torus(18., 3., 0.4, on_tube);
    const Place normal = normal_at(0.4, on_tube);
    const auto tensor = curvature(torus, point, normal);
    const auto along = [&](const Place& direction) {
      double value = 0.;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) value += direction[i] * tensor[i][k] * direction[k];
      return value;
    };
    EXPECT_NEAR(along(normal_at(0.4, on_tube + pi / 2.)), 1. / 3., 1e-14);
    EXPECT_NEAR(along(normal_at(0.4 + pi / 2., 0.)),
                std::cos(on_tube) / (18. + 3. * std::cos(on_tube)), 1e-14);
    EXPECT_NEAR(along(normal), 0., 1e-14);
    const Place arm = radial(torus, point);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(arm[c], 3. * normal[c], 1e-13);
  }
}

TEST(Torus, IsAsFarFromItsAxisInAllDirections) {
  const Circle torus{{1., 2., 3.}, 3., axis, 2.};
  for (const double along : {0., 1.5}) {
    Place point{1., 2., 3.};
    for (std::size_t c = 0; c < 3; ++c) point[c] += along * axis[c];
    const Place arm = radial(torus, point);
    EXPECT_NEAR(std::hypot(arm[0], arm[1], arm[2]), std::hypot(2., along), 1e-14);
  }
}

TEST(Torus, NewPointsLieBetweenTheOthersOnIt) {
  const auto point = [](const double around, const double on_tube) {
    const Place place = on_torus(18., 3., around, on_tube);
    return dealii::Point<3>(place[0], place[1], place[2]);
  };
  const TorusManifold manifold(dealii::Tensor<1, 3>({axis[0], axis[1], axis[2]}),
                               dealii::Point<3>(1., 2., 3.), 18.);
  const std::array<double, 2> halves{0.5, 0.5};
  for (const double around : {-pi + 0.01, 0.2, pi - 0.01})
    for (const double on_tube : {-pi + 0.01, 0.2, pi - 0.01}) {
      const std::array ends{point(around - 0.1, on_tube + 0.2), point(around + 0.1, on_tube - 0.2)};
      const auto middle = manifold.clone()->get_new_point({ends.data(), ends.size()},
                                                          {halves.data(), halves.size()});
      EXPECT_LT(middle.distance(point(around, on_tube)), 1e-12);
    }
}

}  // namespace
}  // namespace geneva::mesh::test
