#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numeric>

#include "fem/discretisation/vector.h"
#include "fem/elasticity/cell_element.h"
#include "fem/elasticity/material_law.h"
#include "mesh/dense_algebra.h"
#include "tests/unit/fem/discretisation.h"
#include "tests/unit/fem/hand_made.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;
using dealii::Tensor;
using geneva::test::equal_steps;

const Material steel{2., 0.3};
constexpr std::array<PlaneKind, 3> all_kinds{PlaneKind::plane_strain, PlaneKind::plane_stress,
                                             PlaneKind::axisymmetric};

/// The patch of MacNeal and Harder (Finite Elements in Analysis and Design 1, 1985): five distorted
/// cells in a rectangle of 0.24 by 0.12, moved along x.
mesh::MeshData<2> patch(const double x0 = 0.) {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  mesh.surfaces = {"", "bottom", "right", "top", "left"};
  mesh.bodies = {"patch"};
  mesh.vertices = {{0., 0.},     {0.24, 0.},   {0.24, 0.12}, {0., 0.12},
                   {0.04, 0.02}, {0.18, 0.03}, {0.16, 0.08}, {0.08, 0.08}};
  for (auto& vertex : mesh.vertices) vertex[0] += x0;
  for (unsigned int i = 0; i < 4; ++i) {
    mesh.cells.push_back({{i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i}, 0});
    mesh.faces.push_back({{i, (i + 1) % 4}, 1 + i, -1});
  }
  mesh.cells.push_back({{4, 5, 6, 7}, 0});
  return mesh;
}

/// A sector of a ring that is not centred at the origin, beside a rectangle.
mesh::MeshData<2> ring_and_rectangle() {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_ring(
      mesh, "ring",
      {{0.5, 0.25}, {0.25, 0.5, 1.}, equal_steps(0.3, 0.3 + 2. * pi, 9), "bore", "rim", "", ""});
  geneva::test::add_rectangle(mesh, "block", {2., 2.5, 3.5}, {-1., 0., 0.3, 0.5},
                              {"bottom", "right", "top", "left"});
  return mesh;
}

Problem<2> problem_on(const mesh::MeshData<2>& mesh,
                      const PlaneKind plane = PlaneKind::plane_strain) {
  Problem<2> problem;
  problem.plane = plane;
  problem.thickness = 0.7;
  for (const std::string& body : mesh.bodies) problem.bodies.push_back({body, steel, {}});
  return problem;
}

/// Maximum entry of a cell's matrix.
double size_of(const dealii::FullMatrix<double>& matrix) { return matrix.linfty_norm(); }

/// The maximum force K u on any cell relative to K's size: 0 for motions without strain.
double maximum_cell_force(const mesh::MeshData<2>& mesh, const PlaneKind plane,
                          const Field<2>& motion) {
  const Discretisation<2> grid(mesh);
  const auto systems = all_systems(*grid.dof_handler, problem_on(mesh, plane), mesh.surfaces);
  auto system = systems.begin();
  double maximum = 0.;
  for (const auto& cell : grid.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const dealii::Vector<double> displacement = values_on(cell, motion);
    dealii::Vector<double> force(displacement.size());
    system->stiffness.vmult(force, displacement);
    maximum = std::max(maximum, force.linfty_norm() / size_of(system->stiffness));
    ++system;
  }
  return maximum;
}

/// K u - f at every unknown, on every rank.
std::vector<double> residual(const Discretisation<2>& grid, const std::vector<CellSystem>& systems,
                             const Field<2>& displacement) {
  std::vector<double> sum(grid.dof_handler->n_dofs(), 0.);
  auto system = systems.begin();
  for (const auto& cell : grid.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    dealii::Vector<double> force(system->load.size());
    system->stiffness.vmult(force, values_on(cell, displacement));
    force -= system->load;
    for (unsigned int i = 0; i < force.size(); ++i) sum[system->dofs[i]] += force[i];
    ++system;
  }
  dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD, sum);
  return sum;
}

/// Force and moment about the origin of the loads of all ranks.
struct Resultant {
  Tensor<1, 2> force;
  double moment = 0.;
};

