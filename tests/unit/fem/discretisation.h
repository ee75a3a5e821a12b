#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <functional>
#include <memory>
#include <vector>

#include "fem/elasticity.h"
#include "mesh/triangulation.h"
#include "tests/support/structured_mesh.h"

namespace geneva::fem::test {

/// Bilinear elements on a small mesh, refined evenly; lengths as in the mesh.
struct Discretisation {
  explicit Discretisation(const mesh::MeshData<2>& mesh, const unsigned int refinements = 0)
      : triangulation(mesh::make_triangulation(MPI_COMM_WORLD, mesh, 1.)),
        element(dealii::FE_Q<2>(1), 2) {
    triangulation->refine_global(refinements);
    dof_handler = std::make_unique<dealii::DoFHandler<2>>(*triangulation);
    dof_handler->distribute_dofs(element);
  }

  std::unique_ptr<dealii::parallel::distributed::Triangulation<2>> triangulation;
  dealii::FESystem<2> element;
  std::unique_ptr<dealii::DoFHandler<2>> dof_handler;
};

using Field = std::function<dealii::Tensor<1, 2>(const dealii::Point<2>&)>;

/// Values of a displacement field at a cell's degrees of freedom.
inline dealii::Vector<double> values_on(const dealii::DoFHandler<2>::active_cell_iterator& cell,
                                        const Field& field) {
  dealii::Vector<double> values(cell->get_fe().n_dofs_per_cell());
  for (unsigned int i = 0; i < values.size(); ++i) {
    const auto [component, vertex] = cell->get_fe().system_to_component_index(i);
    values[i] = field(cell->vertex(vertex))[component];
  }
  return values;
}

}  // namespace geneva::fem::test
