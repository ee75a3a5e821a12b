#pragma once

#include <deal.II/dofs/dof_handler.h>

#include "fem/discretisation/point_values.h"
#include "fem/discretisation/vector.h"
#include "fem/elasticity/material_law.h"

namespace geneva::fem {

/// What materials remember after an instant, at the Gauss points at which CellElement integrates.
/// @param laws by body
/// @param displacement at the end of the instant, with ghosts
/// @param before the same after the instant before; empty before the first
/// @return empty if no law remembers anything
template <int dim>
PointValues remembered(const dealii::DoFHandler<dim>& dof_handler, const Problem<dim>& problem,
                       const MaterialLaws<dim>& laws, const Vector& displacement,
                       const PointValues& before);

}  // namespace geneva::fem