Resultant resultant(const mesh::MeshData<2>& mesh, const Problem<2>& problem,
                    const unsigned int refinements = 0) {
  const Discretisation<2> grid(mesh, refinements);
  const auto systems = all_systems(*grid.dof_handler, problem, mesh.surfaces);
  auto system = systems.begin();
  Resultant sum;
  for (const auto& cell : grid.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (unsigned int i = 0; i < system->load.size(); ++i) {
      const auto [component, vertex] = grid.element.system_to_component_index(i);
      sum.force[component] += system->load[i];
      sum.moment += component == 0 ? -cell->vertex(vertex)[1] * system->load[i]
                                   : cell->vertex(vertex)[0] * system->load[i];
    }
    ++system;
  }
  sum.force = dealii::Utilities::MPI::sum(sum.force, MPI_COMM_WORLD);
  sum.moment = dealii::Utilities::MPI::sum(sum.moment, MPI_COMM_WORLD);
  return sum;
}

TEST(Lame, OfPlaneStrainAndOfBodiesOfRevolutionAreThoseOfSpace) {
  for (const PlaneKind plane : {PlaneKind::plane_strain, PlaneKind::axisymmetric}) {
    const Lame constants = lame({2.6, 0.3}, plane);
    EXPECT_DOUBLE_EQ(constants.mu, 1.);
    EXPECT_DOUBLE_EQ(constants.lambda, 1.5);
    EXPECT_DOUBLE_EQ(constants.lambda_plane, constants.lambda);
  }
}

TEST(Lame, OfPlaneStressActOnTheStrainsInThePlane) {
  const Lame constants = lame({2.6, 0.3}, PlaneKind::plane_stress);
  EXPECT_DOUBLE_EQ(constants.mu, 1.);
  EXPECT_DOUBLE_EQ(constants.lambda_plane, 2.6 * 0.3 / (1. - 0.09)) << "E nu/(1 - nu^2)";
}

/// Of strains xx, yy, zz and 2 xy.
StressVector<2> hooke(const PlaneKind plane, const StressVector<2>& strain) {
  return LinearElastic<2>(steel, plane).respond(strain, {}).stress;
}

TEST(LinearElastic, OfUniaxialTensionIsEStrainInPlaneStress) {
  const StressVector<2> s = hooke(PlaneKind::plane_stress, {1., -0.3, 0., 0.});
  EXPECT_NEAR(s[0], 2., 1e-15);
  EXPECT_NEAR(s[1], 0., 1e-15);
  EXPECT_EQ(s[2], 0.);
}

TEST(LinearElastic, StressOutOfPlaneIsNuTimesTheOthersInPlaneStrain) {
  const StressVector<2> s = hooke(PlaneKind::plane_strain, {1., 0.4, 0., 0.4});
  EXPECT_NEAR(s[2], 0.3 * (s[0] + s[1]), 1e-15);
  EXPECT_NEAR(s[3], 2. / 1.3 * 0.2, 1e-15) << "2 mu epsilon_xy";
}

TEST(LinearElastic, StressOfABodyOfRevolutionFollowsHookesLawInSpace) {
  // Stresses (r, z, hoop) = (1, 2, 3) by E epsilon_i = sigma_i - nu (sigma_j + sigma_k).
  const StressVector<2> s =
      hooke(PlaneKind::axisymmetric,
            {(1. - 0.3 * 5.) / 2., (2. - 0.3 * 4.) / 2., (3. - 0.3 * 3.) / 2., 0.});
  EXPECT_NEAR(s[0], 1., 1e-14);
  EXPECT_NEAR(s[1], 2., 1e-14);
  EXPECT_NEAR(s[2], 3., 1e-14);
}

TEST(LinearElastic, TangentIsSymmetricAndMapsStrainsToStresses) {
  for (const PlaneKind plane : all_kinds) {
    const LinearElastic<2> law(steel, plane);
    const StressVector<2> strain(0.3, -0.7, 0., 0.2);
    const MaterialResponse<2> response = law.respond(strain, {});
    EXPECT_EQ(response.tangent, response.tangent.transpose());
    EXPECT_EQ(response.stress, response.tangent * strain);
    EXPECT_TRUE(response.history.empty());
  }
}

