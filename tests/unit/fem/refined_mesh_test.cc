#include "fem/discretisation/refined_mesh.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <gtest/gtest.h>

#include "mesh/extrusion.h"
#include "tests/support/structured_mesh.h"

namespace geneva::fem::test {
namespace {

using geneva::test::add_rectangle;
using geneva::test::equal_steps;

template <int dim>
mesh::MeshData<dim> square() {
  mesh::MeshData<2> mesh = geneva::test::empty_mesh();
  add_rectangle(mesh, "square", equal_steps(0., 1., 2), equal_steps(0., 1., 2), {"", "", "", ""});
  if constexpr (dim == 2)
    return mesh;
  else
    return mesh::extruded(mesh, {{{0., 1.}, "z", "z"}});
}

/// Nothing, with room for ghosts.
template <int dim>
Vector displacement_on(const dealii::DoFHandler<dim>& dof_handler) {
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  return {dof_handler.locally_owned_dofs(), relevant, dof_handler.get_communicator()};
}

/// Refines at the origin alone, more often than cells can be halved.
template <int dim>
void expect_to_stay_at_the_deepest_level() {
  RefinedMesh<dim> mesh(MPI_COMM_WORLD, square<dim>(), 1.);
  for (int pass = 0; pass < 32; ++pass) {
    for (const auto& cell : mesh.dof_handler->active_cell_iterators())
      if (cell->is_locally_owned() && cell->point_inside({})) cell->set_refine_flag();
    mesh.refine({displacement_on(*mesh.dof_handler), {}});
  }
  EXPECT_EQ(mesh.triangulation->n_global_levels(), deepest_level<dim> + 1U);
}

TEST(RefinedMesh, KeepsCellsOfTheDeepestLevelAsTheyAre) {
  expect_to_stay_at_the_deepest_level<2>();
  expect_to_stay_at_the_deepest_level<3>();
}

}  // namespace
}  // namespace geneva::fem::test
