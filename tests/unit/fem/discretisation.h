#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fem/elasticity/cell_systems.h"
#include "mesh/triangulation.h"
#include "tests/support/structured_mesh.h"

namespace geneva::fem::test {

/// Elements of degree one on a small mesh, refined evenly; lengths as in the mesh.
template <int dim>
struct Discretisation {
  explicit Discretisation(const mesh::MeshData<dim>& mesh, const unsigned int refinements = 0)
      : triangulation(mesh::make_triangulation(MPI_COMM_WORLD, mesh, 1.)),
        element(dealii::FE_Q<dim>(1), dim) {
    triangulation->refine_global(refinements);
    dof_handler = std::make_unique<dealii::DoFHandler<dim>>(*triangulation);
    dof_handler->distribute_dofs(element);
  }

  std::unique_ptr<dealii::parallel::distributed::Triangulation<dim>> triangulation;
  dealii::FESystem<dim> element;
  std::unique_ptr<dealii::DoFHandler<dim>> dof_handler;
};

template <int dim>
using Field = std::function<dealii::Tensor<1, dim>(const dealii::Point<dim>&)>;

/// Values of a displacement field at a cell's degrees of freedom.
template <typename Cell, int dim = Cell::AccessorType::dimension>
dealii::Vector<double> values_on(const Cell& cell, const Field<dim>& field) {
  dealii::Vector<double> values(cell->get_fe().n_dofs_per_cell());
  for (unsigned int i = 0; i < values.size(); ++i) {
    const auto [component, vertex] = cell->get_fe().system_to_component_index(i);
    values[i] = field(cell->vertex(vertex))[component];
  }
  return values;
}

/// Every system of this rank, integrated.
template <int dim>
std::vector<CellSystem> all_systems(const dealii::DoFHandler<dim>& dof_handler,
                                    const Problem<dim>& problem,
                                    const std::vector<std::string>& surfaces) {
  const CellSystems cells = cell_systems(dof_handler, problem, surfaces);
  std::vector<CellSystem> systems;
  for (std::size_t i = 0; i < cells.size(); ++i) systems.push_back(cells[i]);
  return systems;
}

}  // namespace geneva::fem::test