TEST(LinearElastic, LawsKeepTheOrderOfTheBodies) {
  Problem<2> problem;
  problem.bodies = {{"soft", {1., 0.}, {}}, {"stiff", {4., 0.}, {}}};
  const MaterialLaws<2> laws = material_laws(problem);
  EXPECT_DOUBLE_EQ(laws[0]->respond({1., 0., 0., 0.}, {}).stress[0], 1.);
  EXPECT_DOUBLE_EQ(laws[1]->respond({1., 0., 0., 0.}, {}).stress[0], 4.);
}

/// A cell's matrix holds a few hundred products of about its own size.
constexpr double round_off = 1e-13;

TEST(Stiffness, KnowsNoForceFromRigidMotionsInAPlane) {
  for (const PlaneKind plane : {PlaneKind::plane_strain, PlaneKind::plane_stress})
    for (const mesh::MeshData<2>& mesh : {patch(), ring_and_rectangle()}) {
      const auto along_x = [](const Point<2>&) { return Tensor<1, 2>({1., 0.}); };
      const auto along_y = [](const Point<2>&) { return Tensor<1, 2>({0., 1.}); };
      const auto rotation = [](const Point<2>& x) { return Tensor<1, 2>({-x[1], x[0]}); };
      EXPECT_LT(maximum_cell_force(mesh, plane, along_x), round_off);
      EXPECT_LT(maximum_cell_force(mesh, plane, along_y), round_off);
      EXPECT_LT(maximum_cell_force(mesh, plane, rotation), round_off);
    }
}

TEST(Stiffness, KnowsNoForceFromAnAxialTranslationOfABodyOfRevolution) {
  const auto along_y = [](const Point<2>&) { return Tensor<1, 2>({0., 1.}); };
  EXPECT_LT(maximum_cell_force(patch(0.1), PlaneKind::axisymmetric, along_y), round_off);
  EXPECT_LT(maximum_cell_force(patch(), PlaneKind::axisymmetric, along_y), round_off) << "on axis";
}

TEST(Stiffness, IsSymmetricAndLeavesOnlyRigidMotionsFree) {
  for (const PlaneKind plane : all_kinds) {
    const mesh::MeshData<2> mesh = patch(0.1);
    const Discretisation<2> grid(mesh);
    for (const CellSystem& system :
         all_systems(*grid.dof_handler, problem_on(mesh, plane), mesh.surfaces)) {
      Eigen::MatrixXd matrix(8, 8);
      for (unsigned int i = 0; i < 8; ++i)
        for (unsigned int j = 0; j < 8; ++j) {
          matrix(i, j) = system.stiffness(i, j);
          EXPECT_EQ(system.stiffness(i, j), system.stiffness(j, i));
        }
      const Eigen::VectorXd eigenvalues = mesh::symmetric_eigenpairs(matrix).values;
      const Eigen::Index rigid = plane == PlaneKind::axisymmetric ? 1 : 3;
      // The hourglass is the softest motion with strain: far above round-off on cells like these.
      for (Eigen::Index i = 0; i < 8; ++i)
        EXPECT_EQ(std::abs(eigenvalues(i)) < round_off * eigenvalues(7), i < rigid);
    }
  }
}

/// A constant strain in equilibrium with its tractions: the displacement is linear and
/// K u - f vanishes at every node of a distorted mesh.
void expect_patch_passes(const PlaneKind plane, const Tensor<2, 2>& gradient, const double x0) {
  const mesh::MeshData<2> mesh = patch(x0);
  Problem<2> problem = problem_on(mesh, plane);
  const bool axisymmetric = plane == PlaneKind::axisymmetric;
  const StressVector<2> stress =
      hooke(plane, {gradient[0][0], gradient[1][1], axisymmetric ? gradient[0][0] : 0.,
                    gradient[0][1] + gradient[1][0]});
  const auto constant =
      assembled_stress<2>([&](const unsigned int component) { return stress[component]; });
  const std::array<Tensor<1, 2>, 4> normals{Tensor<1, 2>({0., -1.}), Tensor<1, 2>({1., 0.}),
                                            Tensor<1, 2>({0., 1.}), Tensor<1, 2>({-1., 0.})};
  for (unsigned int side = 0; side < 4; ++side) {
    const Tensor<1, 2> traction = constant.in_plane * normals[side];
    problem.loads.push_back({mesh.surfaces[1 + side], 0., {traction[0], traction[1]}});
  }
  const Discretisation<2> grid(mesh);
  const auto systems = all_systems(*grid.dof_handler, problem, mesh.surfaces);
  const auto defects =
      residual(grid, systems, [&](const Point<2>& x) { return gradient * Tensor<1, 2>(x); });
  for (const double defect : defects)
    EXPECT_NEAR(defect, 0., 1e-14) << "forces of size E times a length of 0.1";
}

