#include "fem/discretisation/round_cell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/elasticity/sliver.h"
#include "mesh/extrusion.h"
#include "tests/unit/fem/discretisation.h"
#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;
using dealii::Tensor;
using geneva::test::add_ring;
using geneva::test::empty_mesh;

/// One cell of a ring of the radii 1 and 2, from 0 to 30 degrees.
mesh::MeshData<2> cell_of_ring() {
  mesh::MeshData<2> mesh = empty_mesh();
  add_ring(mesh, "ring", {{0., 0.}, {1., 2.}, {0., pi / 6.}, "inner", "outer", "", ""});
  return mesh;
}

mesh::MeshData<3> cell_of_tube() { return extruded(cell_of_ring(), {{{0., 0.5}, "z", "z"}}); }

template <int dim>
double distance_from_axis(const Point<dim>& place) {
  return std::hypot(place[0], place[1]);
}

TEST(RoundCell, HasItsFacesOnTheTrueCircles) {
  const mesh::MeshData<2> mesh = cell_of_ring();
  const Discretisation<2> grid(mesh);
  const RoundCell<2> cell(grid.triangulation->begin_active());
  ASSERT_TRUE(cell.is_round());
  // Whichever of the reference directions goes around: of its two ends one is inside, one outside.
  const bool first_is_around = cell.parts()[0] > 1;
  EXPECT_EQ(cell.parts()[first_is_around ? 0 : 1], 12U) << "30 degrees in parts of 2.5";
  EXPECT_EQ(cell.parts()[first_is_around ? 1 : 0], 1U);
  const auto at = [&](const double around, const double across) {
    return distance_from_axis(
        cell.place(first_is_around ? Point<2>(around, across) : Point<2>(across, around)));
  };
  const bool is_inner_first = at(0., 0.) < 1.5;
  for (const double around : {0., 0.2, 0.5, 0.9, 1.}) {
    EXPECT_NEAR(at(around, is_inner_first ? 0. : 1.), 1., 1e-14);
    EXPECT_NEAR(at(around, is_inner_first ? 1. : 0.), 2., 1e-14);
  }
}

TEST(RoundCell, OfATubeIsStraightAlongItsAxis) {
  const mesh::MeshData<3> mesh = cell_of_tube();
  const Discretisation<3> grid(mesh);
  const RoundCell<3> cell(grid.triangulation->begin_active());
  ASSERT_TRUE(cell.is_round());
  EXPECT_EQ(cell.parts()[0] * cell.parts()[1] * cell.parts()[2], 12U);
  for (unsigned int face = 0; face < 6; ++face) {
    const auto& of_cell = grid.triangulation->begin_active()->face(face);
    if (!is_round(of_cell)) continue;
    Point<3> middle(0.5, 0.5, 0.5);
    middle[face / 2] = face % 2;
    const double radius = distance_from_axis<3>(of_cell->vertex(0));
    EXPECT_NEAR(distance_from_axis(cell.place(middle)), radius, 1e-14);
  }
}

/// Of the inner face of a cell of a tube, whose radius is 1, and of the outer one.
std::pair<double, double> lengths_over_notch_radius(const double length) {
  const mesh::MeshData<3> mesh = extruded(cell_of_ring(), {{{0., length}, "z", "z"}});
  const Discretisation<3> grid(mesh);
  const auto& cell = grid.triangulation->begin_active();
  std::pair<double, double> result{-1., -1.};
  for (const unsigned int face : cell->face_indices())
    if (is_round(cell->face(face)))
      (distance_from_axis<3>(cell->face(face)->vertex(0)) < 1.5 ? result.first : result.second) =
          length_over_notch_radius(cell, face);
  return result;
}

TEST(LengthOverNotchRadius, IsThatOfTheLongestLineBesideAHoleAndNothingOutside) {
  const double chord = 2. * std::sin(pi / 12.);
  for (const double length : {0.2, 1.5, 7.}) {
    const auto [inner, outer] = lengths_over_notch_radius(length);
    EXPECT_NEAR(inner, std::max(chord, length), 1e-12);
    EXPECT_NEAR(outer, 0., 1e-12) << "a shaft has no notch";
  }
}

