#include "fem/strength.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fem/elasticity/surface_stress.h"
#include "fem/stress_error.h"
#include "mesh/extrusion.h"
#include "tests/support/structured_mesh.h"
#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;
using dealii::Tensor;
using geneva::test::add_rectangle;
using geneva::test::add_ring;
using geneva::test::empty_mesh;
using geneva::test::equal_steps;

const Material steel{2e11, 0.3};

/// The gradient of a field that is linear in the place, and its values at neighbours.
template <int dim>
std::vector<SurfaceNeighbour<dim>> neighbours_of(const Tensor<2, dim>& gradient,
                                                 const std::vector<Tensor<1, dim>>& offsets) {
  std::vector<SurfaceNeighbour<dim>> result;
  for (const auto& offset : offsets) result.push_back({offset, gradient * offset});
  return result;
}

TEST(SurfaceGradient, OfALinearFieldIsItsPartAlongTheSurface) {
  const Tensor<2, 2> gradient({{0.1, 0.2}, {-0.3, 0.4}});
  const Tensor<1, 2> normal({0.6, 0.8});
  const Tensor<1, 2> along({-0.8, 0.6});
  const auto found =
      surface_gradient<2>(normal, neighbours_of<2>(gradient, {0.3 * along, -0.7 * along}));
  ASSERT_TRUE(found);
  EXPECT_NEAR(along * (*found * along), along * (gradient * along), 1e-14);
}

/// Neighbours at the same distance; else the strain is of the third order in it.
TEST(SurfaceGradient, OfARotationOfACircleHasNoStrain) {
  const Tensor<2, 2> rotation({{0., -0.2}, {0.2, 0.}});
  const auto at = [](const double angle) {
    return Tensor<1, 2>({std::cos(angle) - 1., std::sin(angle)});
  };
  const Tensor<1, 2> normal({1., 0.});
  const auto found = surface_gradient<2>(normal, neighbours_of<2>(rotation, {at(0.4), at(-0.4)}));
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found)[1][1], 0., 1e-14);
}

TEST(SurfaceGradient, InSpaceOfALinearFieldIsItsPartAlongTheSurface) {
  Tensor<2, 3> gradient;
  std::mt19937 random(3);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      gradient[i][j] = static_cast<double>(random() % 100) / 100.;
  std::vector<Tensor<1, 3>> offsets;
  for (const double x : {-1., 0., 1.2})
    for (const double y : {-0.1, 0., 0.2})
      if (x != 0. || y != 0.) offsets.push_back(Tensor<1, 3>({x, y, 0.}));
  const auto found =
      surface_gradient<3>(Tensor<1, 3>({0., 0., 1.}), neighbours_of<3>(gradient, offsets));
  ASSERT_TRUE(found);
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j) EXPECT_NEAR((*found)[i][j], gradient[i][j], 1e-13);
}

TEST(SurfaceGradient, IsUnknownWithoutEnoughNeighbours) {
  EXPECT_FALSE(
      surface_gradient<2>(Tensor<1, 2>({0., 1.}), {{Tensor<1, 2>({1., 0.}), Tensor<1, 2>()}}));
}

/// A free surface in plane strain: E/(1 - nu^2) times the strain along it.
TEST(SurfaceStress, OfAFreeSurfaceIsAlongItAlone) {
  const LinearElastic<2> law(steel, PlaneKind::plane_strain);
  const Tensor<1, 2> normal({0.6, 0.8});
  const Tensor<1, 2> along({-0.8, 0.6});
  const double strain = 1e-3;
  const StressVector<2> stress =
      surface_stress<2>(law, strain * dealii::outer_product(along, along), 0., normal, {});
  const double expected = steel.youngs_modulus / (1. - 0.3 * 0.3) * strain;
  EXPECT_NEAR(stress[0], expected * along[0] * along[0], 1e-9 * expected);
  EXPECT_NEAR(stress[1], expected * along[1] * along[1], 1e-9 * expected);
  EXPECT_NEAR(stress[2], 0.3 * expected, 1e-9 * expected);
  EXPECT_NEAR(stress[3], expected * along[0] * along[1], 1e-9 * expected);
}

TEST(SurfaceStress, HasTheTractionThatIsGiven) {
  const LinearElastic<3> law(steel, PlaneKind::plane_strain);
  const Tensor<1, 3> normal({2. / 3., -1. / 3., 2. / 3.});
  const Tensor<1, 3> traction({1e6, 2e6, -3e6});
  Tensor<2, 3> gradient;
  gradient[0][0] = 1e-4;
  gradient[1][2] = -2e-4;
  const StressVector<3> stress = surface_stress<3>(law, gradient, 0., normal, traction);
  EXPECT_LT((traction_of<3>(stress, normal) - traction).norm(), 1e-6 * traction.norm());
}