TEST(PatchTest, ConstantStrainsInAPlaneAreExact) {
  for (const PlaneKind plane : {PlaneKind::plane_strain, PlaneKind::plane_stress})
    expect_patch_passes(plane, Tensor<2, 2>({{1e-1, 0.3e-1}, {0.7e-1, -0.4e-1}}), 0.);
}

TEST(PatchTest, ConstantStrainsOfABodyOfRevolutionAreExact) {
  for (const double inner_radius : {0., 0.1})
    expect_patch_passes(PlaneKind::axisymmetric, Tensor<2, 2>({{1e-1, 0.}, {0., -0.4e-1}}),
                        inner_radius);
}

/// Eigenvalues, ascending, of the matrix of each cell.
std::vector<Eigen::VectorXd> eigenvalues_of_cells(const mesh::MeshData<2>& mesh,
                                                  const Problem<2>& problem) {
  const Discretisation<2> grid(mesh);
  std::vector<Eigen::VectorXd> result;
  for (const CellSystem& system : all_systems(*grid.dof_handler, problem, mesh.surfaces)) {
    Eigen::MatrixXd matrix(8, 8);
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int j = 0; j < 8; ++j) matrix(i, j) = system.stiffness(i, j);
    result.push_back(mesh::symmetric_eigenpairs(matrix).values);
  }
  return result;
}

/// With B-bar or the right modes a bilinear cell resists, as its bulk modulus grows, by its mean
/// dilatation alone: one eigenvalue grows; two or three would lock.
TEST(IncompatibleModes, LeaveOneStiffMotionToANearlyIncompressibleCell) {
  mesh::MeshData<2> square = geneva::test::empty_mesh();
  geneva::test::add_rectangle(square, "square", {0.5, 1.}, {0., 0.5}, {"", "", "", ""});
  for (const PlaneKind plane : {PlaneKind::plane_strain, PlaneKind::axisymmetric}) {
    Problem<2> problem = problem_on(square, plane);
    problem.bodies[0].material.poissons_ratio = 0.4999;
    for (const Eigen::VectorXd& values : eigenvalues_of_cells(square, problem)) {
      EXPECT_GT(values(7), 100. * values(6)) << "bulk modulus 5000 times the shear modulus";
      EXPECT_LT(values(6), 20.) << "E = 2, circumference up to 2 pi";
    }
  }
}

/// Pure bending of a rectangle, u = (x y, -(x^2 + nu y^2)/2): its energy is E t I/2 per length,
/// which the modes show exactly on one cell of any proportions (Taylor, Beresford and Wilson 1976).
TEST(IncompatibleModes, MakePureBendingOfARectangleExact) {
  for (const double length : {0.5, 2., 10.}) {
    mesh::MeshData<2> beam = geneva::test::empty_mesh();
    geneva::test::add_rectangle(beam, "beam", {-length / 2., length / 2.}, {-0.5, 0.5},
                                {"", "", "", ""});
    const Discretisation<2> grid(beam);
    const auto systems =
        all_systems(*grid.dof_handler, problem_on(beam, PlaneKind::plane_stress), beam.surfaces);
    for (const auto& cell : grid.dof_handler->active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      const dealii::Vector<double> bent =
          values_on(cell, Field<2>([](const Point<2>& x) {
                      return Tensor<1, 2>({x[0] * x[1], -0.5 * (x[0] * x[0] + 0.3 * x[1] * x[1])});
                    }));
      const double energy = 0.5 * systems.front().stiffness.matrix_norm_square(bent);
      EXPECT_NEAR(energy, 0.5 * 2. * 0.7 * length / 12., 1e-12 * length);
    }
  }
}

