#include "fem/stress_variation.h"

#include <algorithm>

#include "fem/elasticity/invariants.h"

namespace geneva::fem {

template <int dim>
double measured(const Vector& values,
                const typename dealii::DoFHandler<dim>::active_cell_iterator& cell,
                const unsigned int vertex, const Measure measure) {
  const auto principal =
      principal_stresses(assembled_stress<dim>([&](const unsigned int component) {
        return values(cell->vertex_dof_index(vertex, component));
      }));
  return measure == Measure::von_mises ? von_mises(principal) : principal[0];
}

template <int dim>
double maximum_von_mises(const NodalStress<dim>& stress,
                         const typename dealii::DoFHandler<dim>::active_cell_iterator& cell) {
  double maximum = 0.;
  for (const unsigned int vertex : cell->vertex_indices())
    maximum = std::max(maximum, measured<dim>(stress.values, cell, vertex, Measure::von_mises));
  return maximum;
}

template <int dim>
double variation(const NodalStress<dim>& stress,
                 const typename dealii::DoFHandler<dim>::active_cell_iterator& cell) {
  StressVector<dim> mean = StressVector<dim>::Zero();
  const auto at = [&](const unsigned int vertex) {
    StressVector<dim> here;
    for (unsigned int i = 0; i < n_stress_components<dim>; ++i)
      here[i] = stress.values(cell->vertex_dof_index(vertex, i));
    return here;
  };
  for (const unsigned int vertex : cell->vertex_indices()) mean += at(vertex) / (1 << dim);
  double maximum = 0.;
  for (const unsigned int vertex : cell->vertex_indices()) {
    const StressVector<dim> difference = at(vertex) - mean;
    maximum = std::max(maximum, von_mises(principal_stresses(assembled_stress<dim>(
                                    [&](const unsigned int i) { return difference[i]; }))));
  }
  return maximum;
}

#define INSTANTIATE(dim)                                                                           \
  template double measured<dim>(                                                                   \
      const Vector&, const dealii::DoFHandler<dim>::active_cell_iterator&, unsigned int, Measure); \
  template double maximum_von_mises(const NodalStress<dim>&,                                       \
                                    const dealii::DoFHandler<dim>::active_cell_iterator&);         \
  template double variation(const NodalStress<dim>&,                                               \
                            const dealii::DoFHandler<dim>::active_cell_iterator&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace geneva::fem