/// One node of a contact at the origin that carries 1000 N over a thickness of 0.1 m, between two
/// bodies of three.
Solution<2> loaded_at_origin(const PlaneKind plane) {
  Solution<2> solution;
  solution.problem.plane = plane;
  solution.problem.thickness = 0.1;
  solution.mesh = empty_mesh();
  for (const char* const name : {"lower", "upper", "other"}) {
    solution.problem.bodies.push_back({name, steel, {}});
    add_rectangle(solution.mesh, name, {0., 1.}, {0., 1.},
                  {"", "", "", std::string(name) + " side"});
  }
  ContactResult<2> contact{};
  contact.source = "upper side";
  contact.target = "lower side";
  ContactNode<2> node{};
  node.pressure = 1e6;
  node.tributary = 1e-3;
  node.status = NodeStatus::slip;
  contact.nodes.push_back(node);
  solution.contacts.push_back(contact);
  return solution;
}

TEST(ContactsOwnField, IsFlamants) {
  const double line = 1e4;  // N/m
  const double radial = 2. * line / (pi * 0.02);
  const ContactsOwnField<2> stress(loaded_at_origin(PlaneKind::plane_stress));
  EXPECT_NEAR(stress.von_mises(Point<2>(0.012, -0.016), 0), radial, 1e-9 * radial);
  // the bound by sizes is that of plane stress
  const ContactsOwnField<2> strain(loaded_at_origin(PlaneKind::plane_strain));
  EXPECT_NEAR(strain.von_mises(Point<2>(0.012, -0.016), 0), radial, 1e-9 * radial);
}

TEST(ContactsOwnField, IsInTheBodiesOfTheContactOnly) {
  Solution<2> solution = loaded_at_origin(PlaneKind::plane_stress);
  solution.contacts.push_back(solution.contacts.front());
  solution.contacts.back().source = "other side";
  solution.contacts.back().nodes.front().position = {5., 0.};
  const ContactsOwnField<2> stress(solution);
  const Point<2> place(0.012, 0.016);
  const double of_second = 2. * 1e4 / (pi * place.distance(Point<2>(5., 0.)));
  EXPECT_NEAR(stress.von_mises(place, 2), of_second, 1e-9 * of_second);
  EXPECT_GT(stress.von_mises(place, 0), 100. * of_second);
}

/// Far away many nodes count in groups.
TEST(ContactsOwnField, IsThatOfEveryNodeBesideThem) {
  Solution<2> solution = loaded_at_origin(PlaneKind::plane_stress);
  auto& nodes = solution.contacts.front().nodes;
  nodes.resize(640, nodes.front());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    nodes[i].position = {1e-3 * static_cast<double>(i), 0.};
  const ContactsOwnField<2> stress(solution);
  const double of_next = 2. * 1e4 / (pi * 1e-4);
  for (const std::size_t node : {0U, 9U, 325U, 639U})
    EXPECT_GT(stress.von_mises(Point<2>(nodes[node].position[0], -1e-4), 0), (1. - 1e-9) * of_next);
  const double of_all = 2. * 640. * 1e4 / (pi * 100.);
  EXPECT_NEAR(stress.von_mises(Point<2>(0.32, -100.), 0), of_all, 1e-4 * of_all);
}

/// Contact nodes that carry 1 N each, between "lower", from z = 0 to 1, and "upper", which reaches
/// beyond.
Solution<3> pressed_at(const std::vector<Components<3>>& places, const double tributary) {
  mesh::MeshData<2> plane = empty_mesh();
  add_rectangle(plane, "lower", {0., 1.}, {-1., 0.}, {"", "", "", "lower side"});
  add_rectangle(plane, "upper", {0., 1.}, {0., 1.}, {"", "", "upper side", ""});
  Solution<3> solution;
  solution.mesh = extruded(plane, {{{0., 1.}, "", ""}, {{-1., 2.}, "", ""}});
  for (const char* const name : {"lower", "upper"})
    solution.problem.bodies.push_back({name, steel, {}});
  ContactResult<3> contact{};
  contact.source = "upper side";
  contact.target = "lower side";
  for (const Components<3>& place : places) {
    ContactNode<3> node{};
    node.position = place;
    node.normal = {0., 1., 0.};
    node.tributary = tributary;
    node.pressure = 1. / tributary;
    node.status = NodeStatus::slip;
    contact.nodes.push_back(node);
  }
  solution.contacts.push_back(contact);
  return solution;
}

std::vector<Components<3>> row_along_z(const double end) {
  std::vector<Components<3>> places;
  for (int i = 0; i <= 20; ++i) places.push_back({0.5, 0., end * i / 20.});
  return places;
}

