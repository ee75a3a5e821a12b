#pragma once

#include "fem/stress_recovery.h"

namespace geneva::fem {

enum class Measure { von_mises, tensile };

/// A measure of a stress field at a cell's vertex [Pa].
/// @param values of the stress field, or of its doubt
template <int dim>
double measured(const Vector& values,
                const typename dealii::DoFHandler<dim>::active_cell_iterator& cell,
                unsigned int vertex, Measure measure);

/// The maximum von Mises stress at a cell's vertices [Pa].
template <int dim>
double maximum_von_mises(const NodalStress<dim>& stress,
                         const typename dealii::DoFHandler<dim>::active_cell_iterator& cell);

/// Maximum difference of the stresses at a cell's vertices from their mean, as a von Mises stress
/// [Pa].
template <int dim>
double variation(const NodalStress<dim>& stress,
                 const typename dealii::DoFHandler<dim>::active_cell_iterator& cell);

}  // namespace geneva::fem
