#include "fem/discretisation/hanging_vertices.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "discretisation.h"
#include "mesh/extrusion.h"

namespace geneva::fem {
namespace {

using test::Discretisation;

constexpr double pi = 3.14159265358979323846;

using Grading = std::optional<mesh::Grading>;

/// A pipe of radii 1 and 2 m, refined once everywhere and once more where x > 0 and z > 0.5.
Discretisation<3> half_refined_pipe(const Grading& grading = std::nullopt) {
  mesh::MeshData<2> ring = geneva::test::empty_mesh();
  geneva::test::add_ring(
      ring, "pipe",
      {{0., 0.}, {1., 2.}, geneva::test::equal_steps(0., 2. * pi, 8), "", "", "", ""});
  Discretisation<3> pipe(mesh::extruded(ring, {{{0., 1.}, "", ""}}, grading), 1);
  for (const auto& cell : pipe.triangulation->active_cell_iterators())
    if (cell->is_locally_owned() && cell->center()[0] > 0. && cell->center()[2] > 0.5)
      cell->set_refine_flag();
  pipe.triangulation->execute_coarsening_and_refinement();
  pipe.dof_handler->distribute_dofs(pipe.element);
  return pipe;
}

/// How far hanging nodes stand off the places that the nodes they hang on give them.
double maximum_gap(const Discretisation<3>& mesh) {
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(*mesh.dof_handler, relevant);
  dealii::AffineConstraints<double> constraints(relevant);
  dealii::DoFTools::make_hanging_node_constraints(*mesh.dof_handler, constraints);
  constraints.close();
  std::map<dealii::types::global_dof_index, double> place;
  for (const auto& cell : mesh.dof_handler->active_cell_iterators())
    if (!cell->is_artificial())
      for (const unsigned int vertex : cell->vertex_indices())
        for (unsigned int component = 0; component < 3; ++component)
          place[cell->vertex_dof_index(vertex, component)] = cell->vertex(vertex)[component];
  double gap = 0.;
  for (const auto& [dof, at] : place) {
    const auto* const entries = constraints.get_constraint_entries(dof);
    if (entries == nullptr) continue;
    double wanted = 0.;
    bool is_known = true;
    for (const auto& [master, share] : *entries) {
      is_known = is_known && place.count(master) > 0;
      if (is_known) wanted += share * place.at(master);
    }
    if (is_known) gap = std::max(gap, std::abs(wanted - at));
  }
  return dealii::Utilities::MPI::max(gap, MPI_COMM_WORLD);
}

std::vector<dealii::Point<3>> vertices_of(const Discretisation<3>& mesh) {
  std::vector<dealii::Point<3>> vertices;
  for (const auto& cell : mesh.triangulation->active_cell_iterators())
    for (const unsigned int i : cell->vertex_indices()) vertices.push_back(cell->vertex(i));
  return vertices;
}

TEST(HangingVertices, StandBesideOnCurvedSurfacesUntilTheGapsAreClosed) {
  for (const Grading& grading : {Grading(), Grading({1.})}) {
    const Discretisation<3> pipe = half_refined_pipe(grading);
    EXPECT_GT(maximum_gap(pipe), 0.01);
    close_gaps(*pipe.triangulation);
    EXPECT_LT(maximum_gap(pipe), 1e-14);
  }
}

TEST(HangingVertices, ArePutBackToTheDigit) {
  const Discretisation<3> pipe = half_refined_pipe();
  const auto before = vertices_of(pipe);
  const auto places = close_gaps(*pipe.triangulation);
  EXPECT_GT(dealii::Utilities::MPI::max(places.size(), MPI_COMM_WORLD), 0U);
  put_back(*pipe.triangulation, places);
  EXPECT_EQ(vertices_of(pipe), before);
}

}  // namespace
}  // namespace geneva::fem
