#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "mesh/extrusion.h"
#include "mesh/triangulation.h"
#include "tests/support/refusal.h"
#include "tests/support/structured_mesh.h"

namespace geneva::mesh {
namespace {

using geneva::test::equal_steps;
using loads::test::expect_refused;

constexpr double pi = 3.14159265358979323846;

/// A block of 3 x 1 m and, apart from it, a ring of radii 1 and 2 m around (5, 0).
MeshData<2> block_and_ring() {
  MeshData<2> mesh = geneva::test::empty_mesh();
  geneva::test::add_rectangle(mesh, "block", equal_steps(0., 3., 2), equal_steps(0., 1., 1),
                              {"bottom", "", "top", ""});
  geneva::test::add_ring(
      mesh, "ring", {{5., 0.}, {1., 2.}, equal_steps(0., 2. * pi, 8), "core", "mantle", "", ""});
  return mesh;
}

MeshData<3> drawn_out() {
  return extruded(block_and_ring(), {{{0., 0.5, 2.}, "foot", ""}, {{-1., 1., 2., 4.}, "", "head"}});
}

/// Area of the boundary by surface, over all ranks.
std::map<std::string, double> areas(
    const MeshData<3>& mesh, const dealii::parallel::distributed::Triangulation<3>& triangulation) {
  std::vector<double> sums(mesh.surfaces.size(), 0.);
  for (const auto& cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const auto& face : cell->face_iterators())
        if (face->at_boundary()) sums[face->boundary_id()] += face->measure();
  dealii::Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
  std::map<std::string, double> result;
  for (std::size_t i = 0; i < sums.size(); ++i) result[mesh.surfaces[i]] = sums[i];
  return result;
}

/// The surfaces of the ring, in units of half a metre.
void expect_on_cylinders(const MeshData<3>& mesh,
                         const dealii::parallel::distributed::Triangulation<3>& triangulation) {
  for (const auto& cell : triangulation.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary()) continue;
      const std::string& name = mesh.surfaces[face->boundary_id()];
      if (name != "core" && name != "mantle") continue;
      for (unsigned int vertex = 0; vertex < 4; ++vertex)
        EXPECT_NEAR(std::hypot(face->vertex(vertex)[0] - 10., face->vertex(vertex)[1]),
                    name == "core" ? 2. : 4., 1e-13);
    }
  }
}

TEST(ExtrudedMesh, HasALayerOfCellsBetweenNeighbouringPlanesOfEachBody) {
  const MeshData<3> mesh = drawn_out();
  EXPECT_EQ(mesh.cells.size(), 2U * 2U + 8U * 3U);
  EXPECT_EQ(mesh.vertices.size(), 6U * 3U + 16U * 4U);
  EXPECT_EQ(mesh.faces.size(), 2U * 2U + 6U * 2U + 2U * 8U + 16U * 3U);
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"block", "ring"}));
}

TEST(ExtrudedMesh, HasTheSurfacesOfThePlaneMeshAndItsEnds) {
  const MeshData<3> mesh = drawn_out();
  const auto triangulation = make_triangulation(MPI_COMM_WORLD, mesh, 1.);
  const auto area = areas(mesh, *triangulation);
  EXPECT_NEAR(area.at("bottom"), 3. * 2., 1e-13);
  EXPECT_NEAR(area.at("top"), 3. * 2., 1e-13);
  EXPECT_NEAR(area.at("foot"), 3. * 1., 1e-13);
  const double chord = 2. * std::sin(pi / 8.);
  EXPECT_NEAR(area.at("core"), 8. * chord * 5., 1e-12);
  EXPECT_NEAR(area.at("mantle"), 8. * 2. * chord * 5., 1e-12);
  EXPECT_NEAR(area.at("head"), 4. * std::sin(pi / 4.) * (4. - 1.), 1e-12);
  EXPECT_NEAR(area.at(""), 2. * 2. * 1. + 3. * 1. + area.at("head"), 1e-12);
  EXPECT_EQ(bodies_of(mesh, geneva::test::surface_id(block_and_ring(), "mantle")),
            std::set<unsigned int>{1U});
}

TEST(ExtrudedMesh, IsRefinedOnTheTrueCylinders) {
  const MeshData<3> mesh = drawn_out();
  const auto triangulation = make_triangulation(MPI_COMM_WORLD, mesh, 0.5);
  triangulation->refine_global(2);
  expect_on_cylinders(mesh, *triangulation);
  // a quarter of the angle's defect each time the edges are halved
  const double exact = (3. * 1. * 2. + pi * 3. * 5.) * 8.;
  const double defect = std::abs(dealii::GridTools::volume(*triangulation) / exact - 1.);
  EXPECT_LT(defect, 0.007);
  EXPECT_GT(defect, 0.004);
}

TEST(ExtrudedMesh, KeepsItsLayersGradedWhenItIsRefined) {
  const Grading grading{1., 0.3};
  const MeshData<3> mesh =
      extruded(block_and_ring(),
               {{{-1., graded(grading, 0.5), 1.}, "", ""}, {{-2., -1., 1.}, "", ""}}, grading);
  constexpr double unit = 0.5;
  const auto triangulation = make_triangulation(MPI_COMM_WORLD, mesh, unit);
  triangulation->refine_global(2);
  for (const auto& cell : triangulation->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const unsigned int i : cell->vertex_indices()) {
      const dealii::Point<3> vertex = cell->vertex(i) * unit;
      const double eighths = 8. * even(grading, vertex[2]);
      EXPECT_NEAR(eighths, std::round(eighths), 1e-12);
    }
  }
  expect_on_cylinders(mesh, *triangulation);
}

TEST(ExtrudedMesh, IsTheSameAfterItsWayBetweenTheRanks) {
  MeshData<3> mesh = drawn_out();
  EXPECT_FALSE(broadcast(MPI_COMM_WORLD, mesh).grading);
  mesh.grading = Grading{1.5, 0.25};
  const MeshData<3> sent = broadcast(MPI_COMM_WORLD, mesh);
  EXPECT_EQ(sent.vertices, mesh.vertices);
  EXPECT_EQ(sent.surfaces, mesh.surfaces);
  ASSERT_TRUE(sent.grading);
  EXPECT_EQ(sent.grading->half_length, 1.5);
  EXPECT_EQ(sent.grading->thickness_at_ends, 0.25);
  ASSERT_EQ(sent.cells.size(), mesh.cells.size());
  ASSERT_EQ(sent.faces.size(), mesh.faces.size());
  for (std::size_t i = 0; i < mesh.cells.size(); ++i)
    EXPECT_EQ(sent.cells[i].vertices, mesh.cells[i].vertices);
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    EXPECT_EQ(sent.faces[i].vertices, mesh.faces[i].vertices);
    EXPECT_EQ(sent.faces[i].circle, mesh.faces[i].circle);
  }
}

TEST(ExtrudedMesh, IsRefusedWithoutAscendingPlanesForEachBody) {
  const Extrusion good{{0., 1.}, "", ""};
  expect_refused([&] { extruded(block_and_ring(), {good}); }, {"1 bodies are given", "has 2"});
  for (const std::vector<double>& planes :
       {std::vector<double>{0.}, {0., 0.}, {0., 1., 0.5}, {0., std::nan("")}})
    expect_refused(
        [&] {
          extruded(block_and_ring(), {good, {planes, "", ""}});
        },
        {"body 'ring'", "each above the one before"});
}

}  // namespace
}  // namespace geneva::mesh
