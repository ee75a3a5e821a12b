#include "fem/energy_error.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <utility>

#include "fem/elasticity/cell_element.h"

namespace geneva::fem {

namespace {

/// s : C^-1 : s of an isotropic material [Pa].
template <int dim>
double compliance_energy(const Stress<dim>& stress, const Material& material) {
  double trace = 0.;
  double square = 0.;
  if constexpr (dim == 2) {
    trace = dealii::trace(stress.in_plane) + stress.out_of_plane;
    square = stress.in_plane * stress.in_plane + stress.out_of_plane * stress.out_of_plane;
  } else {
    trace = dealii::trace(stress);
    square = stress * stress;
  }
  const double nu = material.poissons_ratio;
  return ((1. + nu) * square - nu * trace * trace) / material.youngs_modulus;
}

template <int dim>
Stress<dim> difference(Stress<dim> stress, const Stress<dim>& other) {
  if constexpr (dim == 2) {
    stress.in_plane -= other.in_plane;
    stress.out_of_plane -= other.out_of_plane;
  } else {
    stress -= other;
  }
  return stress;
}

/// Interpolated between the vertices of a cell of the stresses' dofs.
template <int dim, typename Cell>
Stress<dim> interpolated(const NodalStress<dim>& stress, const Cell& cell,
                         const ReferencePoint<dim>& point) {
  return assembled_stress<dim>([&](const unsigned int component) {
    double sum = 0.;
    for (const unsigned int vertex : cell->vertex_indices())
      sum += point.shapes[vertex] * stress.values(cell->vertex_dof_index(vertex, component));
    return sum;
  });
}

}  // namespace

template <int dim>
double energy_error(const dealii::DoFHandler<dim>& dof_handler, const Vector& displacement,
                    const Problem<dim>& problem, const NodalStress<dim>& stress) {
  const dealii::QGauss<dim> quadrature(2);
  const auto points = reference_points(quadrature);
  CellStresses<dim> evaluate(problem, quadrature);
  double of_error = 0.;
  double of_stress = 0.;
  auto stressed = stress.dof_handler->begin_active();
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    const auto here = stressed++;
    if (!cell->is_locally_owned()) continue;
    const Material& material = problem.bodies[cell->material_id()].material;
    const auto computed = evaluate(cell, displacement);
    for (std::size_t q = 0; q < points.size(); ++q) {
      const double measure = computed[q].measure * out_of_plane_measure(problem, computed[q].place);
      const Stress<dim> recovered = interpolated(stress, here, points[q]);
      of_stress += measure * compliance_energy<dim>(computed[q].stress, material);
      of_error += measure *
                  compliance_energy<dim>(difference<dim>(recovered, computed[q].stress), material);
    }
  }
  const MPI_Comm communicator = dof_handler.get_communicator();
  of_error = dealii::Utilities::MPI::sum(of_error, communicator);
  of_stress = dealii::Utilities::MPI::sum(of_stress, communicator);
  return of_stress > 0. ? of_error / of_stress : 0.;
}

template double energy_error(const dealii::DoFHandler<2>&, const Vector&, const Problem<2>&,
                             const NodalStress<2>&);
template double energy_error(const dealii::DoFHandler<3>&, const Vector&, const Problem<3>&,
                             const NodalStress<3>&);

}  // namespace geneva::fem