TEST(ContactsOwnField, HasImagesInAFaceAtWhichABodyEnds) {
  std::vector<Components<3>> places = row_along_z(1.);
  const ContactsOwnField<3> row(pressed_at(places, 1e-4));
  for (const Components<3>& place : row_along_z(1.)) places.push_back({0.5, 0., 2. - place[2]});
  const ContactsOwnField<3> with_image(pressed_at(places, 1e-4));
  const Point<3> on_face(0.5, -0.05, 1.);
  const double expected = with_image.von_mises(on_face, 1);
  EXPECT_NEAR(row.von_mises(on_face, 0), expected, 0.02 * expected);
  EXPECT_GT(expected, 1.5 * row.von_mises(on_face, 1));
}

TEST(ContactsOwnField, HasNoImagesWhereTheContactEndsWithinABody) {
  const ContactsOwnField<3> row(pressed_at(row_along_z(0.5), 1e-4));
  const Point<3> at_end(0.5, -0.05, 0.5);
  EXPECT_NEAR(row.von_mises(at_end, 0) / row.von_mises(at_end, 1), 1., 0.03);
}

TEST(ContactsOwnField, IsThatOfAreasThatAreLongIn3D) {
  const ContactsOwnField<3> layer(
      pressed_at({{0.499, 0., 0.5}, {0.5, 0., 0.5}, {0.501, 0., 0.5}}, 1e-3 * 0.02));
  EXPECT_GT(layer.von_mises(Point<3>(0.5, -5e-4, 0.508), 0),
            0.5 * layer.von_mises(Point<3>(0.5, -5e-4, 0.5), 0));
}

TEST(SingularPlaces, AreEndsOfSupportsBesideFreeSurfaces) {
  mesh::MeshData<2> mesh = empty_mesh();
  add_rectangle(mesh, "block", {0., 0.5, 1.}, {0., 0.2, 1.}, {"held", "", "", ""});
  Problem<2> problem;
  problem.supports = {{"held", {0., 0.}}};
  const auto places = singular_places(mesh, boundary_tractions(mesh, problem, {1., 1.}, {}));
  ASSERT_EQ(places.size(), 2U);
  for (const SingularPlace<2>& place : places) {
    EXPECT_EQ(place.begin[1], 0.);
    EXPECT_EQ(place.why, Singularity::end_of_support);
    EXPECT_NEAR(place.radius, 0.2, 1e-15);
  }
}

TEST(SingularPlaces, AreNoneAtPlanesOfSymmetry) {
  mesh::MeshData<2> mesh = empty_mesh();
  add_rectangle(mesh, "block", {0., 0.5, 1.}, {0., 0.2, 1.}, {"slides", "", "", ""});
  Problem<2> problem;
  problem.bodies.push_back({"block", steel, {}});
  problem.supports = {{"slides", {std::nullopt, 0.}}};
  EXPECT_TRUE(singular_places(mesh, boundary_tractions(mesh, problem, {1., 1.}, {})).empty());
  problem.bodies[0].force.uniform = {1., 0.};
  EXPECT_TRUE(singular_places(mesh, boundary_tractions(mesh, problem, {1., 1.}, {})).empty());
  problem.bodies[0].force.uniform = {0., 1.};
  EXPECT_EQ(singular_places(mesh, boundary_tractions(mesh, problem, {1., 1.}, {})).size(), 2U)
      << "what is pulled along the normal is not mirrored";
}

/// One that ends within a face would have a crack beside it.
TEST(SingularPlaces, AreEndsOfASupportAlongItsNormalWithinAFlatFace) {
  mesh::MeshData<2> mesh = empty_mesh();
  add_rectangle(mesh, "block", {0., 0.2, 1.}, {0., 0.2, 1.}, {"slides", "", "", ""});
  for (mesh::Face<2>& face : mesh.faces)
    if (mesh.vertices[face.vertices[0]][1] == 0. && mesh.vertices[face.vertices[1]][1] == 0. &&
        mesh.vertices[face.vertices[0]][0] + mesh.vertices[face.vertices[1]][0] > 1.)
      face.surface = mesh::index_of(mesh.surfaces, "");
  Problem<2> problem;
  problem.bodies.push_back({"block", steel, {}});
  problem.supports = {{"slides", {std::nullopt, 0.}}};
  const auto places = singular_places(mesh, boundary_tractions(mesh, problem, {1., 1.}, {}));
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places.front().begin, (Components<2>{0.2, 0.}));
  EXPECT_EQ(places.front().why, Singularity::end_of_support);
}

TEST(SingularPlaces, AreEndsOfASurfaceThatTwoSupportsHold) {
  mesh::MeshData<2> mesh = empty_mesh();
  add_rectangle(mesh, "block", {0., 0.5, 1.}, {0., 0.2, 1.}, {"foot", "", "", ""});
  Problem<2> problem;
  problem.bodies.push_back({"block", steel, {}});
  problem.supports = {{"foot", {0., std::nullopt}}, {"foot", {std::nullopt, 0.}}};
  EXPECT_EQ(singular_places(mesh, boundary_tractions(mesh, problem, {1., 1.}, {})).size(), 2U);
}