TEST(RoundCell, PartsFillTheCellAndEndAtItsVertices) {
  const mesh::MeshData<3> mesh = cell_of_tube();
  const Discretisation<3> grid(mesh);
  const auto& solved = grid.triangulation->begin_active();
  const RoundCell<3> cell(solved);
  double volume = 0.;
  for (const PartCorner& first : cell.first_corners()) {
    const Point<3> low = cell.reference(cell.corner_of_part(first, 0));
    const Point<3> high = cell.reference(cell.corner_of_part(first, 7));
    volume += (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
  }
  EXPECT_NEAR(volume, 1., 1e-14) << "of the reference cell";
  for (const unsigned int vertex : solved->vertex_indices())
    EXPECT_NEAR(cell.place(cell.reference(cell.at_vertex(vertex))).distance(solved->vertex(vertex)),
                0., 1e-14);
}

TEST(RoundCell, IsStraightWithoutRoundFaces) {
  mesh::MeshData<2> mesh = cell_of_ring();
  for (auto& face : mesh.faces) face.circle = -1;
  const Discretisation<2> grid(mesh);
  const RoundCell<2> cell(grid.triangulation->begin_active());
  EXPECT_FALSE(cell.is_round());
  EXPECT_EQ(cell.parts(), (std::array<unsigned int, 2>{1, 1}));
  EXPECT_LT(cell.place(Point<2>(0.5, 0.5)).distance(grid.triangulation->begin_active()->center()),
            1e-15);
}

/// Energy of the slivers of one cell under a displacement.
template <int dim>
double energy(const mesh::MeshData<dim>& mesh, const PlaneKind plane, const Field<dim>& field) {
  const Discretisation<dim> grid(mesh);
  Problem<dim> problem;
  problem.plane = plane;
  problem.bodies.push_back({"ring", {2., 0.3}, {}});
  const auto cell = grid.dof_handler->begin_active();
  dealii::FullMatrix<double> stiffness(cell->get_fe().n_dofs_per_cell());
  Slivers<dim>(problem).add_stiffness(cell, stiffness);
  const dealii::Vector<double> u = values_on(cell, field);
  return stiffness.matrix_norm_square(u);
}

/// Between chord and arc of 30 degrees, to the second order of the angle: 2/3 of the sagitta
/// R (1 - cos 15 deg) times the chord.
double sliver(const double radius) {
  return 2. / 3. * radius * (1. - std::cos(pi / 12.)) * 2. * radius * std::sin(pi / 12.);
}

TEST(Slivers, StretchAlongTheChordsWithAFreeSurface) {
  // strain 1 along the chords, which are both normal to 15 degrees
  const Tensor<1, 2> along({-std::sin(pi / 12.), std::cos(pi / 12.)});
  const Field<2> field = [&](const Point<2>& x) { return (along * x) * along; };
  const double expected = sliver(2.) - sliver(1.);
  EXPECT_NEAR(energy<2>(cell_of_ring(), PlaneKind::plane_stress, field), 2. * expected, 1e-14);
  EXPECT_NEAR(energy<2>(cell_of_ring(), PlaneKind::plane_strain, field), 2. / 0.91 * expected,
              1e-14);
  const Field<3> in_space = [&](const Point<3>& x) {
    const Tensor<1, 3> axis({along[0], along[1], 0.});
    return (axis * x) * axis;
  };
  EXPECT_NEAR(energy<3>(cell_of_tube(), PlaneKind::plane_strain, in_space),
              0.5 * 2. / 0.91 * expected, 1e-14);
}

/// Its terms, stiffness times the squares of displacements of up to 4, are of the order of 1.
TEST(Slivers, TakeNoEnergyForRigidMotions) {
  constexpr double round_off = 1e-14;
  const Field<2> motion = [](const Point<2>& x) { return Tensor<1, 2>({0.3 - x[1], 0.2 + x[0]}); };
  EXPECT_NEAR(energy<2>(cell_of_ring(), PlaneKind::plane_strain, motion), 0., round_off);
  const Field<3> in_space = [](const Point<3>& x) {
    return Tensor<1, 3>({0.3 + 2. * x[2] - x[1], x[0], -2. * x[0]});
  };
  EXPECT_NEAR(energy<3>(cell_of_tube(), PlaneKind::plane_strain, in_space), 0., round_off);
}

/// A displacement along the radius of an axisymmetric body is a hoop strain everywhere.
TEST(Slivers, OfAnAxisymmetricBodyResistTheHoopStrain) {
  const Field<2> field = [](const Point<2>& x) { return Tensor<1, 2>({x[0], x[1]}); };
  EXPECT_GT(energy<2>(cell_of_ring(), PlaneKind::axisymmetric, field), 0.);
  const Field<2> shift = [](const Point<2>&) { return Tensor<1, 2>({0., 1.}); };
  EXPECT_NEAR(energy<2>(cell_of_ring(), PlaneKind::axisymmetric, shift), 0., 1e-15);
}

}  // namespace
}  // namespace geneva::fem::test
