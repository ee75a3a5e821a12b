#include <deal.II/dofs/dof_tools.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "fem/discretisation/boundary.h"
#include "fem/elasticity/material_law.h"
#include "fem/linear/constraints.h"
#include "fem/linear/linear_system.h"
#include "mesh/extrusion.h"
#include "tests/unit/fem/discretisation.h"

namespace geneva::fem::test {
namespace {

using dealii::Point;
using dealii::Tensor;
using geneva::test::equal_steps;

const Material steel{2., 0.3};

/// A ring sector around a centre off the origin, extruded in uneven layers.
mesh::MeshData<3> sector() {
  mesh::MeshData<2> plane = geneva::test::empty_mesh();
  geneva::test::add_ring(
      plane, "sector",
      {{0.5, 0.25}, {0.5, 0.8, 1.}, equal_steps(0.3, 1.9, 4), "inner", "outer", "", ""});
  return extruded(plane, {{{-0.2, 0.1, 0.2, 0.7}, "lower", "upper"}});
}

Problem<3> problem_on(const mesh::MeshData<3>& mesh) {
  Problem<3> problem;
  for (const std::string& body : mesh.bodies) problem.bodies.push_back({body, steel, {}});
  return problem;
}

/// Work of the internal forces K u of one field on another, over all ranks.
double internal_work(const Discretisation<3>& grid, const mesh::MeshData<3>& mesh,
                     const Field<3>& field, const Field<3>& other) {
  const auto systems = all_systems(*grid.dof_handler, problem_on(mesh), mesh.surfaces);
  auto system = systems.begin();
  double work = 0.;
  for (const auto& cell : grid.dof_handler->active_cell_iterators())
    if (cell->is_locally_owned()) {
      const dealii::Vector<double> of_field = values_on(cell, field);
      work += system->stiffness.matrix_scalar_product(values_on(cell, other), of_field);
      ++system;
    }
  return dealii::Utilities::MPI::sum(work, MPI_COMM_WORLD);
}

double volume(const Discretisation<3>& grid) {
  double sum = 0.;
  for (const auto& cell : grid.dof_handler->active_cell_iterators())
    if (cell->is_locally_owned()) sum += cell->measure();
  return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
}

TEST(ElasticityInSpace, TakesNoEnergyForRigidMotions) {
  const mesh::MeshData<3> mesh = sector();
  const Discretisation<3> grid(mesh, 1);
  const Tensor<1, 3> shift({0.3, -0.2, 0.7});
  for (unsigned int axis = 0; axis < 3; ++axis) {
    Tensor<1, 3> omega;
    omega[axis] = 1.;
    const Field<3> motion = [&](const Point<3>& x) {
      return shift + dealii::cross_product_3d(omega, x);
    };
    EXPECT_NEAR(internal_work(grid, mesh, motion, motion), 0., 1e-13) << axis;
  }
}

TEST(LinearElasticInSpace, FollowsHookesLaw) {
  // E epsilon_i = sigma_i - nu (sigma_j + sigma_k), mu gamma_ij = tau_ij
  StressVector<3> stress;
  stress << 1., 2., 3., 4., 5., 6.;
  StressVector<3> strain;
  for (int i = 0; i < 3; ++i) strain[i] = (1.3 * stress[i] - 0.3 * (1. + 2. + 3.)) / 2.;
  for (int i = 3; i < 6; ++i) strain[i] = stress[i] * 2.6 / 2.;
  const auto response = LinearElastic<3>(steel, PlaneKind::plane_stress).respond(strain, {});
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(response.stress[i], stress[i], 1e-14);
}

/// Polygons that stand for no round surface: a sliver with a free surface has another stress.
TEST(ElasticityInSpace, HasTheEnergyOfUniformStrain) {
  mesh::MeshData<3> mesh = sector();
  for (auto& face : mesh.faces) face.circle = -1;
  const Discretisation<3> grid(mesh, 1);
  const Tensor<2, 3> gradient({{0.3, 0.2, -0.1}, {0.1, -0.4, 0.25}, {0.05, 0.15, 0.6}});
  const Field<3> field = [&](const Point<3>& x) { return gradient * Tensor<1, 3>(x); };
  const auto strain = dealii::symmetrize(gradient);
  const double mu = steel.youngs_modulus / 2.6;
  const double lambda = 0.3 * steel.youngs_modulus / (1.3 * 0.4);
  const double density =
      lambda * dealii::trace(strain) * dealii::trace(strain) + 2. * mu * (strain * strain);
  const double expected = density * volume(grid);
  EXPECT_NEAR(internal_work(grid, mesh, field, field), expected, 1e-13 * expected);
}

/// One cell six times as long as wide, bent about x: the trilinear displacement alone would be
/// nine times as stiff.
TEST(ElasticityInSpace, OneLongCellHasTheEnergyOfPureBending) {
  mesh::MeshData<2> plane = geneva::test::empty_mesh();
  geneva::test::add_rectangle(plane, "beam", {-0.5, 0.5}, {-0.5, 0.5}, {"", "", "", ""});
  const mesh::MeshData<3> mesh = extruded(plane, {{{-3., 3.}, "lower", "upper"}});
  const Discretisation<3> grid(mesh, 0);
  constexpr double curvature = 0.1;
  const double nu = steel.poissons_ratio;
  const Field<3> bent = [&](const Point<3>& x) {
    return curvature *
           Tensor<1, 3>({nu * x[0] * x[1], (x[2] * x[2] + nu * (x[1] * x[1] - x[0] * x[0])) / 2.,
                         -x[1] * x[2]});
  };
  const double expected = steel.youngs_modulus * curvature * curvature * 6. / 12.;
  // What is left of products of E and the ends' deflection squared, in sums of 24.
  const double deflection = curvature * 3. * 3. / 2.;
  const double rounding =
      24. * std::numeric_limits<double>::epsilon() * steel.youngs_modulus * deflection * deflection;
  EXPECT_NEAR(internal_work(grid, mesh, bent, bent), expected, rounding) << "E I kappa^2 l";
}

TEST(ElasticityInSpace, SpreadsTheGivenInertiaOverABodyAndLoadsItAboutZ) {
  const mesh::MeshData<3> mesh = sector();
  const Discretisation<3> grid(mesh, 1);
  Problem<3> problem = problem_on(mesh);
  problem.bodies[0].force.rotation = {3., 0., 5.};
  problem.bodies[0].force.uniform = {0., 0., -2.};
  const auto systems = all_systems(*grid.dof_handler, problem, mesh.surfaces);
  double moment = 0.;
  double downwards = 0.;
  auto system = systems.begin();
  for (const auto& cell : grid.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (unsigned int i = 0; i < system->load.size(); ++i) {
      const auto [component, vertex] = grid.element.system_to_component_index(i);
      const Point<3>& x = cell->vertex(vertex);
      if (component == 2) downwards += system->load[i];
      if (component < 2) moment += (component == 0 ? -x[1] : x[0]) * system->load[i];
    }
    ++system;
  }
  EXPECT_NEAR(dealii::Utilities::MPI::sum(moment, MPI_COMM_WORLD), -3. * 5., 1e-12) << "-J alpha";
  EXPECT_NEAR(dealii::Utilities::MPI::sum(downwards, MPI_COMM_WORLD), -2. * volume(grid), 1e-12);
}

TEST(ElasticityInSpace, LoadsSurfacesByPressureAgainstTheOutwardNormal) {
  const mesh::MeshData<3> mesh = sector();
  const Discretisation<3> grid(mesh, 2);
  Problem<3> problem = problem_on(mesh);
  for (const std::string& surface : mesh.surfaces) problem.loads.push_back({surface, 4., {}});
  const auto systems = all_systems(*grid.dof_handler, problem, mesh.surfaces);
  Tensor<1, 3> force;
  for (const CellSystem& system : systems)
    for (unsigned int i = 0; i < system.load.size(); ++i)
      force[grid.element.system_to_component_index(i).first] += system.load[i];
  EXPECT_NEAR(dealii::Utilities::MPI::sum(force, MPI_COMM_WORLD).norm(), 0., 1e-13)
      << "pressure on a closed surface is in equilibrium";
}

TEST(BoundaryInSpace, LooksOutwardsFromEveryFace) {
  const mesh::MeshData<3> mesh = sector();
  const Discretisation<3> grid(mesh, 1);
  const Boundary<3> boundary = gather_boundary(*grid.dof_handler, mesh.circles, 1.);
  double sum = 0.;  // divergence theorem: the integral of x n over the boundary is the volume
  Tensor<1, 3> normals;
  for (const BoundaryFace<3>& face : boundary.faces) {
    const auto at = [&](const std::size_t i) { return boundary.nodes[face.nodes[i]].position; };
    const Tensor<1, 3> area = 0.5 * dealii::cross_product_3d(at(2) - at(0), at(3) - at(1));
    const Point<3> middle((Tensor<1, 3>(at(0)) + at(1) + at(2) + at(3)) / 4.);
    sum += middle * area;
    normals += area;
  }
  EXPECT_NEAR(normals.norm(), 0., 1e-14);
  EXPECT_NEAR(sum / 3., volume(grid), 1e-3 * volume(grid)) << "faces are slightly twisted";
  EXPECT_EQ(boundary.faces.size(), 4U * (2U * 8U + 2U * 12U + 2U * 6U));
}

/// Deflection of the tip of a square cantilever along z, whose tip face is held rigidly.
double tip_deflection(const double length, const unsigned int refinements) {
  mesh::MeshData<2> plane = geneva::test::empty_mesh();
  geneva::test::add_rectangle(plane, "beam", equal_steps(0., 1., 2), equal_steps(0., 1., 2),
                              {"", "", "", ""});
  const mesh::MeshData<3> mesh = extruded(
      plane, {{equal_steps(0., length, static_cast<unsigned int>(2. * length)), "root", "tip"}});
  const Discretisation<3> grid(mesh, refinements);
  Problem<3> problem = problem_on(mesh);
  const Boundary<3> boundary = gather_boundary(*grid.dof_handler, mesh.circles, 1.);
  auto lines = support_lines<3>(boundary, {{"root", {0., 0., 0.}}}, mesh.surfaces);
  const TieLines tie = tie_lines<3>(boundary, {"tip", {0., 1., 0.}, 1e-3}, mesh.surfaces);
  lines.insert(lines.end(), tie.lines.begin(), tie.lines.end());
  dealii::IndexSet ghosts;
  dealii::DoFTools::extract_locally_relevant_dofs(*grid.dof_handler, ghosts);
  for (const BoundaryNode<3>& node : boundary.nodes)
    ghosts.add_indices(node.dofs.begin(), node.dofs.end());
  LinearSystem<3> system(
      *grid.dof_handler, ghosts, make_constraints(hanging_nodes(*grid.dof_handler, ghosts), lines),
      cell_systems(*grid.dof_handler, problem, mesh.surfaces), {{tie.master, tie.master_force}});
  system.set_up(*grid.dof_handler, Method::multigrid);
  Vector displacement(grid.dof_handler->locally_owned_dofs(), MPI_COMM_WORLD);
  system.solve(displacement, 1e-10, 0.);
  const bool is_owner = grid.dof_handler->locally_owned_dofs().is_element(tie.master);
  return dealii::Utilities::MPI::sum(is_owner ? displacement(tie.master) : 0., MPI_COMM_WORLD);
}

/// F l^3/(12 E I) + F l/(kappa G A): the tip moves without turning; kappa after Cowper 1966.
double timoshenko_deflection(const double length) {
  const double nu = steel.poissons_ratio;
  const double kappa = 10. * (1. + nu) / (12. + 11. * nu);
  return 1e-3 * (std::pow(length, 3) / steel.youngs_modulus +
                 length / (kappa * steel.youngs_modulus / (2. * (1. + nu))));
}

/// Of the limit of fine meshes from the beam.
double defect(const double length) {
  const double coarse = tip_deflection(length, 1);
  const double fine = tip_deflection(length, 2);
  EXPECT_LT(coarse, fine) << "elements of degree one are too stiff in bending";
  const double limit = fine + (fine - coarse) / 3.;  // second order
  return limit / timoshenko_deflection(length) - 1.;
}

TEST(CantileverInSpace, DeflectsLikeTimoshenkosBeam) {
  // Held ends cannot contract sideways, which stiffens a stretch of fixed length: the share of it
  // falls with the length.
  const double of_short = defect(6.);
  const double of_long = defect(12.);
  EXPECT_NEAR(of_short, 0., 0.03);
  EXPECT_NEAR(of_long, of_short / 2., 0.2 * std::abs(of_short));
}

}  // namespace
}  // namespace geneva::fem::test