/// Its stress is E y along x, and nothing else.
TEST(IncompatibleModes, MakeTheStressOfPureBendingExact) {
  mesh::MeshData<2> beam = geneva::test::empty_mesh();
  geneva::test::add_rectangle(beam, "beam", {-1., 1.}, {-0.5, 0.5}, {"", "", "", ""});
  const Discretisation<2> grid(beam);
  Vector bent(grid.dof_handler->locally_owned_dofs(), MPI_COMM_WORLD);
  const Field<2> field = [](const Point<2>& x) {
    return Tensor<1, 2>({x[0] * x[1], -0.5 * (x[0] * x[0] + 0.3 * x[1] * x[1])});
  };
  CellStresses<2> stresses(problem_on(beam, PlaneKind::plane_stress), dealii::QGauss<2>(3));
  for (const auto& cell : grid.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const dealii::Vector<double> values = values_on(cell, field);
    for (const unsigned int i : cell->vertex_indices())
      for (unsigned int c = 0; c < 2; ++c) bent(cell->vertex_dof_index(i, c)) = values[2 * i + c];
    for (const PointStress<2>& found : stresses(cell, bent)) {
      EXPECT_NEAR(found.stress.in_plane[0][0], 2. * found.place[1], 1e-14);
      EXPECT_NEAR(found.stress.in_plane[1][1], 0., 1e-14);
      EXPECT_NEAR(found.stress.in_plane[0][1], 0., 1e-14);
    }
  }
}

TEST(BodyForce, UniformOneAddsUpToForceTimesVolume) {
  const mesh::MeshData<2> mesh = ring_and_rectangle();
  Problem<2> problem = problem_on(mesh);
  problem.bodies[1].force.uniform = {3., -2.};
  const Resultant sum = resultant(mesh, problem);
  const double volume = 1.5 * 1.5 * 0.7;
  EXPECT_NEAR(sum.force[0], 3. * volume, round_off);
  EXPECT_NEAR(sum.force[1], -2. * volume, round_off);
  EXPECT_NEAR(sum.moment, volume * (2.75 * -2. - -0.25 * 3.), 10. * round_off);
}

TEST(BodyForce, OfAnAccelerationIsMassTimesIt) {
  const mesh::MeshData<2> mesh = ring_and_rectangle();
  Problem<2> problem = problem_on(mesh);
  problem.bodies[1].force.acceleration = {3., -2.};
  problem.bodies[1].density = 5.;
  const double mass = 5. * 1.5 * 1.5 * 0.7;
  EXPECT_NEAR(resultant(mesh, problem).force[0], 3. * mass, 5. * round_off);
  EXPECT_NEAR(resultant(mesh, problem).force[1], -2. * mass, 5. * round_off);
}

TEST(BodyForce, UniformOneOfABodyOfRevolutionAddsUpToForceTimesVolume) {
  const mesh::MeshData<2> mesh = patch(0.1);
  Problem<2> problem = problem_on(mesh, PlaneKind::axisymmetric);
  problem.bodies[0].force.uniform = {0., -2.};
  const double volume = pi * (0.34 * 0.34 - 0.1 * 0.1) * 0.12;
  EXPECT_NEAR(resultant(mesh, problem).force[1], -2. * volume, round_off);
}

/// The inertia's moment is the given one on any mesh, so that the reaction torque is too.
TEST(BodyForce, MomentOfTheInertiaIsMinusJAlphaOnAnyMesh) {
  const mesh::MeshData<2> mesh = ring_and_rectangle();
  Problem<2> problem = problem_on(mesh);
  problem.bodies[0].force.rotation = {0.37, 5., 11.};
  for (const unsigned int refinements : {0U, 1U, 3U})
    EXPECT_NEAR(resultant(mesh, problem, refinements).moment, -0.37 * 11., 20. * round_off);
}