/// Two blocks of one body that make an L.
TEST(SingularPlaces, AreCornersThatPointIntoTheBody) {
  mesh::MeshData<2> mesh = empty_mesh();
  mesh.bodies = {"L"};
  mesh.vertices = {{0., 0.}, {1., 0.}, {2., 0.}, {2., 1.}, {1., 1.}, {1., 2.}, {0., 2.}, {0., 1.}};
  mesh.cells = {{{0, 1, 4, 7}, 0}, {{1, 2, 3, 4}, 0}, {{7, 4, 5, 6}, 0}};
  for (unsigned int i = 0; i < 8; ++i) mesh.faces.push_back({{i, (i + 1) % 8}, 0, -1});
  const auto places = singular_places(mesh, boundary_tractions(mesh, Problem<2>{}, {1., 1.}, {}));
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places.front().begin, (Components<2>{1., 1.}));
  EXPECT_EQ(places.front().why, Singularity::re_entrant_corner);
}

/// A hole is round however few its cells are, also between flat faces in 3-D.
TEST(SingularPlaces, AreNoneAroundAHole) {
  mesh::MeshData<2> plane = empty_mesh();
  add_ring(plane, "ring", {{0., 0.}, {1., 2.}, equal_steps(0., 2. * pi, 6), "hole", "rim", "", ""});
  const mesh::MeshData<3> mesh = extruded(plane, {{{0., 0.5, 1.}, "lower", "upper"}});
  EXPECT_TRUE(singular_places(mesh, boundary_tractions(mesh, Problem<3>{}, {1., 1.}, {})).empty());
}

/// A mesh on which the only body has the given stress at a place.
LevelRecord record_with(const double stress, const std::array<double, 3>& place,
                        const bool is_round = false) {
  LevelRecord record{};
  record.strength.push_back({{stress, place, is_round}, {stress, place, is_round}});
  return record;
}

mesh::MeshData<2> unit_block() {
  mesh::MeshData<2> mesh = empty_mesh();
  add_rectangle(mesh, "block", {0., 0.5, 1.}, {0., 0.2, 1.}, {"", "", "", ""});
  return mesh;
}

TEST(GrownPlaces, AreCornersWhereAStressKeepsGrowing) {
  std::vector<LevelRecord> history;
  for (const double stress : {1., 1.4, 2., 2.8})
    history.push_back(record_with(stress, {0.501, 0., 0.}));
  EXPECT_TRUE(grown_places(unit_block(), {history.begin(), history.end() - 1}).empty());
  const auto places = grown_places(unit_block(), history);
  ASSERT_EQ(places.size(), 1U) << "once, though both stresses grow";
  EXPECT_EQ(places.front().begin, (Components<2>{0.5, 0.}));
  EXPECT_EQ(places.front().why, Singularity::growth);
  EXPECT_NEAR(places.front().radius, 0.5, 1e-15);
  EXPECT_TRUE(is_beside(places, Point<2>(0.6, 0.2)));
  EXPECT_FALSE(is_beside(places, Point<2>(0.5, 0.51)));
}

TEST(GrownPlaces, AreNoneWhereItSettlesOrTheSurfaceIsRoundOrNoCornerIsNear) {
  const auto found = [](const std::vector<double>& stresses, const double x, const bool is_round) {
    std::vector<LevelRecord> history;
    for (const double stress : stresses)
      history.push_back(record_with(stress, {x, 0., 0.}, is_round));
    return grown_places(unit_block(), history).size();
  };
  EXPECT_EQ(found({1., 1.4, 2., 2.8}, 0.5, false), 1U);
  EXPECT_EQ(found({1., 1.4, 1.8, 2.}, 0.5, false), 0U) << "0.4, 0.29, 0.11 more";
  EXPECT_EQ(found({1., 1.4, 2., 2.8}, 0.5, true), 0U);
  EXPECT_EQ(found({1., 1.4, 2., 2.8}, 0.7, false), 0U);
}

TEST(OpenByCell, FallsWithTheDistanceFromItsOwnSizeOn) {
  // v h V/(6 pi r^3), and V = h^2
  EXPECT_NEAR((open_by_cell<2>(3., 0.04, 0.2, 0.)), 3. / (6. * pi), 1e-15);
  EXPECT_NEAR((open_by_cell<2>(3., 0.04, 0.2, 0.4)), 3. / (6. * pi) / 8., 1e-15);
  EXPECT_NEAR((open_by_cell<3>(3., 0.008, 0.2, 0.4)), 3. / (16. * pi) / 16., 1e-15);
}

}  // namespace
}  // namespace geneva::fem::test