TEST(BodyForce, OfASteadyRotationIsCentrifugal) {
  // A rectangle from (2, -1) to (3.5, 0.5): density J/(t integral r^2), force m omega^2 x_centre.
  const mesh::MeshData<2> mesh = ring_and_rectangle();
  Problem<2> problem = problem_on(mesh);
  const double inertia = 0.4;
  problem.bodies[1].force.rotation = {inertia, 5., 0.};
  const double square_radius =
      2.75 * 2.75 + 0.25 * 0.25 + 2. * 1.5 * 1.5 / 12.;  // of gyration about the origin
  const double mass = inertia / square_radius;
  const Resultant sum = resultant(mesh, problem);
  EXPECT_NEAR(sum.force[0], mass * 25. * 2.75, 10. * round_off);
  EXPECT_NEAR(sum.force[1], mass * 25. * -0.25, 10. * round_off);
  EXPECT_NEAR(sum.moment, 0., 10. * round_off) << "it points away from the origin";
}

TEST(BodyForce, OfAnAcceleratedRotationLagsBehind) {
  const mesh::MeshData<2> mesh = ring_and_rectangle();
  Problem<2> problem = problem_on(mesh);
  problem.bodies[1].force.rotation = {0.4, 0., 3.};
  const double mass = 0.4 / (2.75 * 2.75 + 0.25 * 0.25 + 2. * 1.5 * 1.5 / 12.);
  const Resultant sum = resultant(mesh, problem);
  // -alpha x r = alpha (y, -x): against a counter-clockwise acceleration.
  EXPECT_NEAR(sum.force[0], mass * 3. * -0.25, 10. * round_off);
  EXPECT_NEAR(sum.force[1], mass * 3. * -2.75, 10. * round_off);
}

TEST(SurfaceLoad, PressurePushesAgainstTheOutwardNormal) {
  const mesh::MeshData<2> mesh = ring_and_rectangle();
  Problem<2> problem = problem_on(mesh);
  problem.loads = {{"top", 4., {0., 0.}}};
  const Resultant sum = resultant(mesh, problem, 1);
  EXPECT_NEAR(sum.force[0], 0., round_off);
  EXPECT_NEAR(sum.force[1], -4. * 1.5 * 0.7, round_off);
}

TEST(SurfaceLoad, PressureAllAroundABodyOrAHoleHasNoResultant) {
  const mesh::MeshData<2> mesh = ring_and_rectangle();
  for (const auto& closed :
       std::vector<std::vector<std::string>>{{"rim"}, {"bore"}, {"bottom", "right", "top", "left"}})
    for (const unsigned int refinements : {0U, 2U}) {
      Problem<2> problem = problem_on(mesh);
      for (const std::string& surface : closed) problem.loads.push_back({surface, 4., {0., 0.}});
      const Resultant sum = resultant(mesh, problem, refinements);
      EXPECT_LT(sum.force.norm(), 10. * round_off);
      EXPECT_NEAR(sum.moment, 0., 10. * round_off);
    }
}

TEST(SurfaceLoad, PressureAllAroundABodyOfRevolutionHasNoAxialResultant) {
  for (const double inner_radius : {0., 0.1}) {
    const mesh::MeshData<2> mesh = patch(inner_radius);
    Problem<2> problem = problem_on(mesh, PlaneKind::axisymmetric);
    for (const char* side : {"bottom", "right", "top", "left"})
      problem.loads.push_back({side, 4., {0., 0.}});
    EXPECT_NEAR(resultant(mesh, problem).force[1], 0., round_off);
  }
}

TEST(SurfaceLoad, TractionOnABodyOfRevolutionActsOnTheWholeRing) {
  const mesh::MeshData<2> mesh = patch(0.1);
  Problem<2> problem = problem_on(mesh, PlaneKind::axisymmetric);
  problem.loads = {{"top", 0., {0., 5.}}};
  EXPECT_NEAR(resultant(mesh, problem).force[1], 5. * pi * (0.34 * 0.34 - 0.1 * 0.1), round_off);
}

TEST(SurfaceLoad, LoadsOnOneSurfaceAddUp) {
  const mesh::MeshData<2> mesh = ring_and_rectangle();
  Problem<2> problem = problem_on(mesh);
  problem.loads = {{"top", 4., {1., 0.}}, {"top", -1., {0., 2.}}};
  const Resultant sum = resultant(mesh, problem);
  EXPECT_NEAR(sum.force[0], 1. * 1.5 * 0.7, round_off);
  EXPECT_NEAR(sum.force[1], (-4. + 1. + 2.) * 1.5 * 0.7, round_off);
}

}  // namespace
}  // namespace geneva::fem::test
